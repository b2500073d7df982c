// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "numerics/assignment.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/match/assignment.hpp>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace counterpart {
namespace {

// A rough guess for poses that differ: 5000 vertices took half a minute to a minute and a half on one core.
double estimated_minutes(Index larger) { return std::pow(larger / 5000.0, 3); }

void require_size(MeshView source, MeshView target, Index max_vertices) {
    const Index larger = std::max(source.n_vertices(), target.n_vertices());
    if (larger <= max_vertices) return;
    const double gigabytes = 8e-9 * source.n_vertices() * target.n_vertices();
    throw InvalidInput(
        fmt::format("an optimal assignment of {} to {} vertices may take {:.0f} minutes and needs {:.1f} GB; "
                    "the limit is {} "
                    "vertices (raise it, or use another method)",
                    source.n_vertices(), target.n_vertices(), std::ceil(estimated_minutes(larger)), gigabytes,
                    max_vertices));
}

}  // namespace

AssignmentResult match_assignment(MeshView source, MeshView target, const AssignmentOptions& options) {
    require_valid(source);
    require_valid(target);
    require_size(source, target, options.max_vertices);
    const Eigen::RowVector3d offset = target.vertices.colwise().mean() - source.vertices.colwise().mean();
    Matrix cost(source.n_vertices(), target.n_vertices());
    for (Index v = 0; v < source.n_vertices(); ++v)
        cost.row(v) = (target.vertices.rowwise() - (source.vertices.row(v) + offset)).rowwise().squaredNorm();

    AssignmentResult result{{numerics::solve_assignment(cost, options.progress), target.n_vertices()}};
    for (Index v = 0; v < source.n_vertices(); ++v) {
        const Index image = result.target_from_source[v];
        if (image != VertexMap::unmatched) result.cost += cost(v, image);
    }
    return result;
}

}  // namespace counterpart
