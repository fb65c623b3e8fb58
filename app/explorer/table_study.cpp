#include "app/explorer/table_study.h"

#include "core/math/angle.h"

#include <cmath>

namespace reflectance::explorer {

void renewMap(TablePage& page, const std::shared_ptr<const MeasuredTable>& table, bool changed)
{
    if (!changed && table == page.shown)
        return;
    if (table != page.shown)
        page.facts.reset();
    page.shown = table;
    page.map = !table          ? HeatMap()
               : page.residual ? residualMap(table->table, page.settings)
                               : valueMap(table->table, page.settings);
}

void pollTableFacts(TablePage& page, Worker<TableFacts>& worker, std::shared_ptr<const MeasuredTable>& asked)
{
    if (std::optional<TableFacts> facts = worker.take(); facts && asked == page.shown)
        page.facts = std::move(facts);
    if (!page.shown || asked == page.shown)
        return;
    asked = page.shown;
    worker.start([table = page.shown](Progress& progress) -> std::optional<TableFacts> {
        const Measurement measurement = table->table;
        TableFacts facts{reciprocityOf(measurement, radians(reciprocityLimit)), {}};
        if (progress.cancel)
            return std::nullopt;
        facts.leftOut = leaveOneOut(measurement);
        return facts;
    });
}

Vec3d lightFor(const Camera& camera, const TableCursor& cursor, double deltaPhi)
{
    const CameraFrame frame = frameOf(camera);
    const double tilt = radians(cursor.thetaR);
    const Vec3d N = std::cos(tilt) * frame.back + std::sin(tilt) * frame.right;
    // The viewer's side in the tangent plane, and what stands square on it.
    const Vec3d towardsV = std::sin(tilt) * frame.back - std::cos(tilt) * frame.right;
    const Vec3d across = cross(N, towardsV);
    const double azimuth = radians(deltaPhi);
    const double theta = radians(cursor.thetaI);
    return std::cos(theta) * N + std::sin(theta) * (std::cos(azimuth) * towardsV + std::sin(azimuth) * across);
}

} // namespace reflectance::explorer
