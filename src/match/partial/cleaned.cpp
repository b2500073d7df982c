// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/partial/cleaned.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/mesh/measure.hpp>

#include <cmath>

#include <fmt/format.h>

namespace counterpart::partial_match {
namespace {

void require_room_for_distances(const spectral_match::Preprocessed& cleaned, const std::string& name,
                                int n_samples) {
    constexpr Index most_distances = 450'000'000;  // 1.8 GB
    const Index max_vertices = most_distances / n_samples;
    if (cleaned.mesh.n_vertices() > max_vertices)
        throw UnsuitableMesh(fmt::format(
            "partial matching keeps distances from {} samples and landmarks to all vertices, too many for "
            "the {} of {} vertices: simplify it to at most {} first, or ask for fewer",
            n_samples, name, cleaned.mesh.n_vertices(), max_vertices));
}

}  // namespace

spectral_match::Preprocessed cleaned(MeshView mesh, const std::string& name) {
    constexpr Index min_vertices = 50;
    const double area = surface_area(mesh);
    if (!(area > 0))
        throw UnsuitableMesh(fmt::format("the {} has no area: all its triangles are degenerate", name));
    if (!std::isfinite(area))
        throw UnsuitableMesh(fmt::format("the {} is too large to measure: scale it down first", name));
    spectral_match::Preprocessed result = spectral_match::preprocess(mesh);
    if (result.mesh.n_vertices() < min_vertices)
        throw UnsuitableMesh(
            fmt::format("partial matching needs meshes of at least {} vertices, but the {} has {}: too "
                        "few to show a shape; subdivide it first",
                        min_vertices, name, result.mesh.n_vertices()));
    return result;
}

void require_room_for_distances(const spectral_match::Preprocessed& source,
                                const spectral_match::Preprocessed& target, int n_samples) {
    require_room_for_distances(source, "source", n_samples);
    require_room_for_distances(target, "target", n_samples);
}

}  // namespace counterpart::partial_match
