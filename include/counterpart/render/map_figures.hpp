// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/map/vertex_map.hpp>
#include <counterpart/render/scene.hpp>
#include <counterpart/render/view.hpp>

#include <cstdint>

namespace counterpart {

/// A mesh with its place in the picture.
struct PlacedMesh {
    const TriangleMesh& mesh;
    Placement placement;
};

/// Values of source vertices carried to the target: each target vertex takes the mean over those mapped to
/// it. Vertices that are nobody's image take the mean of their neighbours, up to three edges away; beyond
/// that, NaN. `values` is source vertices x 3. O(V).
Points carry(const Points& values, const VertexMap& target_from_source, const TriangleMesh& target);

enum class Texture {
    colors,  ///< position_color
    checker  ///< the same with dark squares, in which stretch and tears show
};
/// The source painted by the position of its points in the picture, and the target with the same paint
/// carried over by the map. Where the map reaches no target vertex the target is grey.
Scene texture_scene(const PlacedMesh& source, const PlacedMesh& target, const VertexMap& target_from_source,
                    Texture texture);

struct LineOptions {
    Index count = 80;        ///< at most this many; 0 = all
    std::uint64_t seed = 1;  ///< which ones
};
/// Both meshes plain, and lines between matched points. Those of the source vertices that face the viewer are
/// sampled; a line to a point on the far side of the target goes behind it.
Scene line_scene(const PlacedMesh& source, const PlacedMesh& target, const VertexMap& target_from_source,
                 const LineOptions& options = {});

/// A value per vertex in colours from 0 to `max`, NaN in grey.
Surface value_surface(const PlacedMesh& placed, const Vector& values, double max, Colormap colormap);

}  // namespace counterpart
