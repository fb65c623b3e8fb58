// What other programs want to know of the command line, made from the same tables as --help: a man page, and what bash
// completes.
#pragma once

#include <CLI/App.hpp>
#include <string>

namespace reflectance::cli {

/// The page in troff's man macros, for section 1.
[[nodiscard]] std::string manPage(const CLI::App& program, const std::string& version);

/// A script for bash-completion: verbs, flags, and the values of flags that take one of a few words.
[[nodiscard]] std::string bashCompletion(const CLI::App& program);

} // namespace reflectance::cli
