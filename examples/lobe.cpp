// A highlight of the hybrid model, as numbers: how it fades when the viewer leaves the mirror direction.
#include "core/reflectance/evaluate.h"

#include <cmath>
#include <cstdio>

int main()
{
    using namespace reflectance;
    const auto model = findModel("hybrid");
    ParameterValues values{{"ks", {0.5}}, {"n", {40.0}}};
    if (!model)
        return 1;
    for (int degrees = 0; degrees <= 40; degrees += 10) {
        const double a = (45.0 + degrees) * 3.14159265358979 / 180.0; // the light stands at 45 degrees
        const Observation row{{0.0, 0.0, 1.0}, {std::sin(a), 0.0, std::cos(a)}, {{{-1.0, 0.0, 1.0}, Vec3d(1.0)}}};
        const auto factor = evaluate(**model, flatValues((*model)->text, values), {&row, 1}, Precision::Double);
        std::printf("%d degrees: %.6f\n", degrees, factor[0].x);
    }
}
