#include "core/base/result.h"

#include <algorithm>

namespace reflectance {
namespace {

constexpr std::size_t shownHead = 400, shownTail = 200;

bool isControl(char c)
{
    return (c >= 0 && c < ' ') || c == '\x7F';
}

/// Both ends of a text of any length.
std::string shortened(const std::string& text)
{
    if (text.size() <= shownHead + shownTail)
        return text;
    return text.substr(0, shownHead) + " ... " + text.substr(text.size() - shownTail);
}

} // namespace

std::string Error::sentence() const
{
    std::string text = file;
    if (!file.empty() && line > 0)
        text += ":" + std::to_string(line);
    text += text.empty() ? shortened(message) : ": " + shortened(message);
    // What a file says may be quoted here: a line break or an escape sequence stays out of terminals and logs.
    std::replace_if(text.begin(), text.end(), isControl, '?');
    return text;
}

} // namespace reflectance
