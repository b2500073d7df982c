// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "render_figures.hpp"
#include "truth_options.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/evaluation/evaluate.hpp>

#include <algorithm>
#include <cmath>

namespace counterpart::cli {
namespace {

// The name of each map below its copy of the target.
void write_labels(const RenderRequest& request, const std::vector<PlacedMesh>& placed, const Frame& frame,
                  double size, Image& image) {
    Drawing drawing{request.width, request.height, {}};
    for (std::size_t i = 0; i < request.maps.size(); ++i) {
        const PlacedMesh& target = placed[i + 1];
        const Points vertices = target.placement(target.mesh).vertices;
        const Eigen::RowVector3d low = vertices.colwise().minCoeff(), high = vertices.colwise().maxCoeff();
        const double x = frame.pixel((low + high) / 2).x(), y = frame.pixel(low).y() + 2 * size;
        drawing.shapes.emplace_back(
            Text{.at = {x, y}, .text = request.labels[i], .size = size, .anchor = 0.5});
    }
    render::draw(drawing, image);
}

Image draw_texture(const RenderRequest& request, Texture texture) {
    const std::vector<PlacedMesh> placed = request.placed();
    Scene scene = texture_scene(placed[0], placed[1], request.maps[0].vertices, texture);
    if (request.maps.size() == 1) return request.paint(scene);
    for (std::size_t i = 1; i < request.maps.size(); ++i)
        scene.surfaces.push_back(
            texture_scene(placed[0], placed[i + 1], request.maps[i].vertices, texture).surfaces[1]);
    const double text = std::max(11.0, request.height / 45.0);
    const int bottom = static_cast<int>(3 * text);
    Image image = request.paint(scene, bottom);
    write_labels(request, placed, fit(scene, request.options(bottom)), text, image);
    return image;
}

Image draw_lines(const RenderRequest& request) {
    const std::vector<PlacedMesh> placed = request.placed();
    return request.paint(line_scene(placed[0], placed[1], request.maps[0].vertices, request.lines));
}

EvaluationReport score(const RenderRequest& request, const LoadedMap& map, std::vector<double> thresholds) {
    EvaluationOptions options;
    options.thresholds = std::move(thresholds);
    options.n_threads = request.common.threads;
    options.progress = progress_bar("measuring", request.common);
    return evaluated(map, *request.truth, request.source, *request.target, options);
}

/// Fills vertices without a value from their neighbors.
Vector filled(const Vector& values, MeshView mesh) {
    return transfer_to_target(Points(values.replicate(1, 3)), identity_map(mesh.n_vertices()), mesh).col(0);
}

Image draw_error(const RenderRequest& request) {
    const EvaluationReport report = score(request, request.maps[0], {});
    // A round end of the scale that does not depend on a few outliers.
    double max = request.max_error;
    if (max == 0) {
        const double high = std::isfinite(report.percentile_95_error) ? report.percentile_95_error : 1;
        for (max = 1; max < high; max *= max == 2 || max == 20 ? 2.5 : 2) {
        }
    }
    const std::vector<PlacedMesh> placed = request.placed();
    Scene scene;
    for (const PairEnd end : {PairEnd::source, PairEnd::target}) {
        const PlacedMesh& mesh = placed[end == PairEnd::source ? 0 : 1];
        const Vector values = mean_vertex_errors(*request.truth, report, end, mesh.mesh.n_vertices());
        scene.surfaces.push_back(value_surface(mesh, filled(values, mesh.mesh), max, request.colormap));
    }
    const double text = std::max(11.0, request.height / 45.0);
    Image image = request.paint(scene, static_cast<int>(4.2 * text));
    Drawing drawing{request.width, request.height, {}};
    add_color_bar(drawing,
                  {0.33 * request.width, request.height - 4.4 * text, 0.34 * request.width, 0.8 * text,
                   request.colormap, max, "geodesic error x 100 / sqrt(target area)", text});
    render::draw(drawing, image);
    return image;
}

Drawing draw_curve(const RenderRequest& request) {
    double max = request.max_error;
    std::vector<ErrorCurve> curves;
    if (max == 0) {  // as far as the worst of the maps needs, within reason
        for (const LoadedMap& map : request.maps) {
            const double high = score(request, map, {}).percentile_95_error;
            if (std::isfinite(high)) max = std::max(max, high);
        }
        max = std::clamp(5 * std::ceil(1.2 * max / 5), 5.0, 100.0);
    }
    constexpr int steps = 200;
    std::vector<double> thresholds;
    for (int i = 0; i <= steps; ++i) thresholds.push_back(max * i / steps);
    for (std::size_t i = 0; i < request.maps.size(); ++i) {
        const EvaluationReport report = score(request, request.maps[i], thresholds);
        curves.push_back({request.labels[i], report.thresholds, report.fraction_within, report.mean_error});
    }
    return error_chart(curves, {.width = request.width, .height = request.height, .max_error = max});
}

}  // namespace

std::vector<Figure> map_figures() {
    return {{.name = "colors",
             .summary = "the source colored by position, colors transferred to the target",
             .needs_target = true,
             .needs_map = true,
             .compares_maps = true,
             .draw = [](const RenderRequest& r) { return draw_texture(r, Texture::colors); }},
            {.name = "checker",
             .summary = "the same with a checkerboard, which shows stretch and tears",
             .needs_target = true,
             .needs_map = true,
             .compares_maps = true,
             .draw = [](const RenderRequest& r) { return draw_texture(r, Texture::checker); }},
            {.name = "lines",
             .summary = "lines between matched points",
             .needs_target = true,
             .needs_map = true,
             .draw = draw_lines},
            {.name = "error",
             .summary = "geodesic errors as colors, on both meshes",
             .needs_target = true,
             .needs_map = true,
             .needs_truth = true,
             .draw = draw_error},
            {.name = "curve",
             .summary = "fraction of pairs within each error, for one or more maps; PNG or SVG",
             .needs_target = true,
             .needs_map = true,
             .needs_truth = true,
             .compares_maps = true,
             .diagram = draw_curve}};
}

}  // namespace counterpart::cli
