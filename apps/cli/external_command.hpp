// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace counterpart::cli {

/// If the first word names no command of the program, `counterpart-WORD` takes over with the words after it,
/// where it lies beside the program or on the PATH. Otherwise it returns: a sentence that says which package
/// brings the command, or an empty one.
std::string run_external_command(const CLI::App& program, const std::vector<std::string>& words);

}  // namespace counterpart::cli
