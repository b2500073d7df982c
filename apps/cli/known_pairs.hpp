// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "load_map.hpp"

#include <CLI/CLI.hpp>

namespace counterpart::cli {

/// The files of --landmarks and --target-landmarks; empty: none.
struct KnownPairsFiles {
    std::filesystem::path pairs;   // or, where there is the other, the source's points
    std::filesystem::path target;  // the target's points, of the same names

    /// Throws InvalidInput if one is missing that the other needs.
    Landmarks read(MeshView source, MeshView target_mesh) const;
};

/// The two options, in a group of the help; `purpose` says what the pairs are for.
void add_known_pairs(CLI::App& command, KnownPairsFiles& known, const std::string& purpose,
                     const std::string& group = "Options");
/// Their files, to be checked with the command's others.
FileArguments files_of(KnownPairsFiles& known);

}  // namespace counterpart::cli
