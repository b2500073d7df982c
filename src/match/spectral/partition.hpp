// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "base/progress_range.hpp"

#include <counterpart/geodesic/distances.hpp>

#include <span>

namespace counterpart::spectral_match {

/// V x samples: smooth bumps of the given geodesic radius around the samples, each row divided by its sum. A
/// vertex out of reach of all samples gets the sample named in `nearest` alone.
SparseMatrix partition_of_unity(const DistanceGraph& graph, std::span<const Index> samples,
                                std::span<const Index> nearest, double radius,
                                const ProgressRange& progress = {});

}  // namespace counterpart::spectral_match
