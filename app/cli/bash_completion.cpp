#include "app/cli/command_pages.h"
#include "core/base/text.h"
#include "core/reflectance/catalogue.h"

#include <CLI/CLI.hpp>

namespace reflectance::cli {
namespace {

/// "TEXT:{auto,gl,cpu}" gives "auto gl cpu"; models are named by the catalogue.
std::string choicesOf(const CLI::Option& option)
{
    std::string choices;
    if (option.get_name() == "--model") {
        for (const Model& model : catalogue())
            choices += (choices.empty() ? "" : " ") + model.id();
        return choices;
    }
    const std::string type = option.get_type_name();
    const std::size_t open = type.find('{'), close = type.rfind('}');
    if (open == std::string::npos || close == std::string::npos)
        return choices;
    for (const std::string_view word : split(std::string_view(type).substr(open + 1, close - open - 1), ','))
        choices += (choices.empty() ? "" : " ") + std::string(trimmed(word));
    return choices;
}

/// One case of the script for every verb, "table info" for instance: its flags and the verbs below it.
void appendVerb(const CLI::App& app, const std::string& name, std::string& words, std::string& values)
{
    std::string known;
    for (const CLI::App* below : app.get_subcommands({}))
        known += below->get_name() + " ";
    for (const CLI::Option* option : app.get_options()) {
        if (option->get_positional())
            continue;
        const std::string flag = option->get_name();
        known += flag + " ";
        if (option->get_items_expected_max() > 0)
            values += "        '" + name + "|" + flag + "') REPLY_WORDS='" + choicesOf(*option) + "' ;;\n";
    }
    words += "        '" + name + "') REPLY_WORDS='" + known + "' ;;\n";
    for (const CLI::App* below : app.get_subcommands({}))
        appendVerb(*below, name.empty() ? below->get_name() : name + " " + below->get_name(), words, values);
}

std::string verbNames(const CLI::App& app)
{
    std::string names;
    for (const CLI::App* below : app.get_subcommands({}))
        names += (names.empty() ? "" : "|") + below->get_name() +
                 (below->get_subcommands({}).empty() ? "" : "|" + verbNames(*below));
    return names;
}

} // namespace

std::string bashCompletion(const CLI::App& program)
{
    std::string words, values;
    appendVerb(program, "", words, values);
    return "# bash completion of reflectance; made from the program's tables of options.\n"
           "_reflectance()\n{\n"
           "    local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]} verb= REPLY_WORDS= word\n"
           "    for word in \"${COMP_WORDS[@]:1:COMP_CWORD-1}\"; do\n"
           "        case $word in\n"
           "        " +
           verbNames(program) +
           ") verb=\"${verb:+$verb }$word\" ;;\n        *) break ;;\n        esac\n    done\n"
           "    COMPREPLY=()\n"
           "    case \"$verb|$previous\" in\n" +
           values + "        *)\n    case \"$verb\" in\n" + words +
           "    esac\n"
           "        if [[ $current != -* && -n $verb && $REPLY_WORDS == -* ]]; then REPLY_WORDS=; fi ;;\n"
           "    esac\n"
           "    COMPREPLY=($(compgen -W \"$REPLY_WORDS\" -- \"$current\"))\n"
           "    # Without a word to offer, bash completes the names of files.\n"
           "}\n"
           "complete -o default -F _reflectance reflectance\n";
}

} // namespace reflectance::cli
