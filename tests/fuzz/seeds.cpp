#include "tests/fuzz/seeds.h"

#include "core/image/formats.h"
#include "core/scene/kept_picture.h"
#include "core/scene/scene_file.h"

namespace reflectance::fuzz {
namespace {

Image gradient(int width, int height, bool hasCoverage)
{
    Image image(width, height);
    for (std::size_t i = 0; i < image.rgb.size(); ++i)
        image.rgb[i] = static_cast<float>(i) * 0.125F - 1.0F;
    image.coverage.assign(hasCoverage ? image.pixels() : 0, 0.5F);
    return image;
}

} // namespace

std::vector<std::string> sceneSeeds()
{
    Scene full = defaultScene();
    full.lights.front().kind = LightKind::Point;
    full.environment.kind = EnvironmentKind::Constant;
    full.surface.values["n"] = {1e7};
    full.surface.values["K"] = {0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, -0.9};
    return {
        sceneText(full, ""), R"({"mesh": "sphere", "surface": {"model": "phong", "parameters": {"ks": 0.5}}})",
        R"({"lights": [{"direction": [0, 1, 0], "intensity": [1e3, 0, 1]}], "sensor": {"exposure": -2}})",
        R"({"sensor": {"noise": {"read": 3, "seed": 7}, "quantisation": {"bits": 12, "dither": true}, "encoding": {"on": false},
                "balance": {"gains": [1, 2, 3]}, "view": {"kind": "luminance"}}})"};
}

std::vector<std::string> sessionSeeds()
{
    PictureRecipe recipe;
    recipe.shown = VariantView::Wipe;
    return {*findNote(keptNotes(defaultScene(), recipe, "/nonexistent"), "reflectance.session"),
            R"({"program": "0.1", "picture": {"width": 3, "samples": 9}, "scene": {"mesh": "sphere"}})"};
}

std::vector<std::string> keptSeeds()
{
    const Notes notes = keptNotes(defaultScene(), {}, "/nonexistent");
    const std::vector<std::uint8_t> codes(3, 7);
    return {encodedPng(1, 1, codes, {}, notes), encodedExr(gradient(1, 1, false), notes)};
}

std::vector<std::string> pngSeeds()
{
    std::vector<std::uint8_t> codes(3 * 5 * 7);
    for (std::size_t i = 0; i < codes.size(); ++i)
        codes[i] = static_cast<std::uint8_t>(i * 37);
    return {encodedPng(5, 7, codes), encodedPng(1, 1, std::span(codes).first(3))};
}

std::vector<std::string> exrSeeds()
{
    return {encodedExr(gradient(6, 5, true)), encodedExr(gradient(1, 1, false))};
}

std::vector<std::string> pfmSeeds()
{
    return {encodedPfm(gradient(4, 3, false)), "Pf\n2 1\n1.0\n" + std::string(8, '\x3F')};
}

std::vector<std::string> hdrSeeds()
{
    std::string runs = "#?RADIANCE\nEXPOSURE=2\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 8\n";
    for (int y = 0; y < 2; ++y)
        runs += std::string("\x02\x02\x00\x08\x88\x40\x04\x50\x51\x52\x53\x84\x54\x88\x60\x88\x80", 17);
    return {runs, "#?RGBE\n\n-Y 1 +X 2\n\x10\x20\x30\x80\x10\x20\x30\x81"};
}

std::vector<std::string> rowSeeds()
{
    return {"id,model,params,N,L,V,light_rgb,light_radius\n"
            "a,lambert,kd=0.5,0 0 1,0 0 1,0 0 1,1 1 1,0\n"
            "b,phong,ks=0.5;n=1e7,0 0 1e-200,0 1 1,0 -1 1,1 0.5 0,4.5\n"
            "c,lambert,,0 0 1,0 0 1|1 0 1,0 0 1,1 1 1|2 2 2,1|2\n",
            "V,N,L,light_rgb,model,id\r\n0 0 1,0 0 1,0 0 1,1 1 1,oren_nayar,x\r\n"};
}

std::vector<std::string> modelSeeds()
{
    return {"//! name     A\n//! formula  kd max(0, N.L)\n//! citation nobody\n//! about    a text\n"
            "//! reciprocal yes\n//! passive  no: never\n//! becomes lambert where ks=0\n"
            "uniform float kd = 0.5;\n//: label Diffuse\n//: slider 0 .. 1 log\n//: legal 0 .. 1e7\n//: unit degrees\n"
            "uniform vec3 ks = vec3(0.04);\n//: symbol k\n"
            "uniform mat3 K = transpose(mat3(1, 0, 0,\n    0, 1, 0,\n    0, 0, 1));\n//: tooltip rows\n"
            "vec3 shade(vec3 N, vec3 L, vec3 V, vec3 I)\n{\n    return kd * I;\n}\n",
            "uniform float kd = 0.5;\n//: like lambert\nvec3 shadeEnvironment(vec3 N, vec3 V) { return N; }\n"
            "vec3 shade(vec3 N, vec3 L, vec3 V, vec3 I) { return insideLight(L, V) * I; }\n",
            "const float two = 2.0;\nfloat f(float a, int n) { for (int i = 0; i < n; ++i) { a *= two; } return a; }\n"
            "vec3 shade(vec3 N, vec3 L, vec3 V, vec3 I)\n{\n    vec3 P[3];\n    P[1] = I;\n"
            "    if (N.z > 0.0 && !(L.x == 1.0)) return f(pow(dot(N, L), 5.0), 3) * P[1]; else { return -I; }\n}\n"};
}

} // namespace reflectance::fuzz
