// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "load_map.hpp"

#include <counterpart/io/landmark_points.hpp>

#include <optional>
#include <string>

#include <CLI/CLI.hpp>

namespace counterpart::cli {

/// The files of --landmarks and --target-landmarks; empty: none.
struct KnownPairsFiles {
    std::filesystem::path pairs;       // or, where there is the other, the source's points
    std::filesystem::path target;      // the target's points, of the same names
    std::optional<Anatomical> axes{};  // that points are turned to

    /// Throws InvalidInput if one is missing that the other needs.
    Landmarks read(MeshView source, MeshView target_mesh) const;
};

/// The option --landmark-axes.
CLI::Option* add_landmark_axes(CLI::App& command, std::optional<Anatomical>& axes);
/// The options, in a group of the help; `purpose` says what the pairs are for.
void add_known_pairs(CLI::App& command, KnownPairsFiles& known, const std::string& purpose,
                     const std::string& group = "Options");
/// Their files, to be checked with the command's others.
FileArguments files_of(KnownPairsFiles& known);

}  // namespace counterpart::cli
