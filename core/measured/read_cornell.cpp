// Cornell .brdf: a count of wavelengths, the wavelengths in nm, then rows of four angles in radians and one BRDF value per
// wavelength, at scattered angles.
#include "core/measured/readers.h"
#include "core/measured/spectrum_colour.h"
#include "core/measured/text_numbers.h"

#include <numbers>

namespace reflectance {
namespace {

class CornellReader {
public:
    CornellReader(std::string_view text, const ReadContext& context) : numbers_(text), context_(context) {}

    [[nodiscard]] Result<Measurement> read()
    {
        if (const auto problem = readWavelengths())
            return *problem;
        const bool isGrey = context_.options.wavelength.has_value();
        const auto weights = weightsFor(wavelengths_, context_.options.wavelength);
        if (!weights)
            return fail(weights.error().message);
        while (!numbers_.atEnd()) {
            double at[4];
            for (double& angle : at)
                if (const auto problem = take(angle, "an angle"))
                    return *problem;
            for (const double theta : {at[0], at[2]})
                if (!(theta >= 0.0 && theta <= std::numbers::pi / 2.0 + 1e-6))
                    return fail("a polar angle is " + general(theta, 9) + " radians; 0 .. pi/2 are possible");
            Vec3d colour;
            for (const Vec3d& weight : *weights) {
                double value = 0.0;
                if (const auto problem = take(value, "a BRDF value"))
                    return *problem;
                colour += value * weight;
            }
            if (!(std::fabs(colour.x) + std::fabs(colour.y) + std::fabs(colour.z) <= largestBrdf))
                return fail("a BRDF value is too large; numbers up to 1e100 are possible");
            if (L_.size() == mostScattered)
                return fail("holds more than " + std::to_string(mostScattered) + " samples; thin them out");
            L_.push_back(directionAt(at[0], at[1]));
            V_.push_back(directionAt(at[2], at[3]));
            values_.push_back(colour.x);
            if (!isGrey)
                values_.insert(values_.end(), {colour.y, colour.z});
        }
        if (values_.empty())
            return fail("has wavelengths and no sample");
        return measured(isGrey ? 1 : 3);
    }

private:
    [[nodiscard]] Error fail(const std::string& sentence) const { return {sentence, context_.file, numbers_.line()}; }

    [[nodiscard]] std::optional<Error> take(double& number, const char* what)
    {
        const std::string_view word = numbers_.word();
        if (word.empty())
            return fail("ends within a sample; get the whole file");
        const auto value = parseNumber(word);
        if (!value || !std::isfinite(*value))
            return fail(quotedPiece(word) + " is not " + what);
        number = *value;
        return std::nullopt;
    }

    [[nodiscard]] std::optional<Error> readWavelengths()
    {
        const std::string_view word = numbers_.word();
        const auto count = parseInteger(word);
        if (!count || *count < 1)
            return fail("the count of wavelengths is " + quotedPiece(word) + "; give a whole number");
        for (long i = 0; i < *count; ++i) { // a false count ends with the file
            double value = 0.0;
            if (auto problem = take(value, "a wavelength"))
                return problem;
            if (value < 100.0 || value > 1e5 || (!wavelengths_.empty() && value <= wavelengths_.back()))
                return fail("the wavelengths do not ascend at " + general(value, 9) + "; give them in nm");
            wavelengths_.push_back(value);
        }
        return std::nullopt;
    }

    [[nodiscard]] Measurement measured(std::size_t channels)
    {
        ScatteredBrdf brdf = scatteredBrdf(L_, V_, values_, channels);
        Provenance& provenance = brdf.provenance;
        provenance.name = context_.file;
        provenance.format = "Cornell BRDF";
        const std::string spectrum = std::to_string(wavelengths_.size()) + " wavelengths " +
                                     general(wavelengths_.front(), 6) + " .. " + general(wavelengths_.back(), 6) +
                                     " nm";
        provenance.convention = "BRDF in 1/sr; radians; " + spectrum +
                                (channels == 3 ? ", seen by the CIE 1931 observer in D65 as linear sRGB"
                                               : ", of which " + general(*context_.options.wavelength, 6) + " nm");
        return brdf;
    }

    TextNumbers numbers_;
    const ReadContext& context_;
    std::vector<double> wavelengths_;
    std::vector<Vec3d> L_, V_;
    std::vector<double> values_;
};

} // namespace

Result<Measurement> readCornell(std::string_view text, const ReadContext& context)
{
    return CornellReader(text, context).read();
}

} // namespace reflectance
