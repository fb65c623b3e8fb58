// How many cores there are for this process.
#pragma once

namespace reflectance {

/// Those that the system lets it use: what it was bound to, which may be fewer than the machine has. At least 1.
[[nodiscard]] unsigned usableCores();

} // namespace reflectance
