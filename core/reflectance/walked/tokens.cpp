#include "core/reflectance/walked/tokens.h"

#include "core/base/text.h"
#include "core/reflectance/words.h"

#include <cctype>

namespace reflectance::walked {
namespace {

constexpr std::size_t mostBytes = 1 << 18;

bool isDigit(char c)
{
    return c >= '0' && c <= '9';
}

class Lexer {
public:
    explicit Lexer(std::string_view code) : code_(code) {}

    Result<std::vector<Token>> run()
    {
        while (skipBlanks())
            if (!readToken())
                return Error{problem_, {}, line_};
        if (!problem_.empty())
            return Error{problem_, {}, line_};
        const long last = tokens_.empty() ? 1 : tokens_.back().line; // blank lines at the end are nobody's fault
        tokens_.push_back({Token::Kind::End, {}, at_, last, 0.0});
        return std::move(tokens_);
    }

private:
    [[nodiscard]] char letter(std::size_t ahead = 0) const
    {
        return at_ + ahead < code_.size() ? code_[at_ + ahead] : '\0';
    }

    /// False at the end.
    bool skipBlanks()
    {
        while (at_ < code_.size()) {
            if (letter() == '\n') {
                ++line_;
                ++at_;
            } else if (std::isspace(static_cast<unsigned char>(letter())) != 0) {
                ++at_;
            } else if (letter() == '/' && letter(1) == '/') {
                at_ = std::min(code_.find('\n', at_), code_.size());
            } else if (letter() == '/' && letter(1) == '*') {
                if (!skipLongComment())
                    return false;
            } else {
                return true;
            }
        }
        return false;
    }

    bool skipLongComment()
    {
        const std::size_t end = code_.find("*/", at_ + 2);
        if (end == std::string_view::npos) {
            problem_ = "a comment has no end; close it with */";
            return false;
        }
        for (; at_ < end + 2; ++at_)
            line_ += code_[at_] == '\n' ? 1 : 0;
        return true;
    }

    bool readToken()
    {
        if (isDigit(letter()) || (letter() == '.' && isDigit(letter(1))))
            return readNumber();
        std::size_t end = at_;
        while (end < code_.size() && isWordLetter(code_[end]))
            ++end;
        if (end > at_)
            return keep(Token::Kind::Word, end - at_);
        for (const std::string_view two : {"<=", ">=", "==", "!=", "&&", "||", "++", "--", "+=", "-=", "*=", "/="})
            if (code_.substr(at_, 2) == two)
                return keep(Token::Kind::Symbol, 2);
        if (std::string_view("+-*/<>=!?:;,.(){}[]").find(letter()) != std::string_view::npos)
            return keep(Token::Kind::Symbol, 1);
        problem_ = letter() == '#'
                       ? std::string("a model text has no preprocessor lines; write constants as const float")
                       : "a model text cannot hold the character '" + std::string(1, letter()) + "'";
        return false;
    }

    bool readNumber()
    {
        std::size_t end = at_;
        bool whole = true;
        const auto digits = [&] {
            while (end < code_.size() && isDigit(code_[end]))
                ++end;
        };
        digits();
        if (end < code_.size() && code_[end] == '.') {
            whole = false;
            ++end;
            digits();
        }
        if (end < code_.size() && (code_[end] == 'e' || code_[end] == 'E')) {
            whole = false;
            ++end;
            if (end < code_.size() && (code_[end] == '+' || code_[end] == '-'))
                ++end;
            digits();
        }
        if (end < code_.size() && isWordLetter(code_[end])) {
            problem_ = "write numbers plainly, 0.33 and not 0.33f";
            return false;
        }
        std::string text(code_.substr(at_, end - at_));
        if (!text.empty() && text.back() == '.')
            text.push_back('0');
        const auto number = parseNumber(text);
        if (!number || (whole && *number > 1e6)) {
            problem_ = "'" + text + "' is no number; whole numbers end at 1000000, others have a point";
            return false;
        }
        keep(whole ? Token::Kind::Whole : Token::Kind::Number, end - at_);
        tokens_.back().number = *number;
        return true;
    }

    bool keep(Token::Kind kind, std::size_t size)
    {
        tokens_.push_back({kind, code_.substr(at_, size), at_, line_, 0.0});
        at_ += size;
        return true;
    }

    std::string_view code_;
    std::size_t at_ = 0;
    long line_ = 1;
    std::vector<Token> tokens_;
    std::string problem_;
};

} // namespace

Result<std::vector<Token>> tokensOf(std::string_view code)
{
    if (code.size() > mostBytes)
        return Error{"the text is larger than 256 KiB; a model's formula is not"};
    return Lexer(code).run();
}

} // namespace reflectance::walked
