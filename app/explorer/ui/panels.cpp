#include "app/explorer/ui/illumination_panel.h"
#include "app/explorer/ui/sensor_panel.h"
#include "app/explorer/ui/surface_panel.h"
#include "app/explorer/ui/ui.h"

namespace reflectance::explorer {

void drawPanels(ExplorerState& state)
{
    drawIlluminationPanel(state);
    drawSurfacePanel(state);
    drawSensorPanel(state);
}

} // namespace reflectance::explorer
