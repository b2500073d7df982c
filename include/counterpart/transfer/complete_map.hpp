// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/map/surface_map.hpp>
#include <counterpart/transfer/coverage.hpp>

namespace counterpart {

struct CompletedMap {
    SurfaceMap target_from_source;  ///< every source vertex matched
    Coverage coverage;              ///< of the source's vertices
};

/// Gives unmatched vertices an image: the harmonic extension of the images around them, put onto the closest
/// point of the target's surface; vertices of components without any match get the image of the nearest
/// vertex that has one. Matched vertices keep theirs bit by bit. O(n^1.5 + n log F) for n unmatched vertices.
/// Throws InvalidInput if the map does not fit the meshes or matches nothing.
CompletedMap complete_map(const SurfaceMap& target_from_source, const TriangleMesh& source,
                          const TriangleMesh& target);

}  // namespace counterpart
