// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace counterpart::cli {

/// The words after the program's name, the first one, with values that may be left out filled in: `--weld`
/// alone is `--weld=0`, whatever follows it.
std::vector<std::string> words_of(const std::vector<std::string>& command_line);

/// What is wrong with the command line, as a sentence that names the nearest command or option.
std::string sentence_of(const CLI::App& program, const CLI::ParseError& error,
                        const std::vector<std::string>& words);

}  // namespace counterpart::cli
