// write_seeds FOLDER: the seeds of every reader as files, where libFuzzer begins: FOLDER/obj/0, FOLDER/obj/1, ...
#include "tests/fuzz/readers.h"

#include <filesystem>
#include <fstream>
#include <iostream>

int main(int argc, char** argv)
{
    if (argc != 2) {
        std::cerr << "write_seeds FOLDER\n";
        return 2;
    }
    for (const auto& reader : reflectance::fuzz::readers()) {
        const std::filesystem::path folder = std::filesystem::path(argv[1]) / reader.name;
        std::filesystem::create_directories(folder);
        for (std::size_t i = 0; i < reader.seeds.size(); ++i) {
            std::ofstream file(folder / std::to_string(i), std::ios::binary);
            if (!file.write(reader.seeds[i].data(), static_cast<std::streamsize>(reader.seeds[i].size())))
                return 1;
        }
    }
    return 0;
}
