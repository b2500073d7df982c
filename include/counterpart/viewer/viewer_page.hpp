// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/map/vertex_map.hpp>
#include <counterpart/mesh/attributed_mesh.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

#include <string>
#include <vector>

namespace counterpart {

/// A map to show.
struct ViewerMap {
    std::string name;  ///< as shown in the list of maps
    VertexMap target_from_source;
    /// Error per source vertex, in units of sqrt(target area) / 100; NaN where unknown, infinite where the
    /// map leads to another component. Empty = no ground truth.
    std::vector<double> error{};
    std::string evaluation{};  ///< what is said of the map beside it: its errors, as evaluate() finds them
    std::string verdict{};     ///< whether to use it: "use", "check", "do not use"
    std::vector<std::string> warnings{};  ///< what may be wrong with it, a sentence each
    std::vector<double> confidence{};     ///< 0 .. 1 per source vertex, NaN where unknown; empty = unknown
};

/// Numbers to color by, whichever map is shown.
struct ViewerValues {
    std::string name;
    std::vector<double> values;  ///< one per source vertex, NaN where unknown
};

/// What a mesh looks like by itself: images on its surface, colors, or both.
struct ViewerAppearance {
    CornerAttribute texture_coordinates{};   ///< n x 2 values, (0, 0) at the image's top left
    std::vector<std::string> images{};       ///< whole PNG, JPEG or WebP files
    std::vector<Index> image_of_triangle{};  ///< -1: none; empty without images
    CornerAttribute colors{};  ///< n x 3 or n x 4 values in 0 .. 1; the images are multiplied by them
};

struct ViewerOptions {
    std::string source_name = "source", target_name = "target";
    /// True target vertex of each source vertex, or VertexMap::unmatched where unknown. Empty = no ground
    /// truth.
    std::vector<Index> truth{};
    std::vector<ViewerValues> values{};
    ViewerAppearance source_appearance{}, target_appearance{};
    /// The direction, in the source's coordinates, that points up on the screen; not 0.
    Eigen::Vector3d up = Eigen::Vector3d::UnitY();
    /// The seed vertex of the source for frontiers; -1 = selected by the page, at an end of the source.
    Index base_vertex = -1;
};

/// What a viewer shows: the meshes and maps as it reads them.
struct ViewerScene {
    std::string description;  ///< JSON, which says where in `arrays` everything is
    std::string arrays;       ///< one after the other, each at a multiple of four bytes, little-endian
};

/// The scene by itself, for a page that holds the viewer already. As viewer_page.
ViewerScene viewer_scene(MeshView source, MeshView target, const std::vector<ViewerMap>& maps,
                         const ViewerOptions& options = {});

/// One HTML file that shows the two meshes side by side with the maps between them, in any browser with WebGL
/// 2 and without a network: the prebuilt viewer with meshes and maps embedded as base64. Positions are
/// rounded to 1/65535 of their mesh's box; indices are exact. The target is initially rotated so that the
/// first map's pairs agree best. Takes 8 bytes per vertex and 8 (16 above 65536 vertices) per triangle of
/// each mesh, 5.3 per source vertex and map (twice that with errors), and for a mesh's appearance 37 per
/// triangle and four thirds of the images, on top of the viewer itself. O(V + F). Throws InvalidInput for an
/// invalid mesh, no map, a map, error, confidence, truth or appearance that does not fit the meshes (the
/// message names the map), or a base vertex out of range.
std::string viewer_page(MeshView source, MeshView target, const std::vector<ViewerMap>& maps,
                        const ViewerOptions& options = {});

}  // namespace counterpart
