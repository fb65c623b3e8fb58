#include "tests/measured/made_files.h"

#include "core/base/text.h"
#include "core/math/angle.h"
#include "core/measured/bytes.h"

#include <cstdlib>
#include <iostream>

namespace reflectance::testing {

std::string merlFile(int thetaH, int thetaD, int phiD, const std::vector<double>& perChannel)
{
    std::string bytes;
    for (const int dimension : {thetaH, thetaD, phiD})
        appendLittleEndian(bytes, static_cast<std::int32_t>(dimension));
    for (const double value : perChannel)
        for (long cell = 0; cell < static_cast<long>(thetaH) * thetaD * phiD; ++cell)
            appendLittleEndian(bytes, value);
    return bytes;
}

std::string tensorFile(const std::vector<TensorField>& fields)
{
    std::string head("tensor_file\0\1\0", 14);
    std::size_t at = head.size() + 4;
    for (const TensorField& field : fields)
        at += 2 + field.name.size() + 2 + 1 + 8 + 8 * field.shape.size();
    appendLittleEndian(head, static_cast<std::uint32_t>(fields.size()));
    std::string body;
    for (const TensorField& field : fields) {
        appendLittleEndian(head, static_cast<std::uint16_t>(field.name.size()));
        head += field.name;
        appendLittleEndian(head, static_cast<std::uint16_t>(field.shape.size()));
        appendLittleEndian(head, static_cast<std::uint8_t>(10));
        appendLittleEndian(head, static_cast<std::uint64_t>(at + body.size()));
        for (const std::size_t extent : field.shape)
            appendLittleEndian(head, static_cast<std::uint64_t>(extent));
        for (const float value : field.values)
            appendLittleEndian(body, value);
    }
    return head + body;
}

std::vector<TensorField> rglFields(const std::vector<RglSlice>& slices)
{
    std::vector<TensorField> fields{{"phi_i", {1}, {0}},
                                    {"theta_i", {slices.size()}, {}},
                                    {"ndf", {2, 2}, {2, 2, 2, 2}},
                                    {"sigma", {2, 2}, {1, 1, 1, 1}},
                                    {"vndf", {1, slices.size(), 2, 2}, {}},
                                    {"rgb", {1, slices.size(), 3, 2, 2}, {}}};
    for (const RglSlice& slice : slices) {
        fields[1].values.push_back(slice.thetaI);
        fields[4].values.insert(fields[4].values.end(), slice.vndf.begin(), slice.vndf.end());
        fields[5].values.insert(fields[5].values.end(), slice.rgb.begin(), slice.rgb.end());
    }
    return fields;
}

std::string cornellFile()
{
    std::string text = "# a paint\n3\n450 550\n650\n# angles, values\n";
    for (const char* row : {"0.2 0 0.2 3.14159", "0.2 0 0.3 3", "0.2 0 0.4 2", "0.2 0 0.9 1", "0.7 0 0.7 3.14159",
                            "0.7 0 0.2 0.5", "0.7 0 0.9 2.5", "1 0 0.4 0.1", "1 0 1.2 1.5", "1.2 0 0.8 2.9"})
        text.append(row).append(" 0.25 0.25 0.25\n");
    return text;
}

std::string zemaxFile()
{
    std::string text = "# made\nSource Measured\nSymmetry PlaneSymmetrical\nSpectralContent Monochrome\n"
                       "ScatterType BRDF\nSampleRotation 1\n0\nAngleOfIncidence 2\n10 40\nScatterAzimuth 3\n0 90 180\n"
                       "ScatterRadial 4\n0 10 30 60\n\nMonochrome\nDataBegin\n";
    for (const char* value : {"0.11", "0.14"}) {
        text += "TIS 0.3\n";
        for (int azimuth = 0; azimuth < 3; ++azimuth)
            text.append(value).append(" ").append(value).append(" ").append(value).append(" 0.0\n");
    }
    return text + "DataEnd\n";
}

std::string openMaterialFile()
{
    return R"({"metadata": {"name": "made"}, "brdf": {"wavelengths": [5.5e-7], "lookupTable": [
      [5.5e-7, 0, 0, 0, 0.1], [5.5e-7, 0, 0, 3.14159265358979, 0.1],
      [5.5e-7, 0, 1.570796, 0, 0.2], [5.5e-7, 0, 1.570796, 3.14159265358979, null],
      [5.5e-7, 1, 0, 0, 0.3], [5.5e-7, 1, 0, 3.14159265358979, 0.3],
      [5.5e-7, 1, 1.570796, 0, 0.4], [5.5e-7, 1, 1.570796, 3.14159265358979, 0.5]]}})";
}

std::string curetGeometries()
{
    std::string text;
    int number = 0;
    for (const double thetaV : {0.1, 0.5, 0.9, 1.3})
        for (const double thetaL : {0.0, 0.4, 0.8, 1.2, 1.4})
            for (const double phi : {0.0, 2.5})
                text += std::to_string(++number) + " " + general(thetaV, 6) + " " + general(phi, 6) + " " +
                        general(thetaL, 6) + " 0.0\n";
    return text;
}

std::string curetSurfaces()
{
    std::string text;
    for (const char* surface : {"1 0.1", "2 0.2"}) {
        text += surface;
        for (int i = 1; i < 40; ++i)
            text.append(" ").append(std::string_view(surface).substr(2));
        text += "\n";
    }
    return text;
}

Measurement measured(std::string_view bytes, const ReadOptions& options)
{
    auto found = readMeasurement(bytes, "a.table", options);
    if (!found) {
        std::cerr << found.error().sentence() << '\n';
        std::abort();
    }
    return *std::move(found);
}

Table table(std::string_view bytes, const ReadOptions& options)
{
    return std::get<Table>(measured(bytes, options));
}

std::string refusal(std::string_view bytes, const ReadOptions& options)
{
    const auto found = readMeasurement(bytes, "a.table", options);
    return found ? "" : found.error().sentence();
}

} // namespace reflectance::testing
