// RGL .bsdf: a tensor file whose arrays describe one material in the adaptive parameterisation.
#include "core/measured/bytes.h"
#include "core/measured/readers.h"
#include "core/measured/spectrum_colour.h"
#include "core/measured/tensor_file.h"

#include <algorithm>
#include <numbers>

namespace reflectance {
namespace {

constexpr int floatType = 10;

class RglReader {
public:
    RglReader(const TensorFile& fields, const ReadContext& context) : fields_(fields), context_(context) {}

    [[nodiscard]] Result<Measurement> read()
    {
        readAngles();
        readSquares();
        readColour();
        readDescription();
        if (!problem_.empty())
            return Error{problem_, context_.file};
        return Measurement(std::move(brdf_));
    }

private:
    void fail(const std::string& sentence)
    {
        if (problem_.empty())
            problem_ = sentence;
    }

    /// The floats of a field with this shape (0: any extent); empty, and a sentence, where it is not so.
    [[nodiscard]] std::vector<float> floats(const char* name, const std::vector<std::size_t>& shape)
    {
        const auto found = fields_.find(name);
        if (found == fields_.end()) {
            fail(std::string("is no RGL measurement: it has no field \"") + name + "\"");
            return {};
        }
        const Tensor& tensor = found->second;
        const auto fits = [](std::size_t wanted, std::size_t extent) { return wanted == 0 || wanted == extent; };
        if (tensor.type != floatType || tensor.count() == 0 || tensor.shape.size() != shape.size() ||
            !std::equal(shape.begin(), shape.end(), tensor.shape.begin(), fits)) {
            fail(std::string("its field \"") + name + "\" has not the type and shape of an RGL measurement");
            return {};
        }
        std::vector<float> values(tensor.count());
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] = *littleEndian<float>(tensor.bytes, i * sizeof(float));
        if (!std::all_of(values.begin(), values.end(), [](float v) { return std::isfinite(v); })) {
            fail(std::string("its field \"") + name + "\" holds a number that is not finite");
            return {};
        }
        return values;
    }

    [[nodiscard]] std::size_t extent(const char* name, std::size_t dimension) const
    {
        const auto found = fields_.find(name);
        return found == fields_.end() || found->second.shape.size() <= dimension ? 0 : found->second.shape[dimension];
    }

    void readAngles()
    {
        if (const std::size_t azimuths = extent("phi_i", 0); azimuths > 2)
            fail("is anisotropic (" + std::to_string(azimuths) +
                 " azimuths of incidence); only isotropic measurements can be shown");
        for (const float theta : floats("theta_i", {0})) {
            if (!(theta >= 0.0F && theta <= 1.5708F) || (!brdf_.thetaI.empty() && theta <= brdf_.thetaI.back()))
                fail("its angles theta_i do not ascend within 0 .. pi/2");
            brdf_.thetaI.push_back(theta);
        }
    }

    /// A grid of floats; nothing below 0 is a density or an area.
    [[nodiscard]] BilinearGrid grid(const float* nodes, std::size_t width, std::size_t height, const char* name,
                                    bool mayBeNegative)
    {
        BilinearGrid result{width, height, std::vector<float>(nodes, nodes + width * height)};
        if (!mayBeNegative && std::any_of(result.nodes.begin(), result.nodes.end(), [](float v) { return v < 0.0F; }))
            fail(std::string("its field \"") + name + "\" holds a negative number");
        return result;
    }

    [[nodiscard]] BilinearGrid square(const char* name)
    {
        const auto values = floats(name, {0, 0});
        if (values.empty())
            return {};
        const std::size_t height = extent(name, 0);
        const std::size_t width = extent(name, 1);
        if (height < 2 || width < 2) {
            fail(std::string("its field \"") + name + "\" is smaller than 2 x 2");
            return {};
        }
        return grid(values.data(), width, height, name, false);
    }

