// A shared library opened at run time and kept open: drivers leave threads and exit handlers behind.
#pragma once

#include "core/base/result.h"

#include <string>
#include <vector>

namespace reflectance {

class SharedLibrary {
public:
    /// The first of the names that the dynamic linker finds; the error tells its answer to the last one.
    [[nodiscard]] static Result<SharedLibrary> open(const std::vector<std::string>& names);

    /// The function of this name as type F, or null.
    template <class F> [[nodiscard]] F find(const char* name) const { return reinterpret_cast<F>(address(name)); }

private:
    explicit SharedLibrary(void* handle) : handle_(handle) {}
    [[nodiscard]] void* address(const char* name) const;

    void* handle_;
};

} // namespace reflectance
