// A numbered file for one running program. A lock that the system releases however the program ends tells the file of
// a program that still runs from one that was left behind, so programs that run together never share a file.
#pragma once

#include "core/base/result.h"

#include <filesystem>
#include <vector>

namespace reflectance::explorer {

/// `folder`/session-N.json, held by this program as long as the value lives.
class SessionSlot {
public:
    /// The first N that no other program holds and that has no file yet. Makes the folder where it is missing.
    [[nodiscard]] static Result<SessionSlot> takeFree(const std::filesystem::path& folder);

    /// Every file whose program is gone, newest first. A missing or unreadable folder holds none.
    [[nodiscard]] static std::vector<SessionSlot> takeAbandoned(const std::filesystem::path& folder);

    SessionSlot(SessionSlot&& other) noexcept;
    SessionSlot& operator=(SessionSlot&& other) noexcept;
    ~SessionSlot(); ///< lets go of the file, which stays: the next program may take it over

    [[nodiscard]] const std::filesystem::path& file() const { return file_; }
    void removeFile() const;

private:
    SessionSlot(std::filesystem::path file, int lock) : file_(std::move(file)), lock_(lock) {}
    friend struct Attempt;

    std::filesystem::path file_;
    int lock_ = -1; ///< descriptor of the locked file; -1 once moved from
};

} // namespace reflectance::explorer
