// Build step: makes C++ of shared texts that are not reflectance models.
//
//   make_texts SHADER_FOLDER OUT_HEADER NAME=TEXT.glsl...
//
// Each text becomes `template <class T> struct NAME`, its uniforms data members with their defaults.
#include "tools/translate.h"

#include <fstream>
#include <iostream>

namespace {

int run(const std::string& folder, const std::string& header, char** pairs, int count)
{
    std::ofstream out(header);
    out << "// Made by tools/make_texts from the shared texts under shaders; do not edit.\n#pragma once\n\n"
           "#include \"core/math/shading_language.h\"\n#include \"core/math/texels.h\"\n\nnamespace reflectance::texts {\n";
    for (int i = 0; i < count; ++i) {
        const std::string pair = pairs[i];
        const std::size_t equals = pair.find('=');
        const std::string path = equals == std::string::npos ? "" : pair.substr(equals + 1);
        const std::string code = reflectance::tools::contents(folder + "/" + path);
        if (path.empty() || code.empty()) {
            std::cerr << "make_texts: " << pair << " names no text under " << folder << '\n';
            return 1;
        }
        out << "\ntemplate <class T> struct " << pair.substr(0, equals) << " {\n#line 1 \"shaders/" << path << "\"\n"
            << reflectance::tools::instantiated(code) << "};\n";
    }
    out << "\n} // namespace reflectance::texts\n";
    return out.good() ? 0 : 1;
}

} // namespace

int main(int argc, char** argv)
{
    if (argc < 4) {
        std::cerr << "usage: make_texts SHADER_FOLDER OUT_HEADER NAME=TEXT.glsl...\n";
        return 2;
    }
    return run(argv[1], argv[2], argv + 3, argc - 3);
}
