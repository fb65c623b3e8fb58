// Where the names of a chart's points stand, so that none lies on another.
#pragma once

#include <string_view>
#include <vector>

namespace reflectance {

/// In pixels, y downwards.
struct Box {
    double left = 0.0, top = 0.0, right = 0.0, bottom = 0.0;
};

/// A point that wants a name beside it, and how large the name is. A size of 0: only a point that names keep clear of.
struct LabelWish {
    double x = 0.0, y = 0.0;
    double width = 0.0, height = 0.0;
};

struct PlacedLabel {
    Box box;
    bool far = false; ///< not beside its point: a line should lead there
};

/// One box for each wish, within the field as far as it has room. A name stands beside its point, to the right if it can,
/// else in rings around it, where it covers the least of other names and points. Earlier wishes choose first.
[[nodiscard]] std::vector<PlacedLabel> placedLabels(const std::vector<LabelWish>& wishes, const Box& field);

/// The point of the box that is nearest to another: where a line that leads to the name ends.
struct LabelEnd {
    double x = 0.0, y = 0.0;
};
[[nodiscard]] LabelEnd endTowards(const Box& box, double x, double y);

/// About how wide a text is in the typeface of our drawings, in pixels: 0.56 of its size for each character, which is more
/// than Inter's mean and less than its widest letters.
[[nodiscard]] double textWidth(std::string_view text, int size);

/// The text in lines of at most `width` pixels, parted at blanks; a word that is wider stays whole.
[[nodiscard]] std::vector<std::string_view> textLines(std::string_view text, int size, double width);

} // namespace reflectance
