// Small good files of every format, made here, from which damaged ones grow.
#pragma once

#include <string>
#include <vector>

namespace reflectance::fuzz {

[[nodiscard]] std::vector<std::string> objSeeds();
[[nodiscard]] std::vector<std::string> plySeeds();
[[nodiscard]] std::vector<std::string> offSeeds();
[[nodiscard]] std::vector<std::string> stlSeeds();
[[nodiscard]] std::vector<std::string> sceneSeeds();
[[nodiscard]] std::vector<std::string> sessionSeeds(); ///< what pictures carry
[[nodiscard]] std::vector<std::string> keptSeeds();    ///< pictures that carry it
[[nodiscard]] std::vector<std::string> pngSeeds();
[[nodiscard]] std::vector<std::string> exrSeeds();
[[nodiscard]] std::vector<std::string> pfmSeeds();
[[nodiscard]] std::vector<std::string> hdrSeeds();
[[nodiscard]] std::vector<std::string> rowSeeds();
[[nodiscard]] std::vector<std::string> modelSeeds();

} // namespace reflectance::fuzz
