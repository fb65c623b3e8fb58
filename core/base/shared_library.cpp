#include "core/base/shared_library.h"

#include <dlfcn.h>

namespace reflectance {

Result<SharedLibrary> SharedLibrary::open(const std::vector<std::string>& names)
{
    for (const std::string& name : names)
        if (void* handle = dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL))
            return SharedLibrary(handle);
    const char* answer = dlerror();
    return Error{answer ? answer : "not found"};
}

void* SharedLibrary::address(const char* name) const
{
    return dlsym(handle_, name);
}

} // namespace reflectance
