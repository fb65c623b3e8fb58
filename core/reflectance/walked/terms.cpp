#include "core/reflectance/walked/terms.h"

#include "core/base/check.h"
#include "core/reflectance/walked/builtins.h"

#include <algorithm>

namespace reflectance::walked {
namespace {

/// Which parameters an expression names, by their slots, and what it calls, as a number beyond all slots.
void collectNames(const Tree& tree, NodeId id, std::vector<std::uint32_t>& names)
{
    const Node& node = tree.at(id);
    if ((node.op == Op::Variable || node.op == Op::Element) && node.slot < tree.uniformNumbers)
        names.push_back(node.slot);
    if (node.op == Op::Call || node.op == Op::Builtin)
        for (const NodeId argument : node.arguments)
            collectNames(tree, argument, names);
    else if (node.op >= Op::Element)
        collectNames(tree, node.a, names);
    if (node.op >= Op::Add)
        collectNames(tree, node.b, names);
    if (node.op == Op::Choose)
        collectNames(tree, node.c, names);
}

/// Two numbers are terms of a surface where each is scaled by a parameter that the other lacks: kd a + ks b, not 1 - r.
bool areTerms(const Tree& tree, const Node& sum)
{
    if (sum.type == Type::Vec3)
        return true;
    if (sum.type != Type::Float)
        return false;
    std::vector<std::uint32_t> a, b;
    collectNames(tree, sum.a, a);
    collectNames(tree, sum.b, b);
    const auto beyond = [](const auto& some, const auto& others) {
        return std::ranges::any_of(some, [&](auto name) { return std::ranges::find(others, name) == others.end(); });
    };
    return beyond(a, b) && beyond(b, a);
}

std::vector<NodeId> summands(const Tree& tree, NodeId id)
{
    const Node& node = tree.at(id);
    const auto both = [&] {
        std::vector<NodeId> all = summands(tree, node.a);
        const std::vector<NodeId> right = summands(tree, node.b);
        all.insert(all.end(), right.begin(), right.end());
        return all;
    };
    if ((node.op == Op::Add || node.op == Op::Subtract) && areTerms(tree, node))
        return both();
    if (node.op == Op::Builtin &&
        (builtins()[node.slot].built == Built::GateVector || builtins()[node.slot].built == Built::Gate))
        if (auto inside = summands(tree, node.arguments[1]); inside.size() > 1)
            return inside;
    if (node.op == Op::Multiply || (node.op == Op::Divide)) {
        const auto left = summands(tree, node.a);
        const auto right = node.op == Op::Divide ? std::vector<NodeId>{} : summands(tree, node.b);
        if (left.size() > 1 && right.size() <= 1)
            return left;
        if (right.size() > 1 && left.size() <= 1)
            return right;
    }
    return {id};
}

NodeId lastReturn(const std::vector<Statement>& body)
{
    for (auto statement = body.rbegin(); statement != body.rend(); ++statement)
        if (statement->kind == Statement::Kind::Return)
            return statement->value;
    return 0;
}

/// A highlight names the viewer's direction through lobe, halfway or a parameter ks; a diffuse term is what K, kd or rho scale.
std::string roleOf(std::string_view source)
{
    for (const std::string_view word : {"ks", "lobe", "gloss", "insideLight", "open"})
        if (source.find(word) != std::string_view::npos)
            return "specular";
    for (const std::string_view word : {"K * I", "kd", "rho", "K*I"})
        if (source.find(word) != std::string_view::npos)
            return "diffuse";
    return {};
}

std::string onOneLine(std::string_view text)
{
    std::string result;
    for (const char c : text)
        if (c != '\n' && (c != ' ' || (!result.empty() && result.back() != ' ')))
            result += c;
    return result;
}

} // namespace

std::vector<Term> termsOf(const Tree& tree)
{
    std::vector<Term> terms;
    if (tree.shade < 0)
        return terms;
    const NodeId returned = lastReturn(tree.functions[static_cast<std::size_t>(tree.shade)].body);
    if (returned == 0)
        return terms;
    for (const NodeId node : summands(tree, returned))
        terms.push_back({node, onOneLine(tree.source(node)), roleOf(tree.source(node))});
    // A name that does not tell two terms apart is none.
    for (std::size_t i = 0; i < terms.size(); ++i) {
        const bool shared = std::ranges::count(terms, terms[i].name, &Term::name) > 1;
        if (terms[i].name.empty() || shared)
            for (std::size_t k = terms.size(); k-- > i;)
                if (k == i || (shared && terms[k].name == terms[i].name))
                    terms[k].name = "term " + std::to_string(k + 1);
    }
    return terms;
}

ModelText withTerms(const ModelText& text, const Tree& tree, const std::vector<bool>& keep)
{
    const std::vector<Term> terms = termsOf(tree);
    CHECK_EQ(terms.size(), keep.size());
    ModelText changed = text;
    // From the back, so that the places before stay where they are.
    for (std::size_t i = terms.size(); i-- > 0;) {
        if (keep[i])
            continue;
        const Node& node = tree.at(terms[i].node);
        std::string zero = node.type == Type::Vec3 ? "vec3(0.0)" : "0.0";
        zero.append(
            static_cast<std::size_t>(std::count(text.code.begin() + static_cast<std::ptrdiff_t>(node.begin),
                                                text.code.begin() + static_cast<std::ptrdiff_t>(node.end), '\n')),
            '\n');
        changed.code.replace(node.begin, node.end - node.begin, zero);
    }
    return changed;
}

} // namespace reflectance::walked
