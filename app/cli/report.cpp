#include "app/cli/report.h"

#include "app/cli/verbs.h"
#include "core/base/file.h"

#include <iostream>
#include <nlohmann/json.hpp>

namespace reflectance::cli {

Result<void> writeReport(const std::string& target, const nlohmann::ordered_json& report)
{
    if (target.empty())
        return {};
    const std::string text = report.dump(2) + "\n";
    if (target != "-")
        return writeAtomically(target, text);
    std::cout << text << std::flush;
    return {};
}

int refused(const Error& error, int exitCode)
{
    std::cerr << "reflectance: " << error.sentence() << '\n';
    return exitCode;
}

} // namespace reflectance::cli
