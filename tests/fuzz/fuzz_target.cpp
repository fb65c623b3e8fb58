// What libFuzzer calls: one program per reader (FUZZ_READER names it). A broken promise stops it like a crash.
#include "tests/fuzz/readers.h"

#include <cstdint>
#include <cstdlib>
#include <iostream>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    static const reflectance::fuzz::Reader& reader = *reflectance::fuzz::findReader(FUZZ_READER);
    const auto outcome = reader.read({reinterpret_cast<const char*>(data), size});
    if (!outcome.broken.empty()) {
        std::cerr << outcome.broken << '\n';
        std::abort();
    }
    return 0;
}
