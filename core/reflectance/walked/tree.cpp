#include "core/reflectance/walked/tree.h"

#include "core/reflectance/walked/parser.h"

#include <algorithm>

namespace reflectance::walked {
namespace {

constexpr std::uint32_t mostMemory = 1 << 16;

Type typeOf(ParameterKind kind)
{
    constexpr Type types[] = {Type::Float, Type::Vec3, Type::Mat3, Type::Int, Type::Float};
    return types[static_cast<std::size_t>(kind)];
}

bool endsWithReturn(const std::vector<Statement>& body)
{
    if (body.empty())
        return false;
    const Statement& last = body.back();
    return last.kind == Statement::Kind::Return ||
           (last.kind == Statement::Kind::If && endsWithReturn(last.body) && endsWithReturn(last.otherwise));
}

} // namespace

std::string_view nameOf(Type type)
{
    constexpr std::string_view names[] = {"float", "vec3", "mat3", "int", "bool"};
    return names[static_cast<std::size_t>(type)];
}

std::size_t sizeOf(Type type)
{
    constexpr std::size_t sizes[] = {1, 3, 9, 1, 1};
    return sizes[static_cast<std::size_t>(type)];
}

bool Parser::fail(std::string problem)
{
    if (problem_.empty()) { // the first is the cause
        problem_ = std::move(problem);
        problemLine_ = token().line;
    }
    return false;
}

bool Parser::take(std::string_view text)
{
    if (!sees(text))
        return false;
    ++at_;
    return true;
}

bool Parser::expect(std::string_view text)
{
    if (take(text))
        return true;
    const std::string found =
        token().kind == Token::Kind::End ? "the end of the text" : "'" + std::string(token().text) + "'";
    return fail("'" + std::string(text) + "' is missing before " + found);
}

std::optional<Type> Parser::takeType()
{
    for (const Type type : {Type::Float, Type::Vec3, Type::Mat3, Type::Int, Type::Bool})
        if (take(nameOf(type)))
            return type;
    fail("a type is missing: float, vec3, mat3, int or bool");
    return std::nullopt;
}

std::optional<std::string_view> Parser::takeName()
{
    if (token().kind != Token::Kind::Word) {
        fail("a name is missing");
        return std::nullopt;
    }
    return tokens_[at_++].text;
}

const Name* Parser::find(std::string_view name) const
{
    const auto found = std::find_if(names_.rbegin(), names_.rend(), [&](const Name& n) { return n.name == name; });
    return found == names_.rend() ? nullptr : &*found;
}

const Name* Parser::declare(std::string_view name, Type type, std::uint32_t array, bool fixed)
{
    const auto scope = names_.begin() + static_cast<std::ptrdiff_t>(scope_);
    if (std::find_if(scope, names_.end(), [&](const Name& n) { return n.name == name; }) != names_.end()) {
        fail("'" + std::string(name) + "' is declared twice");
        return nullptr;
    }
    const std::size_t numbers = sizeOf(type) * std::max<std::size_t>(array, 1);
    if (tree_.memory + numbers > mostMemory) {
        fail("the text has more numbers in variables than 65536");
        return nullptr;
    }
    names_.push_back({name, type, room(numbers), array, fixed});
    return &names_.back();
}

std::uint32_t Parser::room(std::size_t numbers)
{
    const std::uint32_t slot = tree_.memory;
    tree_.memory += static_cast<std::uint32_t>(numbers);
    return slot;
}

void Parser::declareUniforms()
{
    for (const Parameter& parameter : text_.parameters)
        declare(parameter.name, typeOf(parameter.kind),
                parameter.kind == ParameterKind::List ? static_cast<std::uint32_t>(parameter.size) : 0, true);
    tree_.uniformNumbers = tree_.memory;
}

bool Parser::readParameters(Function& function)
{
    while (!sees(")")) {
        if (!function.parameters.empty() && !expect(","))
            return false;
        take("in");
        const auto type = takeType();
        if (!type)
            return false;
        const auto name = takeName();
        if (!name)
            return fail("every function names all its parameters");
        const Name* declared = declare(*name, *type, 0, false);
        if (!declared)
            return false;
        function.parameters.push_back(*type);
        function.slots.push_back(declared->slot);
    }
    return expect(")");
}

bool Parser::readFunction(Type result, std::string_view name)
{
    for (const Builtin& built : builtins())
        if (built.name == name)
            return fail("'" + std::string(name) + "' is a name of the prelude; choose another");
    Function function;
    function.name = name;
    function.result = result;
    const std::size_t before = names_.size();
    scope_ = before;
    if (!readParameters(function) || !expect("{"))
        return false;
    for (const Function& known : tree_.functions)
        if (known.name == name && known.parameters == function.parameters)
            return fail("the function " + std::string(name) + " is defined twice");
    function.resultSlot = room(sizeOf(result));
    returns_ = result;
    if (!readBlock(function.body))
        return false;
    if (!endsWithReturn(function.body))
        return fail("the function " + std::string(name) + " must end with a return");
    returns_.reset();
    for (const Statement& statement : function.body)
        function.depth = std::max(function.depth, statement.depth + 1);
    names_.resize(before);
    scope_ = 0;
    tree_.functions.push_back(std::move(function));
    return true;
}

bool Parser::readTop()
{
    if (take(";"))
        return true;
    if (sees("const")) {
        ++at_;
        return readDeclaration(tree_.constants, true);
    }
    const auto type = takeType();
    if (!type)
        return false;
    const auto name = takeName();
    if (!name)
        return false;
    if (!take("("))
        return fail("outside of functions stand uniforms, const values and functions only");
    return readFunction(*type, *name);
}

bool Parser::findEntryPoints()
{
    using enum Type;
    for (std::size_t i = 0; i < tree_.functions.size(); ++i) {
        const Function& f = tree_.functions[i];
        if (f.name == "shade" && f.result == Vec3 && f.parameters == std::vector{Vec3, Vec3, Vec3, Vec3})
            tree_.shade = static_cast<int>(i);
        if (f.name == "shadeEnvironment" && f.result == Vec3 && f.parameters == std::vector{Vec3, Vec3})
            tree_.shadeEnvironment = static_cast<int>(i);
    }
    return tree_.shade >= 0 || fail("the text defines no vec3 shade(vec3 N, vec3 L, vec3 V, vec3 I)");
}

Result<Tree> Parser::run()
{
    tree_.code = text_.code;
    tree_.nodes.emplace_back(); // node 0 stands for "none"
    declareUniforms();
    while (problem_.empty() && token().kind != Token::Kind::End)
        readTop();
    if (problem_.empty())
        findEntryPoints();
    if (!problem_.empty())
        return Error{problem_, text_.file, problemLine_};
    return std::move(tree_);
}

Result<Tree> treeOf(const ModelText& text)
{
    auto tokens = tokensOf(text.code);
    if (!tokens)
        return Error{tokens.error().message, text.file, tokens.error().line};
    return Parser(text, *std::move(tokens)).run();
}

} // namespace reflectance::walked
