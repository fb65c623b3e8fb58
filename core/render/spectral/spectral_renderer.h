// The spectral truth of a picture: the scene shaded wavelength by wavelength and summed by the sensor, and how far each
// cheat's picture is from it.
#pragma once

#include "core/render/cpu/cpu_renderer.h"
#include "core/spectra/color_price.h"

namespace reflectance {

/// Spectra in the place of K and of the lights' three numbers, on the system's grid.
struct SpectralScene {
    Scene scene;                            ///< its model has a K; everything but K and the lights' colours counts
    std::vector<double> S;                  ///< takes K's place
    std::vector<std::vector<double>> power; ///< one for each of the scene's lights, takes its intensity's place
};

/// The scene with a spectrum in every light. With `spectrum` all lights have its shape, each as bright as its largest
/// number; without, their numbers are strengths of the primaries.
[[nodiscard]] Result<SpectralScene> spectralScene(const Scene& scene, const ColorSystem& system,
                                                  const JudgedSurface& surface, const JudgedLight* spectrum);

/// Shades three wavelengths at a time in double and adds up what the sensor sees. Surroundings and background, which have
/// no spectra, are taken as the sensor's own numbers. Each wavelength's picture is rounded to float, 6e-8 of itself.
[[nodiscard]] Image shadeSpectral(const ViewSamples& samples, const SpectralScene& spectral, const ColorSystem& system,
                                  Progress* progress = nullptr);

/// The same scene in three numbers: the cheat's matrix as K, every light as the sensor sees it on white.
[[nodiscard]] Scene cheatScene(const SpectralScene& spectral, const ColorSystem& system, const Mat3d& matrix);

struct PicturePrice {
    Cheat cheat = Cheat::FullK;
    double mean = 0.0, p95 = 0.0, max = 0.0; ///< CIEDE2000 over the pixels that the object covers whole
    double maxLinear = 0.0;                  ///< as a share of white
    std::size_t negative = 0;                ///< pixels
};

/// Every cheat's picture against the spectral one; `white` is what the sensor calls white.
[[nodiscard]] std::vector<PicturePrice> pricesOnPicture(const ViewSamples& samples, const SpectralScene& spectral,
                                                        const ColorSystem& system, const JudgedSurface& surface,
                                                        const Vec3d& white, Progress* progress = nullptr);

} // namespace reflectance
