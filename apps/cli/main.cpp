// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "commands.hpp"
#include "interrupt.hpp"

#include <counterpart/base/progress.hpp>

#include <cstdio>
#include <exception>
#include <new>

#include <CLI/CLI.hpp>

int main(int argc, char** argv) {
    CLI::App program{"Which point of mesh B is this point of mesh A?", "counterpart"};
    program.set_version_flag("--version", COUNTERPART_VERSION);
    program.require_subcommand(1);
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
    counterpart::cli::add_morph(program);
    counterpart::cli::add_align(program);
    counterpart::cli::add_view(program);
    counterpart::cli::cancel_on_interrupt();
    try {
        program.parse(argc, argv);
        return 0;
    } catch (const CLI::ParseError& error) {
        // 0 for --help and --version; 2 for a command line that cannot be understood.
        return program.exit(error) == 0 ? 0 : 2;
    } catch (const counterpart::Canceled&) {
        std::fputs("interrupted\n", stderr);
        return counterpart::cli::interrupted_code;
    } catch (const std::bad_alloc&) {
        std::fputs("error: out of memory\n", stderr);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "error: %s\n", error.what());
    }
    return 1;
}
