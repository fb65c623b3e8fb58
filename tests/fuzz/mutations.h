// Damages a good file the way disks, networks, editors and exporters do: the same damage for the same seed.
#pragma once

#include <random>
#include <string>

namespace reflectance::fuzz {

/// One to four damages to `file`: changed bits, a lost end, a lost or repeated piece, a word said twice, a number for
/// another, four bytes for a treacherous number, a piece of `other`.
[[nodiscard]] std::string damaged(std::string file, const std::string& other, std::mt19937_64& random);

} // namespace reflectance::fuzz
