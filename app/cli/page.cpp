#include "app/cli/page.h"

#include "core/base/file.h"

#include <filesystem>

namespace reflectance::cli {

Result<void> writePage(const std::string& path, const std::vector<Drawing>& drawings,
                       const std::function<std::string(const std::string& images)>& textWith)
{
    namespace fs = std::filesystem;
    const std::string prefix = "images/" + fs::path(path).stem().string() + "-";
    std::error_code failed; // writing says what is wrong with the folder
    fs::create_directories(fs::path(path).parent_path() / "images", failed);
    for (const Drawing& drawing : drawings) {
        const fs::path file = fs::path(path).parent_path() / (prefix + drawing.name + ".svg");
        if (auto written = writeAtomically(file.string(), svgOf(drawing.chart, 760, 460)); !written)
            return written;
    }
    return writeAtomically(path, textWith(prefix));
}

} // namespace reflectance::cli
