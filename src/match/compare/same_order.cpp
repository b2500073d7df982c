// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/differences/lengths_fit.hpp"
#include "numerics/rank_correlation.hpp"

#include <counterpart/descriptor/descriptors.hpp>
#include <counterpart/match/compare.hpp>
#include <counterpart/mesh/measure.hpp>
#include <counterpart/spectral/eigen_basis.hpp>

namespace counterpart {
namespace {

// Whether both bulge and are hollow at the same vertices, as a surface and the same surface bent are.
bool curve_alike(MeshView source, MeshView target) {
    constexpr double least_correlation = 0.4;
    if (!(surface_area(source) > 0 && surface_area(target) > 0)) return false;
    return numerics::rank_correlation(mean_curvature(source, laplace_beltrami(source)),
                                      mean_curvature(target, laplace_beltrami(target))) >= least_correlation;
}

}  // namespace

std::optional<Message> same_order(MeshView source, MeshView target) {
    if (source.n_vertices() != target.n_vertices() || source.n_triangles() != target.n_triangles() ||
        source.triangles != target.triangles)
        return std::nullopt;
    if (differences::lengths_fit(identity_map(source.n_vertices()), source, target) ||
        curve_alike(source, target))
        return Message{MessageCode::same_order, Severity::notice,
                       "the same triangles in the same order: vertex i is vertex i"};
    return Message{
        MessageCode::same_order, Severity::caution,
        "the same triangles in the same order, but of a regular triangulation, and neither lengths "
        "nor curvature agree: vertex i is vertex i only if both come from one mesh; if they do not "
        "(depth images, wraps of one size), match them by shape"};
}

}  // namespace counterpart
