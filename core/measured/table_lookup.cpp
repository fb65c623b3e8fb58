#include "core/measured/table_lookup.h"

#include "measured_texts.gen.h"

namespace reflectance {
namespace {

/// The vector in a frame whose z is N. The azimuth of the frame does not matter to an isotropic surface.
struct AboutNormal {
    Vec3d x, y, z;

    explicit AboutNormal(const Vec3d& N) : z(N)
    {
        const Vec3d helper = std::fabs(N.x) < 0.6 ? Vec3d(1, 0, 0) : Vec3d(0, 1, 0);
        x = normalized(cross(helper, N));
        y = cross(N, x);
    }
    [[nodiscard]] Vec3d operator()(const Vec3d& v) const { return {dot(x, v), dot(y, v), dot(z, v)}; }
};

std::optional<Mat3d> brdfAbout(const Table& table, const Vec3d& N, const Vec3d& L, const Vec3d& V)
{
    const AboutNormal local(N);
    return brdfAt(table, local(L), local(V));
}

void appendTexel(std::vector<float>& numbers, double x, double y, double z, double w)
{
    for (const double number : {x, y, z, w})
        numbers.push_back(static_cast<float>(number));
}

void appendSample(const Table& table, std::size_t sample, std::vector<float>& numbers)
{
    const double* values = &table.values[sample * table.channels];
    const double measured = table.isHole(sample) ? 0.0 : 1.0;
    for (std::size_t row = 0; row < (table.channels + 2) / 3; ++row) {
        const auto number = [&](std::size_t i) {
            return measured > 0.0 ? values[table.channels == 1 ? 0 : 3 * row + i] : 0.0;
        };
        appendTexel(numbers, number(0), number(1), number(2), measured);
    }
}

} // namespace

TableTexels texelsOf(const Table& table)
{
    TableTexels texels;
    texels.system = static_cast<int>(table.system);
    texels.interpolation = static_cast<int>(table.interpolation);
    texels.isMatrix = table.channels == 9;
    texels.rows = texels.isMatrix ? 3 : 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::vector<double> none{0.0};
        const auto& angles = axis < table.axes.size() ? table.axes[axis] : none;
        texels.counts[axis] = static_cast<int>(angles.size());
        for (const double angle : angles)
            appendTexel(texels.numbers, angle, 0.0, 0.0, 0.0);
    }
    for (std::size_t sample = 0; sample < table.samples(); ++sample)
        appendSample(table, sample, texels.numbers);
    return texels;
}

Vec3f lookedUp(const TableTexels& texels, const Vec3f& N, const Vec3f& L, const Vec3f& V, const Vec3f& I)
{
    texts::TableLookup<float> text;
    text.tableTexels = {texels.numbers.data()};
    text.tableSystem = texels.system;
    text.tableInterpolation = texels.interpolation;
    text.tableRows = texels.rows;
    text.tableIsMatrix = texels.isMatrix;
    text.tableCountA = texels.counts[0];
    text.tableCountB = texels.counts[1];
    text.tableCountC = texels.counts[2];
    return text.tableAt(N, L, V, I);
}

Vec3d lookedUp(const Table& table, const Vec3d& N, const Vec3d& L, const Vec3d& V, const Vec3d& I)
{
    const auto f = brdfAbout(table, N, L, V);
    return f ? *f * I : Vec3d();
}

bool isHoleAt(const Table& table, const Vec3d& N, const Vec3d& L, const Vec3d& V)
{
    return dot(N, L) > 0.0 && dot(N, V) > 0.0 && !brdfAbout(table, N, L, V);
}

Vec3d holeColor(const Vec3d& P)
{
    return texts::Holes<double>().holeColor(P);
}

} // namespace reflectance
