#include "core/study/trade/judge.h"

#include <algorithm>
#include <cmath>

namespace reflectance {

std::string_view labelOf(Metric metric)
{
    constexpr std::string_view labels[] = {"largest difference (linear, white 1)", "RMSE (linear, white 1)",
                                           "dE2000, 95th percentile"};
    return labels[static_cast<int>(metric)];
}

double ErrorFigures::by(Metric metric) const
{
    return metric == Metric::Max ? max : metric == Metric::Rmse ? rmse : perceived.deltaEP95;
}

Judge::Judge(Image truth, double gain)
    : truth_(std::move(truth)), factor_(static_cast<float>(gain)), reference_(exposed(truth_), Over::CoveredPixels)
{
}

Image Judge::exposed(Image image) const
{
    if (factor_ != 1.0F)
        for (float& value : image.rgb)
            value *= factor_;
    return image;
}

ErrorFigures Judge::errorOf(const Image& picture) const
{
    const auto linear = compared(truth_, picture);
    ErrorFigures figures;
    if (!linear) // two sizes: only the programmer can cause it
        return {HUGE_VAL, HUGE_VAL, HUGE_VAL, {}};
    figures.max = linear->maxAbs;
    figures.rmse = linear->rmse;
    figures.relative = linear->maxRelative;
    figures.perceived = reference_.to(exposed(picture));
    return figures;
}

bool Judge::seesObject() const
{
    return std::any_of(truth_.coverage.begin(), truth_.coverage.end(), [](float share) { return share > 0.0F; });
}

} // namespace reflectance
