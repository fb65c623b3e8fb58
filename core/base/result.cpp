#include "core/base/result.h"

namespace reflectance {

std::string Error::sentence() const
{
    std::string place = file;
    if (!file.empty() && line > 0)
        place += ":" + std::to_string(line);
    return place.empty() ? message : place + ": " + message;
}

} // namespace reflectance
