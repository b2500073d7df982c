// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "base/progress_range.hpp"

#include <counterpart/geodesic/distances.hpp>

#include <span>

#include <Eigen/Core>

namespace counterpart::geodesic {

/// As distance_rows, in floats, and at most `unreachable`. Row i belongs to sources[i].
Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> finite_distance_rows(
    const DistanceGraph& graph, std::span<const Index> sources, float unreachable,
    const ProgressRange& progress = {});

}  // namespace counterpart::geodesic
