// Small measured files of every format, made from closed forms.
#pragma once

#include "core/measured/load.h"

#include <string>
#include <string_view>
#include <vector>

namespace reflectance::testing {

/// MERL's bytes of any size, each cell `value` (before the scale).
[[nodiscard]] std::string merlFile(int thetaH, int thetaD, int phiD, const std::vector<double>& perChannel);

/// One field of a tensor file: floats, or bytes when `text` is not empty.
struct TensorField {
    std::string name;
    std::vector<std::size_t> shape;
    std::vector<float> values;
};
[[nodiscard]] std::string tensorFile(const std::vector<TensorField>& fields);

/// The fields of an isotropic RGL file whose squares are given by 2 x 2 nodes: ndf = 2, sigma = 1, and per slice a vndf
/// (row by row) and a constant colour.
struct RglSlice {
    float thetaI;
    std::vector<float> vndf;
    std::vector<float> rgb; ///< three planes of 2 x 2
};
[[nodiscard]] std::vector<TensorField> rglFields(const std::vector<RglSlice>& slices);

[[nodiscard]] std::string cornellFile();
[[nodiscard]] std::string zemaxFile(); ///< f = 0.1 + theta_i(degrees) / 1000, 0 at the last radial angle
[[nodiscard]] std::string openMaterialFile();
[[nodiscard]] std::string curetGeometries(); ///< 40 pairs of directions
[[nodiscard]] std::string curetSurfaces();   ///< two Lambertian surfaces, f = 0.1 and 0.2

/// What must be read, and the sentence of what must not.
[[nodiscard]] Measurement measured(std::string_view bytes, const ReadOptions& options = {});
[[nodiscard]] Table table(std::string_view bytes, const ReadOptions& options = {});
[[nodiscard]] std::string refusal(std::string_view bytes, const ReadOptions& options = {});

} // namespace reflectance::testing
