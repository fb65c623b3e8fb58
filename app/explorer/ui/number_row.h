// The one control for numbers: symbol, label, and a slider whose well shows value and range. Drag to change,
// double-click for the default, Ctrl+click to type; what is typed may lie beyond the slider but not
// beyond the legal range.
#pragma once

#include "app/explorer/state.h"
#include "app/explorer/ui/formula.h"

#include <limits>
#include <string>

namespace reflectance::explorer {

struct NumberRow {
    std::string name;   ///< unique among the rows of a card; also names the value in messages
    std::string symbol; ///< "k_s", or empty
    std::string label;
    std::string unit;                       ///< "°", "EV"; "" for pure numbers
    std::string about;                      ///< one sentence
    std::vector<FormulaPiece> formula = {}; ///< typeset
    std::string source = {};
    double sliderMin = 0.0, sliderMax = 1.0;
    bool logarithmic = false;
    double legalMin = -std::numeric_limits<double>::infinity();
    double legalMax = std::numeric_limits<double>::infinity();
    double initial = 0.0; ///< what a double-click gives
};

/// True where `value` changed. A refused value is left as it was, with a message in the state.
bool numberRow(const NumberRow& row, double& value, std::optional<Message>& message);

/// The slider alone, `width` pixels wide, without symbol, label and range.
bool numberField(const NumberRow& row, double& value, float width, std::optional<Message>& message);

/// "0", "10⁷", "∞": ends of ranges as they are written beside a slider.
[[nodiscard]] std::string rangeEnd(double value);

} // namespace reflectance::explorer
