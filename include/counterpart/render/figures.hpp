// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/geodesic/farthest_points.hpp>
#include <counterpart/map/vertex_map.hpp>
#include <counterpart/render/camera.hpp>
#include <counterpart/render/scene.hpp>

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace counterpart::render {

/// Pale, so that shading and overlays stay visible.
inline Color plain_color() { return {0.86, 0.855, 0.84}; }

/// Moves the meshes next to each other from left to right, with the centers of their boxes at one height.
void arrange_in_row(std::span<Placement> placements);

/// The mesh in one color.
Surface plain_surface(MeshView mesh, const Placement& placement, const Color& color = plain_color());

struct FrontierFigureOptions {
    Index every = 5;    ///< draw frontier 0, every, 2 every, ...; at least 1
    bool dots = false;  ///< dots at vertices instead of a band along each frontier
};
/// The mesh with every n-th frontier in its own color, from dark blue at the seed to yellow at the farthest,
/// and a red dot at the seed. `level` is the frontier of each vertex, -1 for those in none (gray). Throws
/// InvalidInput if the sizes differ or `every` is less than 1.
void add_frontiers(Scene& scene, MeshView mesh, const Placement& placement, std::span<const Index> level,
                   const FrontierFigureOptions& options = {});

/// A dot for each sample, and its cell in one of eight pale colors.
void add_farthest_point_samples(Scene& scene, MeshView mesh, const Placement& placement,
                                const FarthestPointSamples& bases);

/// The part of the mesh within `radius` (mesh units) of `center`: its edges in gray, the shortcuts across
/// them in orange, and its vertices as dots with one color per frontier. Throws InvalidInput if no triangle
/// lies within.
void add_shortcuts(Scene& scene, MeshView mesh, const Placement& placement, std::span<const Index> level,
                   Index center, double radius);

/// The part of the mesh that add_shortcuts draws, as a mesh of its own.
TriangleMesh patch_around(MeshView mesh, Index center, double radius);

/// Two frontiers in space: the dots and edges of the first in blue, of the second in orange, and a thin gray
/// line for each pair (index in first, index in second). All in image space.
struct FrontierPair {
    Points first, second;
    std::vector<std::pair<Index, Index>> first_edges, second_edges, pairs;
};
void add_frontier_pair(Scene& scene, const FrontierPair& frontiers, double dot_radius);

/// A mesh with its placement in the image.
struct PlacedMesh {
    MeshView mesh;
    Placement placement;
};

/// Values of source vertices transferred to the target: each target vertex gets the mean over the source
/// vertices mapped to it. Vertices that are not images get the mean of their neighbors, up to three edges
/// away; beyond that, NaN. `values` is source vertices x 3. O(V).
Points transfer_to_target(PointsView values, const VertexMap& target_from_source, MeshView target);

enum class Texture {
    colors,  ///< position_color
    checker  ///< the same with a checkerboard, which shows stretch and tears
};
/// The source colored by the position of its points in the image, and the target with these colors
/// transferred by the map; gray where the map reaches no target vertex.
Scene texture_scene(const PlacedMesh& source, const PlacedMesh& target, const VertexMap& target_from_source,
                    Texture texture);

struct LineOptions {
    Index count = 80;        ///< maximum number of lines; 0 = all
    std::uint64_t seed = 1;  ///< random seed that selects them
};
/// Both meshes plain, with lines between matched points. Only source vertices that face the viewer are
/// sampled; a line to a point on the far side of the target passes behind it.
Scene line_scene(const PlacedMesh& source, const PlacedMesh& target, const VertexMap& target_from_source,
                 const LineOptions& options = {});

/// A value per vertex in colors from 0 to `max`, NaN in gray.
Surface value_surface(const PlacedMesh& placed, const Vector& values, double max, Colormap colormap);

}  // namespace counterpart::render
