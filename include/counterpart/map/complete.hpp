// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/types.hpp>
#include <counterpart/map/surface_map.hpp>

#include <optional>

namespace counterpart {

/// Where vertices got their images or attributes from; the three sum to the number of vertices, less those
/// that CompleteOptions leaves unmatched.
struct Coverage {
    Index transferred = 0;  ///< from the source, through the map
    Index filled = 0;       ///< unmatched: extended from the vertices around them
    Index guessed = 0;      ///< in components without any match: from the nearest matched vertex
};

struct CompleteOptions {
    /// Only vertices at most this many edges from a matched one get an image, 1 .., the same that they get
    /// without a limit; none: all vertices do.
    std::optional<int> max_edges{};
};

struct CompletedMap {
    SurfaceMap target_from_source;
    Coverage coverage;  ///< of the source's vertices
};

/// Gives unmatched vertices an image: the harmonic extension of the images around them, projected onto the
/// target's surface; vertices of components without any match get the image of the nearest matched vertex.
/// Matched vertices keep theirs bit for bit. O(n^1.5 + n log F) for n unmatched vertices. Throws InvalidInput
/// if the map does not fit the meshes or matches nothing, if max_edges is below 1, or if squares of the
/// coordinates overflow.
CompletedMap complete_map(const SurfaceMap& target_from_source, MeshView source, MeshView target,
                          const CompleteOptions& options = {});

/// The same for images at vertices: what is found for an unmatched vertex is moved to the nearest corner.
VertexMap complete_map(const VertexMap& target_from_source, MeshView source, MeshView target,
                       const CompleteOptions& options = {});

}  // namespace counterpart
