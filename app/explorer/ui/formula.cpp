#include "app/explorer/ui/formula.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace reflectance::explorer {

namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, 10> greek = {{
    {"alpha", "\u03B1"},
    {"beta", "\u03B2"},
    {"theta", "\u03B8"},
    {"phi", "\u03C6"},
    {"rho", "\u03C1"},
    {"sigma", "\u03C3"},
    {"pi", "\u03C0"},
    {"lambda", "\u03BB"},
    {"delta", "\u03B4"},
    {"omega", "\u03C9"},
}};

constexpr std::array<std::string_view, 9> functionNames = {"exp", "log", "log1p", "sin", "cos",
                                                           "tan", "max", "min",   "sqrt"};

bool isLetter(char c)
{
    return std::isalpha(static_cast<unsigned char>(c)) != 0;
}

bool isDigit(char c)
{
    return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

/// Whole UTF-8 characters outside ASCII.
bool isWide(char c)
{
    return static_cast<unsigned char>(c) >= 0x80;
}

std::string_view inGreek(std::string_view name)
{
    const auto found = std::find_if(greek.begin(), greek.end(), [&](const auto& entry) { return entry.first == name; });
    return found == greek.end() ? name : found->second;
}

/// "ks" and "ks0" are k with a subscript, as "k_s" is; other names stay whole.
std::string symbolOf(std::string_view name, std::span<const Parameter> parameters)
{
    for (const Parameter& parameter : parameters)
        if (parameter.name == name)
            return parameter.symbol;
    if (name.size() >= 2 && name.size() <= 3 && name[0] == 'k' && name[1] != '_')
        return "k_" + std::string(name.substr(1));
    return std::string(name);
}

class Typesetter {
public:
    Typesetter(std::string_view text, std::span<const Parameter> parameters) : text_(text), parameters_(parameters) {}

    std::vector<FormulaPiece> pieces()
    {
        while (at_ < text_.size())
            next();
        return std::move(pieces_);
    }

private:
    char here(std::size_t ahead = 0) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }

    template <class Belongs> std::string_view run(Belongs belongs)
    {
        const std::size_t start = at_;
        while (at_ < text_.size() && belongs(text_[at_]))
            ++at_;
        return text_.substr(start, at_ - start);
    }

    void next()
    {
        const char c = here();
        if (isLetter(c))
            name(run([](char x) { return isLetter(x) || isDigit(x) || x == '_'; }));
        else if (isDigit(c))
            upright(run([](char x) { return isDigit(x) || x == '.'; }));
        else if (isWide(c))
            wide(run(isWide));
        else if (c == '^')
            superscript();
        else if (c == ' ')
            space();
        else
            sign();
    }

    void upright(std::string_view text)
    {
        // Neighbours of one style are one piece.
        if (!pieces_.empty() && pieces_.back().style == PieceStyle::Upright && !pieces_.back().mayBreakAfter)
            pieces_.back().text += text;
        else
            pieces_.push_back({std::string(text)});
    }

    void name(std::string_view text)
    {
        if (std::find(functionNames.begin(), functionNames.end(), text) != functionNames.end())
            return upright(text);
        const std::string symbol = symbolOf(text, parameters_);
        const std::size_t bar = symbol.find('_');
        pieces_.push_back({std::string(inGreek(std::string_view(symbol).substr(0, bar))), PieceStyle::Italic});
        if (bar != symbol.npos)
            pieces_.push_back({std::string(inGreek(std::string_view(symbol).substr(bar + 1))), PieceStyle::Subscript});
    }

    void wide(std::string_view text)
    {
        // U+0370 .. U+03FF begin with CD, CE or CF.
        const auto lead = static_cast<unsigned char>(text[0]);
        if (lead >= 0xCD && lead <= 0xCF)
            pieces_.push_back({std::string(text), PieceStyle::Italic});
        else
            upright(text);
    }

    void superscript()
    {
        ++at_;
        std::string raised;
        if (here() == '(') {
            raised = run([depth = 0](char c) mutable { return (c == '(' ? ++depth : c == ')' ? depth-- : depth) > 0; });
            raised = raised.substr(1, raised.size() - 2);
        } else {
            raised = run([](char c) { return isLetter(c) || isDigit(c) || isWide(c) || c == '-'; });
        }
        if (const std::size_t minus = raised.find('-'); minus != raised.npos)
            raised.replace(minus, 1, "\u2212");
        pieces_.push_back({std::string(inGreek(symbolOf(raised, parameters_))), PieceStyle::Superscript});
    }

    void space()
    {
        run([](char c) { return c == ' '; });
        if (here() == '*') // a product of numbers is written side by side, so that the dot is left to vectors
            run([](char c) { return c == '*' || c == ' '; });
        upright(" ");
    }

    void sign()
    {
        const char c = text_[at_++];
        upright(c == '-' ? "\u2212" : c == '.' ? "\u00B7" : c == '*' ? " " : std::string_view(&c, 1));
        if (c == ',' && here() == ' ')
            pieces_.back().mayBreakAfter = true;
    }

    std::string_view text_;
    std::span<const Parameter> parameters_;
    std::size_t at_ = 0;
    std::vector<FormulaPiece> pieces_;
};

} // namespace

std::vector<FormulaPiece> typeset(std::string_view formula, std::span<const Parameter> parameters)
{
    return Typesetter(formula, parameters).pieces();
}

} // namespace reflectance::explorer
