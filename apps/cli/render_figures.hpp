// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// The figures `counterpart render` makes, one function each.
#pragma once

#include "console.hpp"
#include "load_map.hpp"

#include <counterpart/evaluation/evaluate.hpp>
#include <counterpart/map/vertex_map.hpp>
#include <counterpart/render/charts.hpp>
#include <counterpart/render/figures.hpp>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace counterpart::cli {

using namespace render;

/// What the command line asks for, files already read and checked against each other.
struct RenderRequest {
    CommonOptions common;
    TriangleMesh source;
    std::optional<TriangleMesh> target;
    Points source_colors, target_colors;  ///< n_vertices x 3, of files that have some; else empty
    std::vector<LoadedMap> maps;          ///< target from source
    std::vector<std::string> labels;
    std::optional<GroundTruth> truth;

    int width = 1600, height = 1000;
    CameraOptions view;
    Index vertex = -1, target_vertex = -1;
    Index every = 5, n_bases = 100, frontier = -1;
    bool dots = false;
    double radius = 0, max_error = 0;
    LineOptions lines;
    Colormap colormap = Colormap::magma;

    /// The meshes from left to right, in the same orientation: the source, and the target once for each map.
    std::vector<PlacedMesh> placed() const;
    /// With so many pixels free at the bottom.
    RenderOptions options(int bottom = 0) const;
    Image paint(const Scene& scene, int bottom = 0) const;
};

struct Figure {
    std::string name;
    std::string summary;  ///< for --help
    bool needs_target = false, needs_map = false, needs_truth = false;
    bool compares_maps = false;  ///< takes several
    std::function<Image(const RenderRequest&)> draw{};
    /// Instead of draw: a diagram, which can be SVG as well.
    std::function<Drawing(const RenderRequest&)> diagram{};
};

std::vector<Figure> map_figures();
std::vector<Figure> mesh_figures();
std::vector<Figure> frontier_figures();

/// The seeds: --vertex or a critical point of the source; --target-vertex, the image of the source's seed
/// under the map, or a critical point of the target.
std::vector<Index> chosen_vertices(const RenderRequest& request);

}  // namespace counterpart::cli
