#include "core/reflectance/walked/parser.h"

#include <algorithm>
#include <array>

namespace reflectance::walked {
namespace {

struct Operator {
    std::string_view text;
    Op op;
};

/// From the loosest to the tightest.
constexpr std::array<std::array<Operator, 4>, 6> levels{{
    {{{"||", Op::Or}}},
    {{{"&&", Op::And}}},
    {{{"==", Op::Equal}, {"!=", Op::NotEqual}}},
    {{{"<", Op::Less}, {"<=", Op::LessEqual}, {">", Op::Greater}, {">=", Op::GreaterEqual}}},
    {{{"+", Op::Add}, {"-", Op::Subtract}}},
    {{{"*", Op::Multiply}, {"/", Op::Divide}}},
}};

/// What `a op b` gives; nothing where the shared texts do not know it.
std::optional<Type> resultOf(Op op, Type a, Type b)
{
    const bool same = a == b;
    switch (op) {
    case Op::And:
    case Op::Or:
        return same && a == Type::Bool ? std::optional(Type::Bool) : std::nullopt;
    case Op::Equal:
    case Op::NotEqual:
    case Op::Less:
    case Op::LessEqual:
    case Op::Greater:
    case Op::GreaterEqual:
        return same && (a == Type::Float || a == Type::Int) ? std::optional(Type::Bool) : std::nullopt;
    case Op::Add:
    case Op::Subtract:
        return same && a != Type::Bool && a != Type::Mat3 ? std::optional(a) : std::nullopt;
    case Op::Multiply:
        if ((a == Type::Mat3 || a == Type::Float) && b == Type::Vec3)
            return Type::Vec3;
        [[fallthrough]];
    case Op::Divide:
        if (a == Type::Vec3 && b == Type::Float)
            return Type::Vec3;
        return same && a != Type::Bool && a != Type::Mat3 ? std::optional(a) : std::nullopt;
    default:
        return std::nullopt;
    }
}

} // namespace

std::optional<NodeId> Parser::add(Node node)
{
    const auto below = [&](NodeId id) { node.depth = std::max(node.depth, tree_.nodes[id].depth + 1); };
    if (node.op >= Op::Element && node.op != Op::Call && node.op != Op::Builtin)
        below(node.a);
    if (node.op >= Op::Add)
        below(node.b);
    if (node.op == Op::Choose)
        below(node.c);
    for (const NodeId argument : node.arguments)
        below(argument);
    if (node.op == Op::Call)
        node.depth = std::max(node.depth, tree_.functions[node.slot].depth + 1);
    if (node.depth > deepest) {
        fail("the expression nests too deeply; split it into several lines");
        return std::nullopt;
    }
    tree_.nodes.push_back(std::move(node));
    return static_cast<NodeId>(tree_.nodes.size() - 1);
}

std::optional<NodeId> Parser::typed(Type wanted)
{
    const auto value = readExpression();
    if (value && tree_.at(*value).type != wanted) {
        fail("a " + std::string(nameOf(wanted)) + " is needed here, and this is a " +
             std::string(nameOf(tree_.at(*value).type)) +
             (wanted == Type::Float && tree_.at(*value).type == Type::Int ? "; write numbers with a point" : ""));
        return std::nullopt;
    }
    return value;
}

std::optional<NodeId> Parser::readExpression()
{
    if (!nest())
        return std::nullopt;
    const auto condition = readLevel(0);
    if (!condition || !take("?")) {
        --nesting_;
        return condition;
    }
    const auto yes = readExpression();
    if (!yes || !expect(":"))
        return std::nullopt;
    const auto no = readExpression();
    if (!no)
        return std::nullopt;
    --nesting_;
    if (tree_.at(*condition).type != Type::Bool || tree_.at(*yes).type != tree_.at(*no).type) {
        fail("CONDITION ? A : B needs a condition, and A and B of one type");
        return std::nullopt;
    }
    Node node;
    node.op = Op::Choose;
    node.type = tree_.at(*yes).type;
    node.a = *condition;
    node.b = *yes;
    node.c = *no;
    node.begin = tree_.at(*condition).begin;
    node.end = tree_.at(*no).end;
    return add(std::move(node));
}

std::optional<NodeId> Parser::readLevel(std::size_t level)
{
    if (level == levels.size())
        return readUnary();
    auto left = readLevel(level + 1);
    while (left) {
        const auto found = std::ranges::find_if(
            levels[level], [&](const Operator& known) { return !known.text.empty() && sees(known.text); });
        if (found == levels[level].end())
            return left;
        ++at_;
        const auto right = readLevel(level + 1);
        if (!right)
            return std::nullopt;
        left = binary(found->op, *left, *right);
    }
    return left;
}

std::optional<NodeId> Parser::binary(Op op, NodeId a, NodeId b)
{
    const Type left = tree_.at(a).type, right = tree_.at(b).type;
    const auto type = resultOf(op, left, right);
    if (!type) {
        fail("a " + std::string(nameOf(left)) + " and a " + std::string(nameOf(right)) +
             " do not go together here; write numbers with a point, and vec3(x) for a number in every channel");
        return std::nullopt;
    }
    Node node;
    node.op = op;
    node.type = *type;
    node.a = a;
    node.b = b;
    node.begin = tree_.at(a).begin;
    node.end = tree_.at(b).end;
    return add(std::move(node));
}

std::optional<NodeId> Parser::readUnary()
{
    const std::size_t begin = token().begin;
    const bool minus = sees("-");
    if (!minus && !sees("!")) {
        take("+");
        return readPostfix();
    }
    ++at_;
    if (!nest())
        return std::nullopt;
    const auto of = readUnary();
    --nesting_;
    if (!of)
        return std::nullopt;
    const Type type = tree_.at(*of).type;
    if (minus ? type == Type::Bool || type == Type::Mat3 : type != Type::Bool) {
        fail(std::string(minus ? "-" : "!") + " does not go with a " + std::string(nameOf(type)));
        return std::nullopt;
    }
    Node node;
    node.op = minus ? Op::Negate : Op::Not;
    node.type = type;
    node.a = *of;
    node.begin = begin;
    node.end = tree_.at(*of).end;
    return add(std::move(node));
}

std::optional<NodeId> Parser::readPostfix()
{
    auto value = readPrimary();
    while (value && take(".")) {
        const Token& name = token();
        ++at_;
        value = component(*value, name);
    }
    return value;
}

std::optional<NodeId> Parser::component(NodeId of, const Token& name)
{
    const std::size_t which = std::string_view("xyzrgb").find(name.text);
    if (tree_.at(of).type != Type::Vec3 || name.text.size() != 1 || which == std::string_view::npos) {
        fail("components are .x, .y and .z of a vec3; swizzles are not known in C++");
        return std::nullopt;
    }
    Node node;
    node.op = Op::Component;
    node.type = Type::Float;
    node.a = of;
    node.slot = static_cast<std::uint32_t>(which % 3);
    node.begin = tree_.at(of).begin;
    node.end = name.begin + name.text.size();
    return add(std::move(node));
}

std::optional<NodeId> Parser::readPrimary()
{
    const Token here = token();
    if (here.kind == Token::Kind::Number || here.kind == Token::Kind::Whole) {
        ++at_;
        Node node;
        node.type = here.kind == Token::Kind::Whole ? Type::Int : Type::Float;
        node.number = here.number;
        node.begin = here.begin;
        node.end = here.begin + here.text.size();
        return add(std::move(node));
    }
    if (take("(")) {
        const auto value = readExpression();
        if (!value || !expect(")"))
            return std::nullopt;
        // The brackets belong to what they hold, so that a part of a source can be taken out.
        tree_.nodes[*value].begin = here.begin;
        tree_.nodes[*value].end = tokens_[at_ - 1].begin + 1;
        return value;
    }
    if (here.kind != Token::Kind::Word) {
        fail("a value is missing before '" + std::string(here.text) + "'");
        return std::nullopt;
    }
    ++at_;
    if (here.text == "true" || here.text == "false") {
        Node node;
        node.type = Type::Bool;
        node.number = here.text == "true" ? 1.0 : 0.0;
        node.begin = here.begin;
        node.end = here.begin + here.text.size();
        return add(std::move(node));
    }
    return sees("(") ? readCall(here) : readVariable(here);
}

std::optional<NodeId> Parser::readVariable(const Token& name)
{
    const Name* found = find(name.text);
    if (!found) {
        fail("'" + std::string(name.text) + "' is not known here; declare it above");
        return std::nullopt;
    }
    Node node;
    node.op = Op::Variable;
    node.type = found->type;
    node.slot = found->slot;
    node.begin = name.begin;
    node.end = name.begin + name.text.size();
    if (found->array > 0) {
        node.op = Op::Element;
        node.count = found->array;
        if (!expect("["))
            return std::nullopt;
        const auto index = typed(Type::Int);
        if (!index || !expect("]"))
            return std::nullopt;
        node.a = *index;
        node.end = tokens_[at_ - 1].begin + 1;
    }
    return add(std::move(node));
}

std::optional<NodeId> Parser::readCall(const Token& name)
{
    ++at_;
    std::vector<NodeId> arguments;
    while (!sees(")")) {
        if (!arguments.empty() && !expect(","))
            return std::nullopt;
        const auto argument = readExpression();
        if (!argument)
            return std::nullopt;
        arguments.push_back(*argument);
    }
    if (!expect(")"))
        return std::nullopt;
    return callOf(name, std::move(arguments));
}

std::optional<NodeId> Parser::callOf(const Token& name, std::vector<NodeId> arguments)
{
    std::vector<Type> types;
    for (const NodeId argument : arguments)
        types.push_back(tree_.at(argument).type);
    Node node;
    node.begin = name.begin;
    node.end = tokens_[at_ - 1].begin + 1;
    node.arguments = std::move(arguments);
    bool known = false;
    for (std::size_t i = 0; i < tree_.functions.size(); ++i) {
        known = known || tree_.functions[i].name == name.text;
        if (tree_.functions[i].name == name.text && tree_.functions[i].parameters == types) {
            node.op = Op::Call;
            node.slot = static_cast<std::uint32_t>(i);
            node.type = tree_.functions[i].result;
            return add(std::move(node));
        }
    }
    for (std::size_t i = 0; i < builtins().size(); ++i) {
        const Builtin& built = builtins()[i];
        known = known || built.name == name.text;
        if (built.name == name.text && std::ranges::equal(built.parameters, types)) {
            node.op = Op::Builtin;
            node.slot = static_cast<std::uint32_t>(i);
            node.type = built.result;
            return add(std::move(node));
        }
    }
    std::string list;
    for (const Type type : types)
        list += (list.empty() ? "" : ", ") + std::string(nameOf(type));
    const std::string call = std::string(name.text) + "(" + list + ")";
    fail(known ? call + " does not exist with these types; write numbers with a point"
               : "the function " + call + " is not known; define it above, or use those of shaders/prelude.glsl");
    return std::nullopt;
}

} // namespace reflectance::walked
