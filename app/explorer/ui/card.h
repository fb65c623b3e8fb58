// A card holds one stage of the picture: a numbered heading that folds, and its controls.
#pragma once

#include <imgui.h>
#include <string>

namespace reflectance::explorer {

struct CardHeading {
    int number = 1; ///< place in the chain of stages
    const char* title = "";
    std::string summary; ///< a few words that tell the state when folded
    const char* about = "";
    bool last = false; ///< no arrow to a next stage
};

/// Draws the heading; while isOpen() the controls follow. The background is drawn when the card ends.
class Card {
public:
    explicit Card(const CardHeading& heading);
    ~Card();
    Card(const Card&) = delete;
    Card& operator=(const Card&) = delete;

    [[nodiscard]] bool isOpen() const { return open_; }

private:
    ImDrawListSplitter layers_; // the background has to lie below controls whose height is known only afterwards
    bool last_ = false;
    bool open_ = true;
};

} // namespace reflectance::explorer
