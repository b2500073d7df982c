// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "command_line.hpp"
#include "commands.hpp"
#include "exit_codes.hpp"
#include "external_command.hpp"
#include "interrupt.hpp"
#include "platform/process.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/base/progress.hpp>
#include <counterpart/io/mesh_file.hpp>

#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

int main(int argc, char** argv) {
    CLI::App program{"Which point of mesh B is this point of mesh A?", "counterpart"};
    program.set_version_flag("--version", COUNTERPART_VERSION);
    program.require_subcommand(1);
    const counterpart::MeshExtensions extensions = counterpart::mesh_extensions();
    program.footer(fmt::format(  // which every command inherits
        "Mesh files are read from {} and, as '-', standard input, and written to {}; solids to {}.",
        fmt::join(extensions.read, " "), fmt::join(extensions.written, " "),
        fmt::join(extensions.written_solids, " ")));
    counterpart::cli::add_convert(program);
    counterpart::cli::add_deform(program);
    counterpart::cli::add_inspect(program);
    counterpart::cli::add_match(program);
    counterpart::cli::add_spectrum(program);
    counterpart::cli::add_descriptors(program);
    counterpart::cli::add_distances(program);
    counterpart::cli::add_reorder(program);
    counterpart::cli::add_render(program);
    counterpart::cli::add_evaluate(program);
    counterpart::cli::add_project(program);
    counterpart::cli::add_transfer(program);
    counterpart::cli::add_landmarks(program);
    counterpart::cli::add_morph(program);
    counterpart::cli::add_align(program);
    counterpart::cli::add_fit(program);
    counterpart::cli::add_blendshapes(program);
    counterpart::cli::add_map(program);
    counterpart::cli::add_manual(program);
    counterpart::cli::add_view(program);
    const std::vector<std::string> words =
        counterpart::cli::words_of(counterpart::platform::command_line(argc, argv));
    const std::string missing = counterpart::cli::run_external_command(program, words);
    if (!missing.empty()) {
        std::fprintf(stderr, "error: %s\n", missing.c_str());
        return counterpart::cli::not_understood_code;
    }
    counterpart::cli::cancel_on_interrupt();
    try {
        program.parse(std::vector<std::string>(words.rbegin(), words.rend()));
        return 0;
    } catch (const CLI::Success& help) {  // --help, --version
        program.exit(help);
        return std::fflush(stdout) == 0 ? 0 : counterpart::cli::not_written_code;
    } catch (const CLI::ParseError& error) {
        std::fprintf(stderr, "error: %s\n", counterpart::cli::sentence_of(program, error, words).c_str());
        return counterpart::cli::not_understood_code;
    } catch (const counterpart::Canceled&) {
        std::fputs("interrupted\n", stderr);
        return counterpart::cli::interrupted_code;
    } catch (const counterpart::ClosedPipe&) {  // whoever reads has seen enough
        return counterpart::cli::not_written_code;
    } catch (const counterpart::WriteError& error) {
        std::fprintf(stderr, "error: %s\n", error.what());
        return counterpart::cli::not_written_code;
    } catch (const std::bad_alloc&) {
        std::fputs("error: out of memory\n", stderr);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "error: %s\n", error.what());
    }
    return counterpart::cli::refused_code;
}
