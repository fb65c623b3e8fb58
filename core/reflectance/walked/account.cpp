#include "core/reflectance/walked/account.h"

#include "core/base/text.h"
#include "core/reflectance/walked/walker.h"

#include <algorithm>
#include <functional>

namespace reflectance::walked {
namespace {

/// A loop writes this many lines; the rest would not be read.
constexpr std::size_t mostLines = 64;

std::string numbersText(const double* numbers, std::size_t count)
{
    if (count == 1)
        return general(numbers[0], 4);
    std::string text = "(";
    for (std::size_t i = 0; i < count; ++i)
        text += (i > 0 ? ", " : "") + general(numbers[i], 4);
    return text + ")";
}

void eachBelow(const Tree& tree, NodeId id, const std::function<void(NodeId)>& visit)
{
    const Node& node = tree.at(id);
    const bool isCall = node.op == Op::Call || node.op == Op::Builtin;
    if (isCall)
        for (const NodeId argument : node.arguments)
            eachBelow(tree, argument, visit);
    else if (node.op >= Op::Element)
        eachBelow(tree, node.a, visit);
    if (node.op >= Op::Add)
        eachBelow(tree, node.b, visit);
    if (node.op == Op::Choose)
        eachBelow(tree, node.c, visit);
    visit(id);
}

class Writer : public Listener {
public:
    explicit Writer(Account& account) : account_(account) {}

    void assigned(Walker<double>& walker, const Function& function, const Statement& statement,
                  const double* numbers) override
    {
        if (function.name != "shade" || account_.lines.size() >= mostLines)
            return;
        AccountLine line;
        line.line = statement.line;
        line.name = statement.kind == Statement::Kind::Return ? "returned" : statement.name;
        line.numbers.assign(numbers, numbers + sizeOf(statement.type));
        write(walker, statement.value, line);
    }

    void branched(Walker<double>& walker, const Function& function, const Statement& statement, bool taken) override
    {
        if (function.name != "shade" || account_.lines.size() >= mostLines)
            return;
        AccountLine line;
        line.line = statement.line;
        line.name = "if";
        line.notes.emplace_back(taken ? "holds" : "does not hold");
        write(walker, statement.value, line);
    }

private:
    void write(Walker<double>& walker, NodeId value, AccountLine& line)
    {
        line.expression = onOneLine(walker.tree().source(value));
        line.filled = onOneLine(filled(walker, value));
        eachBelow(walker.tree(), value, [&](NodeId id) { note(walker, id, line.notes); });
        account_.lines.push_back(std::move(line));
    }

    static std::string onOneLine(std::string_view text)
    {
        std::string result;
        for (const char c : text)
            if (c != '\n' && (c != ' ' || (!result.empty() && result.back() != ' ')))
                result += c;
        return result;
    }

    static double numberOf(Walker<double>& walker, NodeId id)
    {
        double number = 0.0;
        walker.valueOf(id, &number);
        return number;
    }

    static std::string textOf(Walker<double>& walker, NodeId id)
    {
        double numbers[9];
        walker.valueOf(id, numbers);
        return numbersText(numbers, sizeOf(walker.tree().at(id).type));
    }

    /// Names become numbers; matrices keep theirs, since their product is written out below.
    static std::string filled(Walker<double>& walker, NodeId value)
    {
        const Tree& tree = walker.tree();
        std::vector<NodeId> names;
        eachBelow(tree, value, [&](NodeId id) {
            const Node& node = tree.at(id);
            if ((node.op == Op::Variable && node.type != Type::Mat3) || node.op == Op::Element ||
                node.op == Op::Component)
                names.push_back(id);
        });
        std::ranges::sort(names, {},
                          [&](NodeId id) { return std::pair(tree.at(id).begin, -static_cast<long>(tree.at(id).end)); });
        std::string text;
        std::size_t at = tree.at(value).begin;
        for (const NodeId id : names) {
            const Node& node = tree.at(id);
            if (node.begin < at) // a part of what has been written
                continue;
            text += tree.code.substr(at, node.begin - at) + textOf(walker, id);
            at = node.end;
        }
        return text + tree.code.substr(at, std::max(at, tree.at(value).end) - at);
    }

