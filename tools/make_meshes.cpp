// Writes the stock meshes of meshes/: run it after a change to their formulas and commit what it writes.
#include "tools/meshes/stock.h"

#include <filesystem>
#include <fstream>
#include <iostream>

int main(int argc, char** argv)
{
    if (argc != 2) {
        std::cerr << "usage: make_meshes FOLDER\n";
        return 2;
    }
    for (const auto& mesh : reflectance::stock::all()) {
        const std::filesystem::path file = std::filesystem::path(argv[1]) / (mesh.name + ".obj");
        const std::string text = reflectance::stock::objText(mesh.make(), mesh.title, mesh.decimals);
        std::ofstream out(file, std::ios::binary);
        out << text;
        if (!out.flush()) {
            std::cerr << "make_meshes: " << file.string() << " cannot be written\n";
            return 1;
        }
        std::cout << file.string() << ": " << text.size() << " bytes\n";
    }
    return 0;
}
