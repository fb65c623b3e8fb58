// A file of lines, one for each job and in the order of the jobs: what is there is done, and a run that was killed goes on
// behind it.
#pragma once

#include "core/base/result.h"

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace reflectance {

class Journal {
public:
    struct Form {
        std::string head; ///< the first line, its end included
        /// Whether a line, without its end, is that of job `number`. Called for those that are there, in order.
        std::function<bool(std::uint64_t number, std::string_view line)> isOurs;
        std::string foreign; ///< the sentence for a file that is not
    };

    /// Opens or begins the file for this process alone, drops a torn last line, and refuses a file that is not of this form.
    [[nodiscard]] static Result<Journal> open(const std::string& path, const Form& form);
    Journal(Journal&& other) noexcept;
    Journal& operator=(Journal&& other) noexcept;
    ~Journal();

    [[nodiscard]] std::uint64_t lines() const { return lines_; } ///< without the head
    /// One write of the whole line, which brings its end.
    [[nodiscard]] Result<void> append(const std::string& line);

private:
    explicit Journal(std::string path) : path_(std::move(path)) {}
    [[nodiscard]] Result<void> write(const std::string& line) const;

    std::string path_;
    int file_ = -1;
    std::uint64_t lines_ = 0;
};

} // namespace reflectance
