#include "core/base/embedded.h"

#include <cstdlib>
#include <iostream>

namespace reflectance {

std::string_view embeddedText(std::string_view name)
{
    for (const EmbeddedFile& file : embeddedFiles())
        if (file.name == name)
            return file.bytes;
    std::cerr << "no embedded file " << name << '\n';
    std::abort();
}

} // namespace reflectance
