#include "app/explorer/ui/angle_rows.h"

#include "app/explorer/ui/number_row.h"

namespace reflectance::explorer {

bool incidenceRow(const IncidenceRow& limits, double& thetaI, std::optional<Message>& message)
{
    NumberRow row;
    row.name = "theta_i";
    row.symbol = "\u03B8_i";
    row.label = "Light";
    row.unit = "\u00B0";
    row.about = limits.about;
    row.sliderMax = limits.sliderMax;
    row.legalMin = 0.0;
    row.legalMax = limits.legalMax;
    row.initial = limits.initial;
    return numberRow(row, thetaI, message);
}

bool azimuthRow(double& deltaPhi, std::optional<Message>& message)
{
    NumberRow row;
    row.name = "delta_phi";
    row.symbol = "\u0394\u03C6";
    row.label = "Azimuth";
    row.unit = "\u00B0";
    row.about = "Between the azimuths of L and V. At 180 the map holds the mirror direction, along its diagonal.";
    row.sliderMax = row.legalMax = 180.0;
    row.legalMin = 0.0;
    row.initial = 180.0;
    return numberRow(row, deltaPhi, message);
}

} // namespace reflectance::explorer
