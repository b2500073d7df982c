// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// What every command shares with the person at the terminal: common options, messages, progress, the JSON
// report.
#pragma once

#include <counterpart/base/progress.hpp>
#include <counterpart/io/attributed_mesh_file.hpp>
#include <counterpart/io/mesh_file.hpp>

#include <filesystem>
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
    std::filesystem::path report;
};
void add_common_options(CLI::App& command, CommonOptions& options);

/// One line on stderr, unless --quiet.
void say(const CommonOptions& options, const std::string& message);
/// "warning: ..." on stderr, also with --quiet.
void warn(const std::string& message);

/// Reads a mesh and says its notices, each led by the file's name.
TriangleMesh load_mesh(const std::filesystem::path& file, const CommonOptions& options);
/// The same, with all that the file holds beside the triangles.
AttributedMesh load_attributed_mesh(const std::filesystem::path& file, const CommonOptions& options);

/// A bar on stderr that appears after a second of work; silent when stderr is not a terminal or with --quiet.
Progress progress_bar(const std::string& label, const CommonOptions& options);

/// Writes the report if --report was given. Adds nothing: what is in `report` is what appears.
void write_report(const Json& report, const CommonOptions& options);

Json to_json(const std::vector<StageTime>& stages);

}  // namespace counterpart::cli