    static void note(Walker<double>& walker, NodeId id, std::vector<std::string>& notes)
    {
        const Tree& tree = walker.tree();
        const Node& node = tree.at(id);
        const std::string source = onOneLine(tree.source(id));
        if (node.op == Op::Multiply && tree.at(node.a).type == Type::Mat3)
            return noteProduct(walker, node, notes);
        if (node.op == Op::Call)
            notes.push_back(source + " = " + textOf(walker, id));
        else if (node.op == Op::Choose)
            notes.push_back(onOneLine(tree.source(node.a)) +
                            (numberOf(walker, node.a) != 0.0 ? " holds" : " does not hold"));
        else if (node.op == Op::Builtin)
            noteBuiltin(walker, id, source, notes);
    }

    static void noteProduct(Walker<double>& walker, const Node& node, std::vector<std::string>& notes)
    {
        double m[9], v[3];
        walker.valueOf(node.a, m);
        walker.valueOf(node.b, v);
        const std::string name =
            onOneLine(walker.tree().source(node.a)) + " " + onOneLine(walker.tree().source(node.b));
        constexpr const char* channels[] = {"red", "green", "blue"};
        for (std::size_t i = 0; i < 3; ++i) {
            std::string sum;
            for (std::size_t j = 0; j < 3; ++j)
                sum += (j > 0 ? " + " : "") + general(m[3 * i + j], 4) + "*" + general(v[j], 4);
            notes.push_back(name + ", " + channels[i] + ": " + sum + " = " +
                            general(m[3 * i] * v[0] + m[3 * i + 1] * v[1] + m[3 * i + 2] * v[2], 4));
        }
    }

    static void noteBuiltin(Walker<double>& walker, NodeId id, const std::string& source,
                            std::vector<std::string>& notes)
    {
        const Tree& tree = walker.tree();
        const Node& node = tree.at(id);
        const auto first = [&] { return onOneLine(tree.source(node.arguments[0])); };
        switch (builtins()[node.slot].built) {
        case Built::Gate:
        case Built::GateVector: {
            const double condition = numberOf(walker, node.arguments[0]);
            notes.push_back("gate: " + first() + " = " + general(condition, 4) +
                            (condition > 0.0 ? " > 0, open" : " is not above 0, closed"));
            return;
        }
        case Built::Lobe:
            notes.push_back(lobeNote(walker, node));
            return;
        case Built::InsideLight:
            notes.push_back(source +
                            (numberOf(walker, id) > 0.0 ? ": inside the light's disc" : ": outside the light's disc"));
            return;
        case Built::Max:
        case Built::Min: {
            const double value = numberOf(walker, id);
            const NodeId taken = node.arguments[value == numberOf(walker, node.arguments[0]) ? 0 : 1];
            notes.push_back(std::string(builtins()[node.slot].name) + ": takes " + onOneLine(tree.source(taken)) +
                            " = " + general(value, 4));
            return;
        }
        case Built::Mirrored:
        case Built::Halfway:
        case Built::Environment:
        case Built::TableAt:
            notes.push_back(source + " = " + textOf(walker, id));
            return;
        default:
            return;
        }
    }

    static std::string lobeNote(Walker<double>& walker, const Node& node)
    {
        double R[3], V[3];
        walker.valueOf(node.arguments[0], R);
        walker.valueOf(node.arguments[1], V);
        const double n = numberOf(walker, node.arguments[2]);
        const Vec3d a(R[0], R[1], R[2]), b(V[0], V[1], V[2]);
        const double cosine = dot(a, b);
        const std::string of = "lobe: " + onOneLine(walker.tree().source(node.arguments[0])) + " . " +
                               onOneLine(walker.tree().source(node.arguments[1])) + " = " + general(cosine, 6);
        if (!(cosine > 0.0))
            return of + " is not above 0, so 0";
        const std::string value = " = " + general(lobe(a, b, n), 6);
        if (cosine <= 0.5)
            return of + " <= 1/2, the power " + general(cosine, 4) + "^" + general(n, 4) + value;
        const Vec3d chord = a - b;
        return of + " > 1/2, exp(n log1p(-x)) with x = |R - V|^2 / 2 = " + general(0.5 * dot(chord, chord), 6) +
               ", n = " + general(n, 4) + value;
    }

    Account& account_;
};

} // namespace

Account accountOf(const Tree& tree, const std::vector<double>& values, const Place& place)
{
    Account account;
    Writer writer(account);
    Walker<double> walker(tree, values.data());
    walker.lightDisc = place.lightDisc;
    walker.measured = place.measured;
    walker.listener = &writer;
    account.value = walker.shade(place.N, place.L, place.V, place.I);
    return account;
}

} // namespace reflectance::walked
