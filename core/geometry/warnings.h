// Collects what a reader stumbles over. A damaged file can repeat one fault a million times: after the first three of a
// kind only a count is kept.
#pragma once

#include "core/geometry/report.h"

#include <map>
#include <string_view>

namespace reflectance {

/// What a file says, fit for a message: at most 20 characters, unprintable ones as '?', in quotation marks.
[[nodiscard]] std::string quoted(std::string_view text);

class Warnings {
public:
    /// `kind` is both the text and what counts as a repetition; `detail` is shown with the first ones.
    void add(std::string_view kind, long line, std::string_view detail = {});

    /// Adds what was found in a part of the file that begins behind `linesBefore` lines, as if it had been found here.
    void append(const Warnings& later, long linesBefore);

    [[nodiscard]] std::size_t count(std::string_view kind) const;

    /// In the order of first appearance, each kind closed by "... and N more".
    [[nodiscard]] std::vector<MeshWarning> list() const;

private:
    struct Kind {
        std::string text;
        std::vector<MeshWarning> first;
        std::size_t count = 0;
    };
    Kind& find(std::string_view text);

    std::vector<Kind> kinds_;
    std::map<std::string, std::size_t, std::less<>> places_;
};

} // namespace reflectance
