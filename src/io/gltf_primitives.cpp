// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "io/gltf_primitives.hpp"

#include "io/gltf_scene.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace counterpart::io {
namespace {

// The first node of the scene that shows each mesh, by mesh; without a node where none does.
std::vector<ShownMesh> first_shown(const GltfDocument& document, std::vector<std::string>& notices) {
    std::vector<ShownMesh> first(document.count("meshes"));
    std::size_t repeated = 0;
    for (const ShownMesh& shown : shown_meshes(document)) {
        ShownMesh& of_mesh = first[static_cast<std::size_t>(shown.mesh)];
        if (of_mesh.node < 0)
            of_mesh = shown;
        else
            ++repeated;
    }
    if (repeated > 0) notices.push_back(fmt::format("{} further instances of meshes left out", repeated));
    return first;
}

Triangles triangles_of(const GltfDocument& document, const GltfJson& primitive, std::int64_t mode,
                       Index n_vertices, const std::string& what, GltfBudget& budget) {
    std::vector<Index> list;
    if (primitive.contains("indices")) {
        const Matrix indices =
            read_accessor(document, number_at(document, primitive, "indices", -1), "SCALAR", budget);
        for (Eigen::Index i = 0; i < indices.rows(); ++i) {
            if (!(indices(i, 0) >= 0 && indices(i, 0) < n_vertices)) {
                document.fail(fmt::format("{}: index {} is out of range; there are {} vertices", what,
                                          indices(i, 0), n_vertices));
            }
            list.push_back(static_cast<Index>(indices(i, 0)));
        }
    } else {
        for (Index v = 0; v < n_vertices; ++v) list.push_back(v);
    }
    const std::size_t count = mode == 4 ? list.size() / 3 : list.size() < 3 ? 0 : list.size() - 2;
    Triangles triangles(static_cast<Eigen::Index>(count), 3);
    for (std::size_t i = 0; i < count; ++i) {
        auto row = triangles.row(static_cast<Eigen::Index>(i));
        if (mode == 4)
            row << list[3 * i], list[3 * i + 1], list[3 * i + 2];
        else if (mode == 6)
            row << list[0], list[i + 1], list[i + 2];
        else  // every other triangle of a strip is wound the other way
            row << list[i], list[i + 1 + i % 2], list[i + 2 - i % 2];
    }
    return triangles;
}

SkinBinding skin_of(const GltfDocument& document, const std::vector<Matrix>& joints,
                    const std::vector<Matrix>& weights, const std::string& what) {
    SkinBinding skin;
    for (const Matrix& set : joints) {
        constexpr double most = 65535;  // as the format stores them
        if (!((set.array() >= 0) && (set.array() <= most)).all())
            document.fail(what + ": a joint is out of range");
    }
    if (joints.size() != weights.size()) document.fail(what + ": every JOINTS needs its WEIGHTS");
    if (joints.empty()) return skin;
    const Eigen::Index n = joints[0].rows();
    skin.joints.resize(n, 4 * static_cast<Eigen::Index>(joints.size()));
    skin.weights.resize(n, skin.joints.cols());
    for (std::size_t set = 0; set < joints.size(); ++set) {
        skin.joints.middleCols<4>(4 * static_cast<Eigen::Index>(set)) = joints[set].cast<Index>();
        skin.weights.middleCols<4>(4 * static_cast<Eigen::Index>(set)) = weights[set];
    }
    return skin;
}

GltfPrimitive read_primitive(const GltfDocument& document, const GltfJson& json, std::int64_t mode,
                             const std::string& what, GltfBudget& budget) {
    const GltfJson& attributes = json.at("attributes");
    const auto read = [&](const GltfJson& from, const std::string& key, const char* types) {
        return read_accessor(document, number_at(document, from, key.c_str(), -1), types, budget);
    };
    GltfPrimitive result;
    result.positions = read(attributes, "POSITION", "VEC3");
    const auto n = static_cast<Index>(result.positions.rows());
    const auto sets = [&](const std::string& name, const char* types) {
        std::vector<Matrix> found;
        constexpr int most_sets = 16;  // the format asks for two of texture coordinates, one of the others
        for (int i = 0; attributes.contains(fmt::format("{}_{}", name, i)); ++i) {
            if (i == most_sets) document.fail(fmt::format("{} has more than {} {}s", what, most_sets, name));
            found.push_back(read(attributes, fmt::format("{}_{}", name, i), types));
            if (found.back().rows() != n)
                document.fail(fmt::format("{}: {}_{} has {} rows for {} vertices", what, name, i,
                                          found.back().rows(), n));
        }
        return found;
    };
    result.triangles = triangles_of(document, json, mode, n, what, budget);
    if (attributes.contains("NORMAL")) {
        result.normals = read(attributes, "NORMAL", "VEC3");
        if (result.normals.rows() != n)
            document.fail(
                fmt::format("{}: NORMAL has {} rows for {} vertices", what, result.normals.rows(), n));
    }
    result.texture_coordinates = sets("TEXCOORD", "VEC2");
    result.colors = sets("COLOR", "VEC3 VEC4");
    result.skin = skin_of(document, sets("JOINTS", "VEC4"), sets("WEIGHTS", "VEC4"), what);
    if (json.contains("targets")) {
        for (const GltfJson& target : json["targets"]) {
            Points displacement;
            if (target.contains("POSITION")) {
                displacement = read(target, "POSITION", "VEC3");
            } else {
                budget.take(n, 3);
                displacement = Points::Zero(n, 3);
            }
            if (displacement.rows() != n)
                document.fail(fmt::format("{}: a morph target has {} rows for {} vertices", what,
                                          displacement.rows(), n));
            result.displacements.push_back(std::move(displacement));
        }
    }
    return result;
}

void put_in_place(GltfPrimitive& primitive) {
    const Eigen::Matrix3d linear = primitive.placement.linear();
    if (primitive.placement.matrix() == Eigen::Matrix4d::Identity()) return;
    primitive.positions =
        (primitive.positions * linear.transpose()).rowwise() + primitive.placement.translation().transpose();
    for (Points& displacement : primitive.displacements)
        displacement = (displacement * linear.transpose()).eval();
    if (primitive.normals.rows() > 0 && linear.determinant() != 0)
        primitive.normals = (primitive.normals * linear.inverse()).rowwise().normalized();
    if (linear.determinant() < 0) primitive.turn_over();
}

}  // namespace

