#include "core/reflectance/walked/parser.h"

#include <algorithm>

namespace reflectance::walked {
namespace {

int deepestOf(const std::vector<Statement>& statements)
{
    int depth = 0;
    for (const Statement& statement : statements)
        depth = std::max(depth, statement.depth);
    return depth;
}

} // namespace

bool Parser::nest()
{
    return ++nesting_ <= deepest || fail("the text nests too deeply; split it into several lines");
}

bool Parser::keep(Statement statement, std::vector<Statement>& into)
{
    const int inside =
        std::max({tree_.nodes[statement.value].depth, deepestOf(statement.body), deepestOf(statement.otherwise)});
    statement.depth = inside + 1;
    if (statement.depth > deepest)
        return fail("the text nests too deeply; split it into several lines");
    into.push_back(std::move(statement));
    return true;
}

bool Parser::readBlock(std::vector<Statement>& into)
{
    const std::size_t before = names_.size(), outer = scope_;
    scope_ = before;
    while (!sees("}"))
        if (!readStatement(into))
            return false;
    names_.resize(before);
    scope_ = outer;
    return expect("}");
}

bool Parser::readBody(std::vector<Statement>& into)
{
    if (!nest())
        return false;
    const bool read = take("{") ? readBlock(into) : readStatement(into);
    --nesting_;
    return read;
}

bool Parser::readStatement(std::vector<Statement>& into)
{
    if (token().kind == Token::Kind::End)
        return fail("the text ends within a function; close it with }");
    if (take("{"))
        return nest() && readBlock(into) && (--nesting_, true);
    if (take(";"))
        return true;
    if (take("return"))
        return readReturn(into);
    if (take("if"))
        return readIf(into);
    if (take("for"))
        return readLoop(into);
    const bool fixed = take("const");
    static constexpr std::string_view types[] = {"float", "vec3", "mat3", "int", "bool"};
    const bool declares =
        std::ranges::find(types, token().text) != std::end(types) && token(1).kind == Token::Kind::Word;
    if (declares)
        return readDeclaration(into, fixed);
    Statement statement;
    return readAssignment(statement) && expect(";") && keep(std::move(statement), into);
}

/// "float a = 1.0, b = 2.0;" or "vec3 P[5];"
bool Parser::readDeclaration(std::vector<Statement>& into, bool fixed)
{
    const auto type = takeType();
    if (!type)
        return false;
    do {
        Statement statement;
        statement.line = token().line;
        const auto name = takeName();
        if (!name)
            return false;
        std::uint32_t array = 0;
        if (take("[")) {
            if (token().kind != Token::Kind::Whole || token().number < 1.0 || token().number > 4096.0)
                return fail("an array has a constant size from 1 to 4096");
            array = static_cast<std::uint32_t>(token().number);
            ++at_;
            if (!expect("]") || !declare(*name, *type, array, fixed))
                return false;
            continue;
        }
        // The value cannot see the name that it is given.
        std::optional<NodeId> value;
        if (take("=")) {
            value = typed(*type);
            if (!value)
                return false;
        } else if (fixed) {
            return fail("a constant needs its value");
        }
        const Name* declared = declare(*name, *type, 0, fixed);
        if (!declared)
            return false;
        if (!value)
            continue;
        statement.type = *type;
        statement.slot = declared->slot;
        statement.value = *value;
        statement.name = *name;
        if (!keep(std::move(statement), into))
            return false;
    } while (take(","));
    return expect(";");
}

bool Parser::readIf(std::vector<Statement>& into)
{
    Statement statement;
    statement.kind = Statement::Kind::If;
    statement.line = token().line;
    if (!expect("("))
        return false;
    const auto condition = typed(Type::Bool);
    if (!condition || !expect(")"))
        return false;
    statement.value = *condition;
    if (!readBody(statement.body))
        return false;
    if (take("else") && !readBody(statement.otherwise))
        return false;
    return keep(std::move(statement), into);
}

/// "for (int i = 0; i < count; ++i) ..."
bool Parser::readLoop(std::vector<Statement>& into)
{
    const std::size_t before = names_.size(), outer = scope_;
    scope_ = before;
    Statement loop;
    loop.kind = Statement::Kind::Loop;
    loop.line = token().line;
    if (!expect("(") || !sees("int"))
        return fail("write loops as for (int i = 0; i < COUNT; ++i)");
    if (!readDeclaration(into, false) || names_.size() != before + 1)
        return fail("a loop counts with one int");
    const auto condition = typed(Type::Bool);
    if (!condition || !expect(";"))
        return false;
    loop.value = *condition;
    Statement step;
    if (!readAssignment(step) || !keep(std::move(step), loop.step) || !expect(")"))
        return false;
    names_[before].fixed = true;
    if (!readBody(loop.body))
        return false;
    names_.resize(before);
    scope_ = outer;
    return keep(std::move(loop), into);
}

bool Parser::readReturn(std::vector<Statement>& into)
{
    if (!returns_)
        return fail("return stands outside of a function");
    Statement statement;
    statement.kind = Statement::Kind::Return;
    statement.line = token().line;
    const auto value = typed(*returns_);
    if (!value || !expect(";"))
        return false;
    statement.type = *returns_;
    statement.value = *value;
    return keep(std::move(statement), into);
}

/// What is assigned, and its value so far.
bool Parser::readTarget(Statement& statement, std::optional<NodeId>& current)
{
    const Token name = token();
    const Name* found = name.kind == Token::Kind::Word ? find(name.text) : nullptr;
    if (!found)
        return fail("a statement is an assignment, a declaration, if, for or return; '" + std::string(name.text) +
                    "' is none of a known name");
    if (found->fixed)
        return fail("'" + std::string(name.text) + "' cannot be changed");
    statement.line = name.line;
    statement.slot = found->slot;
    statement.name = name.text;
    current = readPostfix();
    if (!current)
        return false;
    const Node& target = tree_.at(*current);
    statement.type = target.type;
    if (target.op == Op::Component && tree_.at(target.a).op == Op::Variable) {
        statement.slot += target.slot;
        statement.name += "." + std::string(1, "xyz"[target.slot]);
    } else if (target.op == Op::Element) {
        statement.kind = Statement::Kind::AssignElement;
        statement.count = target.count;
        statement.index = target.a;
    } else if (target.op != Op::Variable) {
        return fail("only a variable, its component or an array's element can be assigned");
    }
    return true;
}

/// "x = 1.0", "x += y", "++i", "i++", without the semicolon.
bool Parser::readAssignment(Statement& statement)
{
    const bool before = sees("++") || sees("--");
    bool up = sees("++");
    if (before)
        ++at_;
    std::optional<NodeId> current;
    if (!readTarget(statement, current))
        return false;
    if (before || sees("++") || sees("--")) {
        if (!before) {
            up = sees("++");
            ++at_;
        }
        Node one;
        one.type = tree_.at(*current).type;
        one.number = 1.0;
        one.begin = one.end = tree_.at(*current).end;
        const auto step = add(std::move(one));
        const auto value = step ? binary(up ? Op::Add : Op::Subtract, *current, *step) : std::nullopt;
        statement.value = value.value_or(0);
        return value.has_value();
    }
    const Token sign = token();
    ++at_;
    if (sign.text == "=") {
        const auto value = typed(statement.type);
        statement.value = value.value_or(0);
        return value.has_value();
    }
    static constexpr std::string_view compound[] = {"+=", "-=", "*=", "/="};
    const auto* const found = std::ranges::find(compound, sign.text);
    if (found == std::end(compound))
        return fail("= is missing after '" + statement.name + "'");
    const auto right = readExpression();
    const auto value =
        right ? binary(static_cast<Op>(static_cast<int>(Op::Add) + (found - std::begin(compound))), *current, *right)
              : std::nullopt;
    if (value && tree_.at(*value).type != statement.type)
        return fail("'" + statement.name + "' is a " + std::string(nameOf(statement.type)));
    statement.value = value.value_or(0);
    return value.has_value();
}

} // namespace reflectance::walked
