// What the workbench's table page knows of the measured table in use: its map, and facts that take a while.
#pragma once

#include "app/explorer/worker.h"
#include "core/geometry/camera.h"
#include "core/measured/facts.h"
#include "core/scene/measured_table.h"
#include "core/study/tables/table_maps.h"

#include <memory>
#include <optional>
#include <vector>

namespace reflectance::explorer {

/// Beyond this angle from the normal, in degrees, measurements are too noisy to blame a surface for.
inline constexpr double reciprocityLimit = 75.0;

/// Numbers of the whole table.
struct TableFacts {
    Reciprocity reciprocity;
    std::vector<LeftOut> leftOut;
};

/// A place under the mouse, degrees.
struct TableCursor {
    double thetaI = 40.0, thetaR = 40.0;
};

struct TablePage {
    TableMapSettings settings;
    bool residual = false; ///< the map shows reciprocity instead of the numbers
    TableCursor cursor;    ///< where the mouse was last: the polar plot's slice

    std::shared_ptr<const MeasuredTable> shown; ///< that the map and the facts are of
    HeatMap map;
    std::optional<TableFacts> facts; ///< none while they are being found
};

/// Brings the page's map up to date with the table and the settings. `changed` is true where the settings were touched.
void renewMap(TablePage& page, const std::shared_ptr<const MeasuredTable>& table, bool changed);

/// Finds the facts of a new table on another thread and hands them to the page.
void pollTableFacts(TablePage& page, Worker<TableFacts>& worker, std::shared_ptr<const MeasuredTable>& asked);

/// The direction to a light that meets, at a point tilted thetaR away from the viewer (to the right), the cell of these angles:
/// N.V = cos thetaR, N.L = cos thetaI, and deltaPhi between their azimuths. Degrees.
[[nodiscard]] Vec3d lightFor(const Camera& camera, const TableCursor& cursor, double deltaPhi);

} // namespace reflectance::explorer
