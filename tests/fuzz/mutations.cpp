#include "tests/fuzz/mutations.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace reflectance::fuzz {
namespace {

using Random = std::mt19937_64;

constexpr std::string_view numerals = "+-.0123456789";

/// 0 .. count - 1. The remainder favours small numbers by less than count / 2^64; std's distributions differ between
/// libraries.
std::size_t below(std::size_t count, Random& random)
{
    return count == 0 ? 0 : static_cast<std::size_t>(random() % count);
}

void changeBits(std::string& file, Random& random)
{
    for (std::size_t times = 1 + below(8, random); times > 0 && !file.empty(); --times) {
        char& byte = file[below(file.size(), random)];
        byte = static_cast<char>(byte ^ (1 << below(8, random)));
    }
}

// Each draw has a statement of its own: the order in which arguments are evaluated differs between compilers.

void losePiece(std::string& file, Random& random)
{
    const std::size_t at = below(file.size(), random);
    file.erase(at, 1 + below(64, random));
}

/// Up to 64 bytes of `source`, anywhere into `file`.
void insertPiece(std::string& file, const std::string& source, Random& random)
{
    const std::size_t from = below(source.size(), random);
    const std::string piece = source.substr(from, 1 + below(64, random));
    file.insert(below(file.size() + 1, random), piece);
}

void repeatWord(std::string& file, Random& random)
{
    const std::size_t at = below(file.size(), random);
    const std::size_t first = std::min(file.find_first_not_of(" \t\r\n,;:/", at), file.size());
    const std::size_t last = std::min(file.find_first_of(" \t\r\n,;:/", first), file.size());
    const std::string word = file.substr(first, last - first);
    for (std::size_t times = 1 + below(4, random); times > 0; --times)
        file.insert(last, " " + word);
}

void changeNumber(std::string& file, Random& random)
{
    static constexpr std::array<std::string_view, 24> numbers{
        "0",    "-0",    "-1",   "2",      "3",         "1000000", "4294967295", "4294967296", "9223372036854775807",
        "1e19", "1e-20", "1e30", "1e-320", "1.8e308",   "1e999",   "-1e999",     "nan",        "inf",
        "-inf", "0x1p3", "1.",   ".",      "-99999999", ""};
    const std::size_t first = file.find_first_of(numerals, below(file.size(), random));
    if (first == std::string::npos)
        return;
    const std::size_t last = std::min(file.find_first_not_of(numerals, first), file.size());
    file.replace(first, last - first, numbers[below(numbers.size(), random)]);
}

/// Counts, indices and floats of binary files: the largest and smallest, the least that is negative, NaN, infinity.
void changeFourBytes(std::string& file, Random& random)
{
    static constexpr std::array<std::string_view, 8> words{
        std::string_view("\0\0\0\0", 4),         std::string_view("\xFF\xFF\xFF\xFF", 4),
        std::string_view("\xFF\xFF\xFF\x7F", 4), std::string_view("\0\0\0\x80", 4),
        std::string_view("\0\0\xC0\x7F", 4),     std::string_view("\0\0\x80\x7F", 4),
        std::string_view("\x7F\x80\0\0", 4),     std::string_view("\1\0\0\0", 4)};
    if (file.size() < 4)
        return;
    const std::size_t at = below(file.size() - 3, random);
    file.replace(at, 4, words[below(words.size(), random)]);
}

void insertOddity(std::string& file, Random& random)
{
    static constexpr std::array<std::string_view, 12> oddities{
        "\xEF\xBB\xBF", "\xFF\xFE", std::string_view("\0", 1), "\r", "\n", "\\\n", "#", "\"", "[[[[[[[[", "{",
        "..",           "\xC3"};
    const std::size_t at = below(file.size() + 1, random);
    file.insert(at, oddities[below(oddities.size(), random)]);
}

void damageOnce(std::string& file, const std::string& other, Random& random)
{
    switch (below(9, random)) {
    case 0:
        return changeBits(file, random);
    case 1:
        return file.resize(below(file.size() + 1, random));
    case 2:
        return losePiece(file, random);
    case 3:
        return insertPiece(file, std::string(file), random);
    case 4:
        return insertPiece(file, other, random);
    case 5:
        return repeatWord(file, random);
    case 6:
        return changeFourBytes(file, random);
    case 7:
        return insertOddity(file, random);
    default:
        return changeNumber(file, random);
    }
}

} // namespace

std::string damaged(std::string file, const std::string& other, Random& random)
{
    for (std::size_t times = 1 + below(4, random); times > 0; --times)
        damageOnce(file, other, random);
    return file;
}

} // namespace reflectance::fuzz
