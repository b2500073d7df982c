// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "base/base64.hpp"
#include "numerics/rotation.hpp"
#include "viewer/appearance.hpp"
#include "viewer/page_template.hpp"
#include "viewer/scene_buffer.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/viewer/viewer_page.hpp>

#include <cmath>
#include <string_view>

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace counterpart {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view data_mark = "<!--counterpart-data-->";

// Positions as 16-bit fractions of the box, triangles as 16- or 32-bit vertex numbers.
Json put_mesh(MeshView mesh, const std::string& name, viewer::SceneBuffer& buffer) {
    const Eigen::RowVector3d low = mesh.vertices.colwise().minCoeff();
    const Eigen::RowVector3d extent = mesh.vertices.colwise().maxCoeff() - low;
    const std::size_t positions = buffer.start_array();
    for (Index v = 0; v < mesh.n_vertices(); ++v) {
        for (int axis = 0; axis < 3; ++axis) {
            const double fraction =
                extent[axis] > 0 ? (mesh.vertices(v, axis) - low[axis]) / extent[axis] : 0.0;
            buffer.put(static_cast<std::uint16_t>(std::lround(fraction * 65535)));
        }
    }
    const bool is_small = mesh.n_vertices() <= 65536;
    const std::size_t triangles = buffer.start_array();
    for (Index t = 0; t < mesh.n_triangles(); ++t) {
        for (int corner = 0; corner < 3; ++corner) {
            const auto vertex = static_cast<std::uint32_t>(mesh.triangles(t, corner));
            if (is_small) {
                buffer.put(static_cast<std::uint16_t>(vertex));
            } else {
                buffer.put(vertex);
            }
        }
    }
    return {{"name", name},
            {"vertices", mesh.n_vertices()},
            {"triangles", mesh.n_triangles()},
            {"low", {low[0], low[1], low[2]}},
            {"extent", {extent[0], extent[1], extent[2]}},
            {"position_offset", positions},
            {"triangle_offset", triangles},
            {"triangle_bytes", is_small ? 2 : 4}};
}

std::size_t put_indices(const std::vector<Index>& indices, viewer::SceneBuffer& buffer) {
    const std::size_t start = buffer.start_array();
    for (const Index index : indices) buffer.put(static_cast<std::uint32_t>(index));
    return start;
}

std::size_t put_numbers(const std::vector<double>& numbers, viewer::SceneBuffer& buffer) {
    const std::size_t start = buffer.start_array();
    for (const double number : numbers) buffer.put(static_cast<float>(number));
    return start;
}

Json put_map(const ViewerMap& map, viewer::SceneBuffer& buffer) {
    Json json = {{"name", map.name}, {"image_offset", put_indices(map.target_from_source.image(), buffer)}};
    if (!map.error.empty()) json["error_offset"] = put_numbers(map.error, buffer);
    if (!map.confidence.empty()) json["confidence_offset"] = put_numbers(map.confidence, buffer);
    if (!map.evaluation.empty()) json["evaluation"] = map.evaluation;
    if (!map.verdict.empty()) json["verdict"] = map.verdict;
    if (!map.warnings.empty()) json["warnings"] = map.warnings;
    return json;
}

// The rotation of the target about its center that brings the images closest to their source vertices
// (Kabsch 1976).
Eigen::Quaterniond source_from_target_rotation(MeshView source, MeshView target,
                                               const VertexMap& target_from_source) {
    Eigen::RowVector3d source_mean = Eigen::RowVector3d::Zero(), target_mean = Eigen::RowVector3d::Zero();
    const Index matched = count_matched(target_from_source);
    if (matched < 3) return Eigen::Quaterniond::Identity();
    for (Index v = 0; v < source.n_vertices(); ++v) {
        if (target_from_source[v] == VertexMap::unmatched) continue;
        source_mean += source.vertices.row(v) / matched;
        target_mean += target.vertices.row(target_from_source[v]) / matched;
    }
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    for (Index v = 0; v < source.n_vertices(); ++v) {
        const Index image = target_from_source[v];
        if (image == VertexMap::unmatched) continue;
        covariance +=
            (source.vertices.row(v) - source_mean).transpose() * (target.vertices.row(image) - target_mean);
    }
    return Eigen::Quaterniond(numerics::fit_rotation(covariance).rotation).normalized();
}

// +z up shows the -y side.
Eigen::Quaterniond upright(const Eigen::Vector3d& up) {
    return numerics::shortest_rotation(up.normalized(), Eigen::Vector3d::UnitY());
}

Json to_json(const Eigen::Quaterniond& q) { return {q.x(), q.y(), q.z(), q.w()}; }

void require_fit(const ViewerMap& map, MeshView source, MeshView target) {
    try {
        require_valid(map.target_from_source, source.n_vertices(), target.n_vertices());
    } catch (const InvalidInput& error) {
        throw InvalidInput(fmt::format("map '{}': {}", map.name, error.what()));
    }
    const auto require_one_each = [&](const std::vector<double>& numbers, const char* what) {
        if (!numbers.empty() && numbers.size() != map.target_from_source.image().size())
            throw InvalidInput(fmt::format("map '{}': {} {} for {} source vertices; give one for each",
                                           map.name, numbers.size(), what, source.n_vertices()));
    };
    require_one_each(map.error, "errors");
    require_one_each(map.confidence, "confidences");
}

void require_fit(const ViewerOptions& options, MeshView source, MeshView target) {
    if (!options.truth.empty()) {
        try {
            require_valid({options.truth, target.n_vertices()}, source.n_vertices(), target.n_vertices());
        } catch (const InvalidInput& error) {
            throw InvalidInput(fmt::format("truth: {}", error.what()));
        }
    }
    viewer::require_fit(options.source_appearance, source, "source");
    viewer::require_fit(options.target_appearance, target, "target");
    for (const ViewerValues& values : options.values)
        if (values.values.size() != static_cast<std::size_t>(source.n_vertices()))
            throw InvalidInput(
                fmt::format("values '{}': {} numbers for {} source vertices; give one for each", values.name,
                            values.values.size(), source.n_vertices()));
    if (!(options.up.allFinite() && options.up.squaredNorm() > 0))
        throw InvalidInput("the direction that points up must not be 0");
    if (options.base_vertex < -1 || options.base_vertex >= source.n_vertices())
        throw InvalidInput(fmt::format("base vertex {} is not in the source; give 0 to {}",
                                       options.base_vertex, source.n_vertices() - 1));
}

// JSON that may stand inside a <script> element: nothing in it can end the element.
std::string script_safe(const std::string& text) {
    std::string safe;
    for (const char c : text) safe += c == '<' ? std::string("\\u003c") : std::string(1, c);
    return safe;
}

}  // namespace

