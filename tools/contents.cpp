#include "tools/contents.h"

#include <fstream>
#include <sstream>

namespace reflectance::tools {

std::string contents(const std::string& path)
{
    std::ifstream file(path);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

} // namespace reflectance::tools
