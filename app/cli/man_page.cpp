#include "app/cli/command_pages.h"

#include <CLI/CLI.hpp>

namespace reflectance::cli {
namespace {

/// Text as troff prints it: no hyphen becomes a dash, no line begins with a command.
std::string troff(const std::string& text)
{
    std::string escaped;
    for (const char c : text)
        if (c == '\\')
            escaped += "\\e";
        else if (c == '-')
            escaped += "\\-";
        else if ((c == '.' || c == '\'') && (escaped.empty() || escaped.back() == '\n'))
            escaped += std::string("\\&") + c;
        else
            escaped += c;
    return escaped;
}

/// What --help says after the name, without the blank it begins with: the kind of value, its choices, its default.
std::string valueOf(const CLI::Option& option)
{
    if (option.get_items_expected_max() == 0)
        return "";
    std::string text = " \\fI" + troff(option.get_type_name()) + "\\fR";
    if (!option.get_default_str().empty())
        text += " [" + troff(option.get_default_str()) + "]";
    return text;
}

void appendOption(const CLI::Option& option, std::string& page)
{
    page += ".TP\n\\fB" + troff(option.get_name(option.get_positional(), true)) + "\\fR" + valueOf(option) + "\n" +
            troff(option.get_description()) + (option.get_required() ? " (required)\n" : "\n");
}

std::string fullName(const CLI::App& app)
{
    return app.get_parent() == nullptr ? app.get_name() : fullName(*app.get_parent()) + " " + app.get_name();
}

void appendVerb(const CLI::App& verb, std::string& page)
{
    page += ".SS " + troff(fullName(verb)) + "\n" + troff(verb.get_description()) + "\n";
    for (const CLI::Option* option : verb.get_options())
        if (option->get_name() != "--help")
            appendOption(*option, page);
    for (const CLI::App* below : verb.get_subcommands({}))
        appendVerb(*below, page);
}

constexpr const char* ending = R"(.SH EXIT STATUS
.TP
.B 0
done
.TP
.B 1
a comparison or a check did not hold
.TP
.B 2
bad usage or bad input; one sentence on standard error says what and where
.TP
.B 130
stopped by Ctrl\-C
)";

} // namespace

std::string manPage(const CLI::App& program, const std::string& version)
{
    std::string page =
        ".TH REFLECTANCE 1 \"\" \"reflectance " + troff(version) +
        "\" \"User Commands\"\n.SH NAME\nreflectance \\- understand, compare and trust reflectance models\n"
        ".SH SYNOPSIS\n.B reflectance\n[\\fIinput\\fR]\n.br\n.B reflectance\n\\fIverb\\fR [\\fIoptions\\fR]\n"
        ".SH DESCRIPTION\n" +
        troff(program.get_description()) + "\n.SH OPTIONS\n";
    for (const CLI::Option* option : program.get_options())
        appendOption(*option, page);
    page += ".SH VERBS\n";
    for (const CLI::App* verb : program.get_subcommands({}))
        appendVerb(*verb, page);
    return page + ending;
}

} // namespace reflectance::cli