ViewerScene viewer_scene(MeshView source, MeshView target, const std::vector<ViewerMap>& maps,
                         const ViewerOptions& options) {
    require_valid(source);
    require_valid(target);
    if (maps.empty()) throw InvalidInput("there is no map to view; give at least one");
    for (const ViewerMap& map : maps) require_fit(map, source, target);
    require_fit(options, source, target);

    viewer::SceneBuffer buffer;
    Json scene = {{"format", 1}};
    scene["source"] = put_mesh(source, options.source_name, buffer);
    scene["target"] = put_mesh(target, options.target_name, buffer);
    viewer::put_appearance(options.source_appearance, scene["source"], buffer);
    viewer::put_appearance(options.target_appearance, scene["target"], buffer);
    scene["maps"] = Json::array();
    for (const ViewerMap& map : maps) scene["maps"].push_back(put_map(map, buffer));
    scene["values"] = Json::array();
    for (const ViewerValues& values : options.values)
        scene["values"].push_back({{"name", values.name}, {"offset", put_numbers(values.values, buffer)}});
    if (!options.truth.empty()) scene["truth_offset"] = put_indices(options.truth, buffer);
    scene["base_vertex"] = options.base_vertex;
    scene["view_from_source"] = to_json(upright(options.up));
    scene["source_from_target"] =
        to_json(source_from_target_rotation(source, target, maps.front().target_from_source));
    return {scene.dump(-1, ' ', true, Json::error_handler_t::replace), buffer.bytes()};
}

std::string viewer_page(MeshView source, MeshView target, const std::vector<ViewerMap>& maps,
                        const ViewerOptions& options) {
    const ViewerScene scene = viewer_scene(source, target, maps, options);
    const std::string_view page = viewer::page_template();
    const std::size_t mark = page.find(data_mark);
    std::string html;
    html += page.substr(0, mark);
    html +=
        "<script type=\"application/json\" id=\"scene\">" + script_safe(scene.description) + "</script>\n";
    html += "<script type=\"text/plain\" id=\"buffer\">" + to_base64(scene.arrays) + "</script>";
    html += page.substr(mark + data_mark.size());
    return html;
}

}  // namespace counterpart
