// The container of RGL's files: named arrays of numbers with their shapes. Internal to the readers.
#pragma once

#include "core/base/result.h"

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace reflectance {

/// One array; its numbers still lie in the bytes of the file.
struct Tensor {
    int type = 0; ///< 1..11: u8 i8 u16 i16 u32 i32 u64 i64 f16 f32 f64
    std::vector<std::size_t> shape;
    std::string_view bytes;

    [[nodiscard]] std::size_t count() const;
};

inline constexpr std::string_view tensorFileMagic{"tensor_file\0", 12};

using TensorFile = std::map<std::string, Tensor, std::less<>>;

/// Every offset and size is checked against the file; `file` is for sentences.
[[nodiscard]] Result<TensorFile> parseTensorFile(std::string_view bytes, const std::string& file);

} // namespace reflectance
