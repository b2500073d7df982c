// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "external_command.hpp"

#include "platform/process.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

namespace counterpart::cli {
namespace {

// Commands that the Python package brings, and the extra that each needs.
constexpr std::array<std::pair<const char*, const char*>, 3> python_commands = {
    {{"collection", "collection"}, {"retrieve", "collection"}, {"import", "scenes"}}};

// A word that can name no file elsewhere.
bool is_plain(const std::string& word) {
    return !word.empty() && std::all_of(word.begin(), word.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
    }) && word.front() != '-';
}

bool is_command(const CLI::App& program, const std::string& word) {
    const auto commands = program.get_subcommands({});
    return std::any_of(commands.begin(), commands.end(),
                       [&](const CLI::App* command) { return command->get_name() == word; });
}

}  // namespace

std::string run_external_command(const CLI::App& program, const std::vector<std::string>& words) {
    if (words.empty() || !is_plain(words.front()) || is_command(program, words.front())) return "";
    std::vector<std::string> given(words);
    given.front() = "counterpart-" + words.front();
    platform::replace_by_program(std::move(given));
    for (const auto& [command, extra] : python_commands)
        if (words.front() == command)
            return fmt::format("'{}' is a command of the Python package: pip install 'counterpart3d[{}]'",
                               command, extra);
    return "";
}

}  // namespace counterpart::cli