std::vector<GltfPrimitive> read_primitives(const GltfDocument& document, std::vector<std::string>& notices) {
    const std::vector<ShownMesh> shown = first_shown(document, notices);
    const bool scene_shows_some =
        std::any_of(shown.begin(), shown.end(), [](const ShownMesh& s) { return s.node >= 0; });
    std::vector<GltfPrimitive> primitives;
    GltfBudget budget(document);
    std::size_t other = 0;
    for (std::size_t m = 0; m < shown.size(); ++m) {
        if (scene_shows_some && shown[m].node < 0) continue;
        const GltfJson& mesh = document.element("meshes", static_cast<std::int64_t>(m));
        std::size_t number = 0;
        for (const GltfJson& json : mesh.at("primitives")) {
            const std::string what = fmt::format("mesh {}, primitive {}", m, number++);
            const std::int64_t mode = number_at(document, json, "mode", 4);
            if (mode > 6) document.fail(fmt::format("{} has the unknown mode {}", what, mode));
            if (mode < 4 || !json.at("attributes").contains("POSITION")) {
                ++other;
                continue;
            }
            GltfPrimitive primitive = read_primitive(document, json, mode, what, budget);
            primitive.mesh = m;
            primitive.number = number - 1;
            primitive.node = shown[m].node;
            primitive.placement = shown[m].placement;
            put_in_place(primitive);
            primitives.push_back(std::move(primitive));
        }
    }
    if (other > 0)
        notices.push_back(fmt::format("{} primitives of points, lines or without positions left out", other));
    if (primitives.empty())
        document.fail(other > 0 ? "the file holds points or lines, no triangles"
                                : "the file holds no triangles");
    return primitives;
}

}  // namespace counterpart::io
