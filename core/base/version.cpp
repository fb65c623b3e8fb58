#include "core/base/version.h"

namespace reflectance {

std::string_view programVersion()
{
    return REFLECTANCE_VERSION;
}

} // namespace reflectance
