#include "app/explorer/ui/workbench/page.h"

#include "app/explorer/ui/workbench/colour_page.h"
#include "app/explorer/ui/workbench/curves_page.h"
#include "app/explorer/ui/workbench/extremes_page.h"
#include "app/explorer/ui/workbench/fit_page.h"
#include "app/explorer/ui/workbench/laboratory_page.h"
#include "app/explorer/ui/workbench/probe_page.h"
#include "app/explorer/ui/workbench/sensor_page.h"
#include "app/explorer/ui/workbench/surfaces_page.h"
#include "app/explorer/ui/workbench/table_page.h"
#include "app/explorer/ui/workbench/trade_page.h"

namespace reflectance::explorer {

std::span<const WorkbenchPage> workbenchPages()
{
    static constexpr WorkbenchPage pages[] = {
        {"curves", "Curves", "The surface beside other models: curves, lobes in space, lit balls, albedo, one parameter varied, a map.", drawCurvesPage},
        {"surfaces", "Surfaces", "Published constants of real surfaces, with their sources; a click applies one.",
         drawSurfacesPage},
        {"table", "Table", "A measured surface as a map over both angles, with its holes and its reciprocity.",
         drawTablePage},
        {"fit", "Fit",
         "A model fitted to a measured surface: its curve over the data, and how well the data determine it.",
         drawFitPage},
        {"colour", "Colour", "Where K comes from: filters, primaries, and what a diagonal K costs.", drawColourPage},
        {"extremes", "Extremes", "The inputs at which reflectance code breaks, tried on this machine.",
         drawExtremesPage},
        {"sensor", "Sensor",
         "Where the picture's difference from the truth comes from: model, precision, sensor, encoding.",
         drawSensorPage},
        {"trade", "Trade", "What every cheaper way of drawing this view loses and saves, measured here.",
         drawTradePage},
        {"laboratory", "Laboratory", "A rough surface traced facet by facet into a measured table, with its errors.",
         drawLaboratoryPage},
        {"probe", "Probe", "One point of the picture, stage by stage with its numbers; and each term of it alone.",
         drawProbePage},
    };
    return pages;
}

} // namespace reflectance::explorer
