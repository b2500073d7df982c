// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// The ground truth on the command line: a true map, or two maps from the points of a template.
#pragma once

#include "files.hpp"
#include "load_map.hpp"

#include <counterpart/evaluation/evaluate.hpp>

#include <filesystem>
#include <optional>

#include <CLI/CLI.hpp>

namespace counterpart::cli {

struct TruthOptions {
    std::filesystem::path truth, source_truth, target_truth;
    int index_base = 0;

    bool given() const { return !truth.empty() || !source_truth.empty(); }
};
void add_truth_options(CLI::App& command, FileArguments& files, TruthOptions& options);

/// Nothing if no file is given. Throws IoError, and InvalidInput if the template's files do not fit each
/// other.
std::optional<GroundTruth> read_truth(const TruthOptions& options);

/// evaluate() of a map of either kind.
EvaluationReport evaluated(const LoadedMap& map, const GroundTruth& truth, const TriangleMesh& source,
                           const TriangleMesh& target, const EvaluationOptions& options);

/// Which vertex of a true pair.
enum class PairEnd { source, target };

/// For each vertex the mean error of the true pairs that it is in, x 100 / sqrt(target area). Only pairs that
/// could be measured count: NaN for a vertex without any, infinite where the map leads to another component.
Vector mean_vertex_errors(const GroundTruth& truth, const EvaluationReport& report, PairEnd end,
                          Index n_vertices);

}  // namespace counterpart::cli
