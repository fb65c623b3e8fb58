// Build step: makes C++ of shared texts that are not reflectance models.
//
//   make_texts SHADER_FOLDER OUT_HEADER NAME=TEXT.glsl[+TEXT.glsl...]...
//
// The texts after a name become `template <class T> struct NAME`, their uniforms data members with their defaults.
#include "core/reflectance/cpp_text.h"
#include "tools/contents.h"

#include <algorithm>
#include <fstream>
#include <iostream>
#include <sstream>

namespace {

int run(const std::string& folder, const std::string& header, char** pairs, int count)
{
    std::ofstream out(header);
    out << "// Made by tools/make_texts from the shared texts under shaders; do not edit.\n#pragma once\n\n"
           "#include \"core/math/texels.h\"\n#include \"core/math/text_functions.h\"\n\nnamespace reflectance::texts "
           "{\n";
    for (int i = 0; i < count; ++i) {
        const std::string pair = pairs[i];
        const std::size_t equals = std::min(pair.find('='), pair.size());
        out << "\ntemplate <class T> struct " << pair.substr(0, equals) << " {\n";
        std::istringstream paths(pair.substr(std::min(equals + 1, pair.size())));
        bool any = false;
        for (std::string path; std::getline(paths, path, '+'); any = true) {
            const std::string code = reflectance::tools::contents(folder + "/" + path);
            if (code.empty()) {
                std::cerr << "make_texts: " << path << " is no text under " << folder << '\n';
                return 1;
            }
            out << "#line 1 \"shaders/" << path << "\"\n" << reflectance::instantiated(code);
        }
        out << "};\n";
        if (!any) {
            std::cerr << "make_texts: " << pair << " names no text\n";
            return 1;
        }
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
