// One function per verb: it adds the verb's flags to the program and, when the verb was given, does its work.
#pragma once

#include "core/base/result.h"

#include <CLI/App.hpp>
#include <string>

namespace reflectance::cli {

/// Exit codes that scripts rely on.
enum ExitCode { Done = 0, DoesNotHold = 1, BadInput = 2 };

/// Prints "reflectance: FILE:LINE: sentence" on stderr and returns the exit code.
int refused(const Error& error, int exitCode = BadInput);

/// Each verb stores its result in `exitCode`.
void addRender(CLI::App& program, int& exitCode);
void addEval(CLI::App& program, int& exitCode);
void addModels(CLI::App& program, int& exitCode);
void addSurfaces(CLI::App& program, int& exitCode);
void addInspect(CLI::App& program, int& exitCode);
void addCompare(CLI::App& program, int& exitCode);
void addExtremes(CLI::App& program, int& exitCode);
void addCheck(CLI::App& program, int& exitCode);
void addMatrix(CLI::App& program, int& exitCode);
void addTable(CLI::App& program, int& exitCode);
void addBench(CLI::App& program, int& exitCode);
void addFit(CLI::App& program, int& exitCode);
void addSweep(CLI::App& program, int& exitCode);
/// `command`: as it was typed, for the report.
void addTrade(CLI::App& program, const std::string& command, int& exitCode);
void addGoniometer(CLI::App& program, int& exitCode);
void addExport(CLI::App& program, int& exitCode);

} // namespace reflectance::cli
