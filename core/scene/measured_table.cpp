#include "core/scene/measured_table.h"

#include "core/measured/load.h"
#include "core/measured/resample.h"

namespace reflectance {
namespace {

Vec3d exactly(const void* table, const Vec3d& N, const Vec3d& L, const Vec3d& V, const Vec3d& I)
{
    return lookedUp(static_cast<const MeasuredTable*>(table)->table, N, L, V, I);
}

Vec3f inFloat(const void* table, const Vec3f& N, const Vec3f& L, const Vec3f& V, const Vec3f& I)
{
    return lookedUp(static_cast<const MeasuredTable*>(table)->texels, N, L, V, I);
}

} // namespace

Result<std::shared_ptr<const MeasuredTable>> loadTable(const std::string& path)
{
    const auto measurement = loadMeasurement(path);
    if (!measurement)
        return measurement.error();
    return measuredTable(gridOf(*measurement));
}

std::shared_ptr<const MeasuredTable> measuredTable(Table table)
{
    auto measured = std::make_shared<MeasuredTable>();
    measured->texels = texelsOf(table);
    measured->table = std::move(table);
    return measured;
}

MeasuredSurfaces lookUpsIn(const MeasuredTable* table)
{
    if (!table)
        return {};
    return {{exactly, table}, {inFloat, table}};
}

} // namespace reflectance
