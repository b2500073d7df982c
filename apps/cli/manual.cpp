// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// The program about itself: completions for shells and the man page, from the same descriptions as --help.
#include "commands.hpp"
#include "console.hpp"

#include <memory>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace counterpart::cli {
namespace {

struct Described {
    std::string name;  // "match", "map invert"
    const CLI::App* command;
};

std::vector<Described> commands_of(const CLI::App& program) {
    std::vector<Described> result;
    for (const CLI::App* command : program.get_subcommands({})) {
        result.push_back({command->get_name(), command});
        for (const CLI::App* operation : command->get_subcommands({}))
            result.push_back({command->get_name() + " " + operation->get_name(), operation});
    }
    return result;
}

std::vector<std::string> long_options(const CLI::App& command) {
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options())
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    return names;
}

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

std::string bash_completion(const CLI::App& program) {
    std::string names, cases;
    for (const auto& [name, command] : commands_of(program)) {
        if (name.find(' ') != std::string::npos) continue;
        names += " " + name;
        std::vector<std::string> words = long_options(*command);
        for (const CLI::App* operation : command->get_subcommands({})) words.push_back(operation->get_name());
        cases += fmt::format("    {}) words=\"{}\" ;;\n", name, fmt::join(words, " "));
    }
    return fmt::format(
        "_counterpart() {{\n"
        "  local word=${{COMP_WORDS[COMP_CWORD]}} words=\"\"\n"
        "  if [ \"$COMP_CWORD\" -eq 1 ]; then\n"
        "    COMPREPLY=($(compgen -W \"{}\" -- \"$word\"))\n"
        "    return\n"
        "  fi\n"
        "  case ${{COMP_WORDS[1]}} in\n{}  esac\n"
        "  COMPREPLY=($(compgen -W \"$words\" -- \"$word\") $(compgen -f -- \"$word\"))\n"
        "}}\n"
        "complete -o filenames -F _counterpart counterpart\n",
        names, cases);
}

std::string quoted(const std::string& text) {
    std::string result;
    for (const char c : first_line(text)) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return "'" + result + "'";
}

std::string zsh_completion(const CLI::App& program) {
    std::string names, cases;
    for (const auto& [name, command] : commands_of(program)) {
        if (name.find(' ') != std::string::npos) continue;
        names += fmt::format("    {}\n", quoted(name + ":" + command->get_description()));
        cases +=
            fmt::format("    {}) compadd -- {}; _files ;;\n", name, fmt::join(long_options(*command), " "));
    }
    return fmt::format(
        "#compdef counterpart\n"
        "_counterpart() {{\n"
        "  local -a commands\n  commands=(\n{}  )\n"
        "  if (( CURRENT == 2 )); then _describe command commands; return; fi\n"
        "  case $words[2] in\n{}  esac\n"
        "}}\n"
        "_counterpart \"$@\"\n",
        names, cases);
}

std::string fish_completion(const CLI::App& program) {
    std::string text;
    for (const auto& [name, command] : commands_of(program)) {
        if (name.find(' ') != std::string::npos) continue;
        text += fmt::format("complete -c counterpart -n __fish_use_subcommand -f -a {} -d {}\n", name,
                            quoted(command->get_description()));
        for (const CLI::Option* option : command->get_options())
            for (const std::string& word : option->get_lnames())
                text +=
                    fmt::format("complete -c counterpart -n '__fish_seen_subcommand_from {}' -l {} -d {}\n",
                                name, word, quoted(option->get_description()));
    }
    return text;
}

// Hyphens that are minus signs, and backslashes, in roff.
std::string roff(const std::string& text) {
    std::string result;
    for (const char c : text) {
        if (c == '\\') {
            result += "\\e";
        } else if (c == '-') {
            result += "\\-";
        } else if (c == '\n') {
            result += "\n.br\n";
        } else {
            result += c;
        }
    }
    return result.starts_with('.') ? "\\&" + result : result;
}

// What follows an option's name, as --help shows it.
std::string value_of(const CLI::Option& option) {
    const std::string& text = option.get_option_text();
    return text.empty() ? option.get_type_name() : text;
}

std::string man_page(const CLI::App& program) {
    std::string text = fmt::format(
        ".TH COUNTERPART 1 \"\" \"counterpart {}\"\n.SH NAME\ncounterpart \\- dense correspondence of "
        "triangle "
        "meshes\n.SH SYNOPSIS\n.B counterpart\n.I COMMAND\n[options]\n.SH COMMANDS\n",
        COUNTERPART_VERSION);
    for (const auto& [name, command] : commands_of(program)) {
        text += fmt::format(".SS {}\n{}.\n", roff(name), roff(command->get_description()));
        for (const CLI::Option* option : command->get_options()) {
            const std::string value = value_of(*option);
            text += fmt::format(".TP\n.B {}{}\n{}\n", roff(option->get_name(false, true)),
                                value.empty() ? "" : " \\fI" + roff(value) + "\\fR",
                                roff(option->get_description()));
        }
    }
    return text +
           ".SH EXIT STATUS\n0 done; 1 refused, with a sentence that says why; 2 the command line is wrong; "
           "3 an "
           "output could not be written; 130 interrupted.\n";
}

}  // namespace

void add_manual(CLI::App& program) {
    auto shell = std::make_shared<std::string>();
    CLI::App* manual = program.add_subcommand(
        "manual",
        "Print the man page, or completions for a shell: put 'counterpart manual bash' into a file");
    manual->add_option("FORM", *shell, "man, bash, zsh or fish. Default: man")
        ->check(one_of({"man", "bash", "zsh", "fish"}));
    manual->callback([&program, shell] {
        if (*shell == "bash") return print(bash_completion(program));
        if (*shell == "zsh") return print(zsh_completion(program));
        if (*shell == "fish") return print(fish_completion(program));
        print(man_page(program));
    });
}

}  // namespace counterpart::cli
