// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/partial/cleaned.hpp"

#include <counterpart/base/errors.hpp>

#include <fmt/format.h>

namespace counterpart::partial_match {
namespace {

void require_room_for_distances(const surface_match::Preprocessed& cleaned, const std::string& name) {
    constexpr Index max_vertices = 500000;  // 2 GB
    if (cleaned.mesh.n_vertices() > max_vertices)
        throw UnsuitableMesh(fmt::format(
            "partial matching keeps distances from 900 samples to all vertices, too many for the {} of {} "
            "vertices: simplify it to at most {} first",
            name, cleaned.mesh.n_vertices(), max_vertices));
}

}  // namespace

surface_match::Preprocessed cleaned(MeshView mesh, const std::string& name) {
    return surface_match::preprocess(mesh, {"partial", 50, name});
}

void require_room_for_distances(const surface_match::Preprocessed& source,
                                const surface_match::Preprocessed& target) {
    require_room_for_distances(source, "source");
    require_room_for_distances(target, "target");
}

}  // namespace counterpart::partial_match