    void readSquares()
    {
        brdf_.ndf = square("ndf");
        brdf_.sigma = square("sigma");
        const auto values = floats("vndf", {1, brdf_.thetaI.size(), 0, 0});
        const std::size_t height = extent("vndf", 2);
        const std::size_t width = extent("vndf", 3);
        if (values.empty() || height < 2 || width < 2)
            return fail("its field \"vndf\" is smaller than 2 x 2");
        for (std::size_t i = 0; i < brdf_.thetaI.size(); ++i) {
            brdf_.warps.emplace_back(grid(&values[i * width * height], width, height, "vndf", false));
            if (!(brdf_.warps.back().total() > 0.0))
                fail("its field \"vndf\" is 0 everywhere for one angle");
        }
    }

    void readColour();
    void readDescription();

    const TensorFile& fields_;
    const ReadContext& context_;
    RglBrdf brdf_;
    std::string problem_;
};

/// "rgb" as it stands, or "spectra" as the CIE observer sees them, or one of their wavelengths.
void RglReader::readColour()
{
    const bool isSpectral = fields_.contains("spectra");
    const char* const name = isSpectral ? "spectra" : "rgb";
    std::vector<Vec3d> weights{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    if (isSpectral) {
        const auto stored = floats("wavelengths", {0});
        const std::vector<double> wavelengths(stored.begin(), stored.end());
        if (wavelengths.empty() ||
            std::adjacent_find(wavelengths.begin(), wavelengths.end(), std::greater_equal<>()) != wavelengths.end())
            return fail("its wavelengths do not ascend");
        const auto chosen = weightsFor(wavelengths, context_.options.wavelength);
        if (!chosen)
            return fail(chosen.error().message);
        weights = *chosen;
    } else if (context_.options.wavelength) {
        return fail("holds red, green and blue, no spectrum: no wavelength can be chosen");
    }
    const std::size_t slices = brdf_.thetaI.size();
    const auto values = floats(name, {1, slices, weights.size(), 0, 0});
    const std::size_t height = extent(name, 3);
    const std::size_t width = extent(name, 4);
    if (values.empty() || height < 2 || width < 2)
        return fail(std::string("its field \"") + name + "\" is smaller than 2 x 2");
    const std::size_t size = width * height;
    brdf_.provenance.samples = slices * size;
    for (std::size_t slice = 0; slice < slices; ++slice) {
        std::vector<BilinearGrid> planes(3, BilinearGrid{width, height, std::vector<float>(size)});
        for (std::size_t node = 0; node < size; ++node) {
            Vec3d sum;
            for (std::size_t k = 0; k < weights.size(); ++k)
                sum += weights[k] * double{values[(slice * weights.size() + k) * size + node]};
            planes[0].nodes[node] = static_cast<float>(sum.x);
            planes[1].nodes[node] = static_cast<float>(sum.y);
            planes[2].nodes[node] = static_cast<float>(sum.z);
            brdf_.provenance.negatives += sum.x < 0.0 || sum.y < 0.0 || sum.z < 0.0 ? 1 : 0;
        }
        std::move(planes.begin(), planes.end(), std::back_inserter(brdf_.rgb));
    }
}

void RglReader::readDescription()
{
    const auto jacobian = fields_.find("jacobian");
    brdf_.hasJacobian = jacobian == fields_.end() || jacobian->second.bytes.empty() || jacobian->second.bytes[0] != 0;
    Provenance& provenance = brdf_.provenance;
    provenance.name = context_.file;
    provenance.format = fields_.contains("spectra") ? "RGL BSDF (spectra)" : "RGL BSDF (rgb)";
    provenance.convention = "BRDF x cos(theta_r), over squares warped by the visible normals; radians";
    if (provenance.negatives > 0)
        provenance.warnings.emplace_back("negative numbers (colours outside sRGB) count as 0 when the surface is "
                                         "evaluated, as the format's authors do");
}

} // namespace

Result<Measurement> readRgl(std::string_view bytes, const ReadContext& context)
{
    const auto fields = parseTensorFile(bytes, context.file);
    if (!fields)
        return fields.error();
    return RglReader(*fields, context).read();
}

} // namespace reflectance
