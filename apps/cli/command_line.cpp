// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "command_line.hpp"

#include "checks.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <regex>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace counterpart::cli {
namespace {

// Options whose value may be left out, and what it is then.
constexpr std::array<std::pair<const char*, const char*>, 1> optional_values = {{{"--weld", "0"}}};

bool starts_number(const std::string& word) {
    const std::size_t first = word.starts_with('-') ? 1 : 0;
    return word.size() > first &&
           (std::isdigit(static_cast<unsigned char>(word[first])) != 0 || word[first] == '.');
}

// Parts of the parser's own messages, which are no sentences, and what to say instead.
const std::vector<std::pair<std::regex, const char*>>& rewordings() {
    static const std::vector<std::pair<std::regex, const char*>> table = {
        {std::regex(R"(^(--?[\w-]+|[A-Z]+): (must .*)$)"), "$1 $2"},
        {std::regex(R"(^Could not convert: (\S+) = (.*)$)"), "$1 must be a number, not '$2'"},
        {std::regex(R"(^(\S+): Value (.*) not in range (.*) to (.*)$)"),
         "$1 must be from $3 to $4, not '$2'"},
        {std::regex(R"(^(\S+): (\S+) not in \{(.*)\}$)"), "$1 must be one of $3, not '$2'"},
        {std::regex(R"(^(\S+): \d+ required .* missing.*$)"), "$1 needs a value"},
        {std::regex(R"(^(\S+) requires (\S+)$)"), "$1 needs $2"},
        {std::regex(R"(^(\S+) excludes (\S+)$)"), "$1 and $2 cannot be given together"},
        {std::regex(R"(^(\S+) is required$)"), "$1 is missing"},
        {std::regex(R"(^The following arguments? (?:was|were) not expected: (.*)$)"),
         "one name too many: $1"}};
    return table;
}

std::string reworded(const std::string& message) {
    for (const auto& [pattern, words] : rewordings())
        if (std::regex_match(message, pattern)) return std::regex_replace(message, pattern, words);
    return message;
}

const CLI::App* command_of(const CLI::App& program, const std::string& name) {
    for (const CLI::App* command : program.get_subcommands({}))
        if (command->get_name() == name) return command;
    return nullptr;
}

std::vector<std::string> command_names(const CLI::App& program) {
    std::vector<std::string> names;
    for (const CLI::App* command : program.get_subcommands({})) names.push_back(command->get_name());
    return names;
}

bool takes_value(const CLI::App& command, const std::string& word) {
    const CLI::Option* option = command.get_option_no_throw(word);
    return option != nullptr && option->get_items_expected_min() > 0;
}

// The first word that looks like an option of the command and is none.
std::string unknown_option(const CLI::App& command, const std::vector<std::string>& words,
                           std::size_t first) {
    for (std::size_t i = first; i < words.size(); ++i) {
        const std::string name = words[i].substr(0, words[i].find('='));
        if (name == "--") return "";
        const bool is_long = name.size() > 2 && name.starts_with("--");
        const bool is_short =
            name.size() > 1 && name[0] == '-' && std::isalpha(static_cast<unsigned char>(name[1])) != 0;
        if (!is_long && !is_short) continue;
        if (is_short && i > 0 && takes_value(command, words[i - 1])) continue;
        if (command.get_option_no_throw(is_short ? name.substr(0, 2) : name) == nullptr) return name;
    }
    return "";
}

std::vector<std::string> option_names(const CLI::App& command) {
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options())
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    return names;
}

}  // namespace

std::vector<std::string> words_of(const std::vector<std::string>& command_line) {
    std::vector<std::string> words(command_line.begin() + (command_line.empty() ? 0 : 1), command_line.end());
    for (std::size_t i = 0; i < words.size(); ++i)
        for (const auto& [option, value] : optional_values)
            if (words[i] == option && (i + 1 == words.size() || !starts_number(words[i + 1])))
                words[i] += fmt::format("={}", value);
    return words;
}

std::string sentence_of(const CLI::App& program, const CLI::ParseError& error,
                        const std::vector<std::string>& words) {
    const auto first = std::find_if(words.begin(), words.end(),
                                    [](const std::string& word) { return !word.starts_with("-"); });
    const auto told = [](const std::string& sentence, const std::string& help) {
        return fmt::format("{}{} See '{} --help'.", sentence, sentence.ends_with('?') ? "" : ".", help);
    };
    if (first == words.end()) {
        const std::string unknown = unknown_option(program, words, 0);
        if (unknown.empty()) return told("give a command", "counterpart");
        return told(
            fmt::format("there is no option '{}'{}", unknown, suggestion(unknown, {"--help", "--version"})),
            "counterpart");
    }
    const CLI::App* command = command_of(program, *first);
    if (command == nullptr)
        return told(
            fmt::format("there is no command '{}'{}", *first, suggestion(*first, command_names(program))),
            "counterpart");
    auto rest = static_cast<std::size_t>(first - words.begin()) + 1;
    std::string help = "counterpart " + command->get_name();
    if (!command->get_subcommands({}).empty()) {
        const CLI::App* operation = rest < words.size() ? command_of(*command, words[rest]) : nullptr;
        if (operation == nullptr)
            return told(
                fmt::format("'{}' needs one of {}{}", command->get_name(),
                            fmt::join(command_names(*command), ", "),
                            rest < words.size() ? suggestion(words[rest], command_names(*command)) : ""),
                help);
        command = operation;
        help += " " + words[rest++];
    }
    const std::string unknown = unknown_option(*command, words, rest);
    if (unknown.empty()) return told(reworded(error.what()), help);
    return told(fmt::format("'{}' has no option '{}'{}", command->get_name(), unknown,
                            suggestion(unknown, option_names(*command))),
                help);
}

}  // namespace counterpart::cli
