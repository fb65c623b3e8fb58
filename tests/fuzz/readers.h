// Every reader of the program behind one face: bytes in, whether they were accepted and which promise was broken out.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace reflectance::fuzz {

struct Outcome {
    bool accepted = false;
    std::string broken; ///< the promise that was not kept, with the sentence in question; empty: all kept
};

struct Reader {
    std::string_view name; ///< "obj"
    Outcome (*read)(std::string_view bytes);
    std::vector<std::string> seeds; ///< good files of this format, small, each with something of its own
};

[[nodiscard]] const std::vector<Reader>& readers();

/// The reader of that name; nullptr if there is none.
[[nodiscard]] const Reader* findReader(std::string_view name);

} // namespace reflectance::fuzz
