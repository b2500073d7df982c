// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "io/gltf_primitives.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace counterpart::io {
namespace {

struct Placement {
    Eigen::Affine3d transform = Eigen::Affine3d::Identity();
    bool used = false;
    std::int64_t node = -1;  // that uses it first
};

Eigen::Affine3d local_transform(const GltfDocument& document, const GltfJson& node) {
    const auto numbers = [&](const char* key, std::vector<double> otherwise) {
        if (!node.contains(key)) return otherwise;
        auto values = node[key].get<std::vector<double>>();
        if (values.size() != otherwise.size())
            document.fail(fmt::format("a node's '{}' has the wrong length", key));
        return values;
    };
    Eigen::Affine3d transform = Eigen::Affine3d::Identity();
    if (node.contains("matrix")) {
        const auto m = numbers("matrix", std::vector<double>(16, 0));
        transform.matrix() = Eigen::Map<const Eigen::Matrix4d>(m.data());
        return transform;
    }
    const auto t = numbers("translation", {0, 0, 0}), r = numbers("rotation", {0, 0, 0, 1}),
               s = numbers("scale", {1, 1, 1});
    transform.translate(Eigen::Vector3d(t[0], t[1], t[2]));
    transform.rotate(Eigen::Quaterniond(r[3], r[0], r[1], r[2]).normalized());
    transform.scale(Eigen::Vector3d(s[0], s[1], s[2]));
    return transform;
}

// Where the first node of the scene that holds each mesh puts it; skinned meshes stay as they are bound.
std::vector<Placement> place_meshes(const GltfDocument& document, std::vector<std::string>& notices) {
    std::vector<Placement> placements(document.count("meshes"));
    std::vector<char> visited(document.count("nodes"), 0);
    std::size_t repeated = 0;
    struct Visit {
        std::int64_t node;
        Eigen::Affine3d parent;
    };
    std::vector<Visit> stack;
    if (document.count("scenes") > 0) {
        const GltfJson& scene = document.element("scenes", number_at(document, document.json, "scene", 0));
        if (scene.contains("nodes")) {
            for (const GltfJson& root : scene["nodes"])
                stack.push_back({whole_number(document, root, "a node"), Eigen::Affine3d::Identity()});
        }
    }
    std::reverse(stack.begin(), stack.end());
    while (!stack.empty()) {
        const Visit visit = stack.back();
        stack.pop_back();
        const GltfJson& node = document.element("nodes", visit.node);
        if (visited[static_cast<std::size_t>(visit.node)]++) document.fail("the nodes do not form a tree");
        const Eigen::Affine3d transform = visit.parent * local_transform(document, node);
        if (node.contains("mesh")) {
            const std::int64_t mesh = number_at(document, node, "mesh", 0);
            document.element("meshes", mesh);
            Placement& placement = placements[static_cast<std::size_t>(mesh)];
            repeated += placement.used;
            if (!placement.used && !node.contains("skin")) placement.transform = transform;
            if (!placement.used) placement.node = visit.node;
            placement.used = true;
        }
        if (!node.contains("children")) continue;
        for (auto child = node["children"].rbegin(); child != node["children"].rend(); ++child)
            stack.push_back({whole_number(document, *child, "a node"), transform});
    }
    if (repeated > 0) notices.push_back(fmt::format("{} further instances of meshes left out", repeated));
    return placements;
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
    const std::vector<Placement> placements = place_meshes(document, notices);
    const bool scene_places_some =
        std::any_of(placements.begin(), placements.end(), [](const Placement& p) { return p.used; });
    std::vector<GltfPrimitive> primitives;
    GltfBudget budget(document);
    std::size_t other = 0;
    for (std::size_t m = 0; m < placements.size(); ++m) {
        if (scene_places_some && !placements[m].used) continue;
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
            primitive.node = placements[m].node;
            primitive.placement = placements[m].transform;
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
