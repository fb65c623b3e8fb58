// `compare A B` for two picture files: figures as a table or JSON, and the difference as a picture.
#pragma once

#include <optional>
#include <string>

namespace reflectance::cli {

struct CompareOptions {
    std::optional<double> threshold; ///< largest absolute difference that still holds
    std::string diff;                ///< PNG to write; empty for none
    std::string json;                ///< file, "-" for standard output instead of the table, empty for none
};

/// Done, DoesNotHold if the threshold is exceeded, BadInput with a sentence on stderr.
int comparePictures(const std::string& a, const std::string& b, const CompareOptions& options);

} // namespace reflectance::cli
