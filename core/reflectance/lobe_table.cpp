#include "core/reflectance/lobe_table.h"

#include <cmath>

namespace reflectance {

LobeTable<double> makeLobeTable(double n)
{
    constexpr double leastLeft = 12.0; // exp(-12) = 6e-6 of the peak
    const double reach = n > leastLeft ? std::sqrt(leastLeft / n) : 1.0;
    LobeTable<double> table;
    table.scale = lobeTableSteps / reach;
    for (int i = 0; i < lobeTableSteps; ++i) { // the last entry stays 0, as the lobe is beyond
        const double s = reach * i / lobeTableSteps;
        table.values[static_cast<std::size_t>(i)] = std::exp(n * std::log1p(-s * s));
    }
    return table;
}

template <class S> const LobeTable<S>& lobeTableFor(double n)
{
    thread_local double known = -1.0;
    thread_local LobeTable<S> table;
    if (known != n) {
        const LobeTable<double> made = makeLobeTable(n);
        std::transform(made.values.begin(), made.values.end(), table.values.begin(),
                       [](double value) { return static_cast<S>(value); });
        table.scale = static_cast<S>(made.scale);
        known = n;
    }
    return table;
}

template const LobeTable<double>& lobeTableFor<double>(double n);
template const LobeTable<float>& lobeTableFor<float>(double n);

} // namespace reflectance
