// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "external_command.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <system_error>

#include <fmt/format.h>
#include <unistd.h>

namespace counterpart::cli {
namespace {

// Commands that the Python package brings.
constexpr std::array<const char*, 2> python_commands = {"collection", "retrieve"};

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
    const std::string name = "counterpart-" + words.front();
    std::vector<std::string> given(words);
    given.front() = name;
    std::vector<char*> arguments;
    for (std::string& word : given) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    std::error_code none;
    const std::filesystem::path own = std::filesystem::read_symlink("/proc/self/exe", none);
    if (!none) execv((own.parent_path() / name).c_str(), arguments.data());
    execvp(name.c_str(), arguments.data());
    for (const char* const command : python_commands)
        if (words.front() == command)
            return fmt::format(
                "'{}' is a command of the Python package: pip install 'counterpart3d[collection]'", command);
    return "";
}

}  // namespace counterpart::cli
