// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// One function per subcommand, each in a file of its name; main.cpp calls them all.
#pragma once

#include <CLI/CLI.hpp>

namespace counterpart::cli {

void add_blendshapes(CLI::App& program);
void add_convert(CLI::App& program);
void add_deform(CLI::App& program);
void add_descriptors(CLI::App& program);
void add_distances(CLI::App& program);
void add_evaluate(CLI::App& program);
void add_fit(CLI::App& program);
void add_inspect(CLI::App& program);
void add_landmarks(CLI::App& program);
void add_manual(CLI::App& program);
void add_map(CLI::App& program);
void add_match(CLI::App& program);
void add_align(CLI::App& program);
void add_morph(CLI::App& program);
void add_project(CLI::App& program);
void add_view(CLI::App& program);
void add_reorder(CLI::App& program);
void add_spectrum(CLI::App& program);
void add_transfer(CLI::App& program);
void add_render(CLI::App& program);

}  // namespace counterpart::cli
