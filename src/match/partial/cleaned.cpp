// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/partial/cleaned.hpp"

#include <counterpart/base/errors.hpp>

#include <fmt/format.h>

namespace counterpart::partial_match {
namespace {

void require_room_for_distances(const surface_match::Preprocessed& cleaned, const std::string& name,
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

surface_match::Preprocessed cleaned(MeshView mesh, const std::string& name) {
    return surface_match::preprocess(mesh, {"partial", 50, name});
}

void require_room_for_distances(const surface_match::Preprocessed& source,
                                const surface_match::Preprocessed& target, int n_samples) {
    require_room_for_distances(source, "source", n_samples);
    require_room_for_distances(target, "target", n_samples);
}

}  // namespace counterpart::partial_match
