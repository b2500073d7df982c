// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "io/decimal.hpp"
#include "io/map_bytes.hpp"
#include "io/npy_bytes.hpp"
#include "io/text_cursor.hpp"
#include "platform/files.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/io/file.hpp>
#include <counterpart/io/map_file.hpp>
#include <counterpart/io/npy.hpp>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace counterpart {

using namespace io;

namespace {

// `refuse` is called with the reason if the numbers are no surface point.
template <class Refuse>
SurfacePoint point_of(double triangle, const Eigen::Vector3d& weights, const Refuse& refuse) {
    if (triangle == SurfacePoint::unmatched) return {};
    if (!(triangle >= 0 && triangle < 2147483647 && triangle == std::floor(triangle)))
        refuse(
            fmt::format("triangle {} is out of range; triangles count from 0, -1 means unmatched", triangle));
    if (!(weights.minCoeff() >= 0 && std::abs(weights.sum() - 1) <= 1e-6)) {
        refuse(fmt::format("the weights ({}, {}, {}) must not be negative and must sum to 1", weights[0],
                           weights[1], weights[2]));
    }
    return {static_cast<Index>(triangle), weights};
}

SurfaceMap from_npy(std::string_view bytes, const std::filesystem::path& file) {
    const Matrix rows = parse_npy(bytes, file);
    if (rows.cols() != 4)
        throw IoError(fmt::format("{}: a sub-vertex map has 4 columns (triangle, three weights), not {}",
                                  platform::utf8_name(file), rows.cols()));
    SurfaceMap map;
    for (Eigen::Index v = 0; v < rows.rows(); ++v) {
        map.image.push_back(
            point_of(rows(v, 0), rows.row(v).tail<3>().transpose(), [&](const std::string& reason) {
                throw IoError(fmt::format("{}: row {}: {}", platform::utf8_name(file), v, reason));
            }));
    }
    return map;
}

SurfaceMap from_text(std::string_view bytes, const std::filesystem::path& file) {
    TextCursor text(bytes, platform::utf8_name(file));
    SurfaceMap map;
    while (text.next_content()) {
        const double triangle = text.number("triangle");
        Eigen::Vector3d weights = Eigen::Vector3d::Zero();
        if (triangle != SurfacePoint::unmatched || !text.at_line_end())
            for (double& weight : weights) weight = text.number("weight");
        if (!text.at_line_end()) text.fail("expected a triangle and three weights, found more");
        map.image.push_back(
            point_of(triangle, weights, [&](const std::string& reason) { text.fail(reason); }));
    }
    return map;
}

// One number on the first line that holds anything, or one column.
bool holds_vertex_map(std::string_view bytes, const std::filesystem::path& file) {
    if (is_npy(file)) return parse_npy(bytes, file).cols() == 1;
    TextCursor text(bytes, platform::utf8_name(file));
    if (!text.next_content()) return true;
    text.word();
    return text.at_line_end();
}

}  // namespace

SurfaceMap io::parse_surface_map(std::string_view bytes, const std::filesystem::path& file) {
    SurfaceMap map = is_npy(file) ? from_npy(bytes, file) : from_text(bytes, file);
    for (const SurfacePoint& point : map.image)
        map.target_triangles = std::max(map.target_triangles, point.triangle + 1);
    return map;
}

SurfaceMap read_surface_map(const std::filesystem::path& file) {
    return parse_surface_map(read_whole_file(file), file);
}

std::string io::surface_map_bytes(const SurfaceMap& map, const std::filesystem::path& file) {
    if (is_npy(file)) {
        Matrix rows(map.source_size(), 4);
        for (Index v = 0; v < map.source_size(); ++v) {
            const Eigen::Vector3d& w = map[v].weights;
            rows.row(v) << static_cast<double>(map[v].triangle), w[0], w[1], w[2];
        }
        return npy_bytes(rows);
    }
    std::string text =
        "# triangle of the target and the weights of its corners, one line per source vertex\n";
    for (const SurfacePoint& point : map.image) {
        append_decimal(text, point.triangle);
        for (const double weight : point.weights) {
            text += ' ';
            append_decimal(text, weight);
        }
        text += '\n';
    }
    return text;
}

void write_surface_map(const SurfaceMap& map, const std::filesystem::path& file) {
    write_file(surface_map_bytes(map, file), file);
}

std::variant<VertexMap, SurfaceMap> io::parse_map(std::string_view bytes, const std::filesystem::path& file) {
    // A file whose first line is "-1" alone may be of either kind; as a vertex map it means the same unless
    // four numbers follow on a later line, and then the vertex map's reader names that line.
    if (holds_vertex_map(bytes, file)) return parse_vertex_map(bytes, file);
    return parse_surface_map(bytes, file);
}

std::variant<VertexMap, SurfaceMap> read_map(const std::filesystem::path& file) {
    return parse_map(read_whole_file(file), file);
}

}  // namespace counterpart
