// "name=value,name=value" after the colon of a micro-surface's text. Internal to the makers of micro-surfaces.
#pragma once

#include "core/base/result.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace reflectance {

class SurfaceWords {
public:
    /// `known`: the names that may be given.
    [[nodiscard]] static Result<SurfaceWords> parsed(std::string_view text, const std::vector<std::string>& known);

    [[nodiscard]] bool has(std::string_view name) const { return given_.find(name) != given_.end(); }
    [[nodiscard]] std::string word(std::string_view name, std::string otherwise) const;
    /// A number within low .. high; `otherwise` where it is not given.
    [[nodiscard]] Result<double> number(std::string_view name, double otherwise, double low, double high) const;

private:
    std::map<std::string, std::string, std::less<>> given_;
};

} // namespace reflectance
