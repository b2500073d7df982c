// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// What every command shares with the person at the terminal: common options, messages, progress, the JSON
// report.
#pragma once

#include "checks.hpp"
#include "files.hpp"
#include "kept_streams.hpp"

#include <counterpart/base/progress.hpp>
#include <counterpart/io/mesh_file.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

namespace counterpart::cli {

using Json = nlohmann::ordered_json;

/// Options that every command has.
struct CommonOptions {
    int threads = 0;
    bool quiet = false;
    ReadOptions read;
    std::filesystem::path report;
    FileArguments files;  // that the command reads and writes
};
void add_common_options(CLI::App& command, CommonOptions& options);

/// Runs `run` when the command is given, after its files were checked.
template <class Run>
void on_run(CLI::App& command, CommonOptions& options, Run run) {
    command.callback([&options, run] {
        check_files(options.files);
        const KeptStreams kept(options.files);
        run();
    });
}

/// "1 component", "2 components".
std::string counted(Index count, const std::string& noun);
/// A number that people read: three digits, never an exponent for what is not tiny or huge.
std::string readable(double number);
/// "12 %", and "less than 1 %" of what is not nothing.
std::string rounded_percent(double share);

/// One line on stderr, unless --quiet.
void say(const CommonOptions& options, const std::string& message);
/// On standard output, unless --quiet: what a command is asked for that writes no file.
void print(const CommonOptions& options, const std::string& text);
/// "warning: ..." on stderr, also with --quiet.
void warn(const std::string& message);
/// Reads a mesh and prints its notices, each prefixed with the file's name.
TriangleMesh load_mesh(const MeshInput& mesh, const CommonOptions& options);
/// The same, with the attributes that the file holds.
AttributedMesh load_attributed_mesh(const MeshInput& mesh, const CommonOptions& options);

/// Whether the format that the name tells is one that solids are written in.
bool holds_tetrahedra(const std::filesystem::path& file);
/// The tetrahedra of a file that has any, with its notices printed.
std::optional<TetrahedralMesh> load_solid(const MeshInput& mesh, const CommonOptions& options);
/// Both, if both files have tetrahedra: then solids are meant, else the surface of one that has them.
std::optional<std::pair<TetrahedralMesh, TetrahedralMesh>> load_solids(const MeshInput& source,
                                                                       const MeshInput& target,
                                                                       const CommonOptions& options);

/// A bar on stderr that appears after a second of work; silent when stderr is not a terminal or with --quiet.
/// Cancels the work when the user interrupts the program.
Progress progress_bar(const std::string& label, const CommonOptions& options);

/// Writes the report, the objects that were chosen, and the most memory held, if --report was given.
void write_report(const Json& report, const CommonOptions& options);

Json to_json(const std::vector<StageTime>& stages);

}  // namespace counterpart::cli
