// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "io/gltf_document.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/io/gltf.hpp>

#include <algorithm>
#include <unordered_map>

#include <Eigen/Geometry>
#include <fmt/format.h>

namespace counterpart {
namespace {

// One primitive as stored: its own vertices, before welding.
struct Primitive {
    std::size_t mesh = 0;
    Points positions;
    Triangles triangles;
    std::vector<Matrix> texture_coordinates, colors;
    SkinBinding skin;
    std::vector<Points> displacements;
};

struct Placement {
    Eigen::Affine3d transform = Eigen::Affine3d::Identity();
    bool used = false;
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
                stack.push_back({root.get<std::int64_t>(), Eigen::Affine3d::Identity()});
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
            placement.used = true;
        }
        if (!node.contains("children")) continue;
        for (auto child = node["children"].rbegin(); child != node["children"].rend(); ++child)
            stack.push_back({child->get<std::int64_t>(), transform});
    }
    if (repeated > 0) notices.push_back(fmt::format("{} further instances of meshes left out", repeated));
    return placements;
}

Triangles triangles_of(const GltfDocument& document, const GltfJson& primitive, std::int64_t mode,
                       Index n_vertices, const std::string& what) {
    std::vector<Index> list;
    if (primitive.contains("indices")) {
        const Matrix indices =
            read_accessor(document, number_at(document, primitive, "indices", -1), "SCALAR");
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

Primitive read_primitive(const GltfDocument& document, const GltfJson& json, std::int64_t mode,
                         const std::string& what) {
    const GltfJson& attributes = json.at("attributes");
    const auto read = [&](const GltfJson& from, const std::string& key, const char* types) {
        Matrix values = read_accessor(document, number_at(document, from, key.c_str(), -1), types);
        return values;
    };
    Primitive result;
    result.positions = read(attributes, "POSITION", "VEC3");
    if (result.positions.rows() > 2147483647) document.fail(what + " has too many vertices");
    const auto n = static_cast<Index>(result.positions.rows());
    const auto sets = [&](const std::string& name, const char* types) {
        std::vector<Matrix> found;
        for (int i = 0; attributes.contains(fmt::format("{}_{}", name, i)); ++i) {
            found.push_back(read(attributes, fmt::format("{}_{}", name, i), types));
            if (found.back().rows() != n)
                document.fail(fmt::format("{}: {}_{} has {} rows for {} vertices", what, name, i,
                                          found.back().rows(), n));
        }
        return found;
    };
    result.triangles = triangles_of(document, json, mode, n, what);
    result.texture_coordinates = sets("TEXCOORD", "VEC2");
    result.colors = sets("COLOR", "VEC3 VEC4");
    result.skin = skin_of(document, sets("JOINTS", "VEC4"), sets("WEIGHTS", "VEC4"), what);
    if (json.contains("targets")) {
        for (const GltfJson& target : json["targets"]) {
            Points displacement = Points::Zero(n, 3);
            if (target.contains("POSITION")) displacement = read(target, "POSITION", "VEC3");
            if (displacement.rows() != n)
                document.fail(fmt::format("{}: a morph target has {} rows for {} vertices", what,
                                          displacement.rows(), n));
            result.displacements.push_back(std::move(displacement));
        }
    }
    return result;
}

std::vector<Primitive> read_primitives(const GltfDocument& document, std::vector<std::string>& notices) {
    const std::vector<Placement> placements = place_meshes(document, notices);
    const bool scene_places_some =
        std::any_of(placements.begin(), placements.end(), [](const Placement& p) { return p.used; });
    std::vector<Primitive> primitives;
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
            Primitive primitive = read_primitive(document, json, mode, what);
            const Eigen::Affine3d& place = placements[m].transform;
            primitive.mesh = m;
            primitive.positions = (primitive.positions * place.linear().transpose()).rowwise() +
                                  place.translation().transpose();
            for (Points& displacement : primitive.displacements)
                displacement = (displacement * place.linear().transpose()).eval();
            if (place.linear().determinant() < 0) primitive.triangles.col(1).swap(primitive.triangles.col(2));
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

// The bytes by which vertices of one mesh are told apart; -0 counts as 0.
std::string weld_key(const Primitive& primitive, Eigen::Index v) {
    std::string key(reinterpret_cast<const char*>(&primitive.mesh), sizeof primitive.mesh);
    const auto add = [&](double value) {
        value += 0.0;
        key.append(reinterpret_cast<const char*>(&value), sizeof value);
    };
    for (int c = 0; c < 3; ++c) add(primitive.positions(v, c));
    for (Eigen::Index k = 0; k < primitive.skin.joints.cols(); ++k) {
        add(primitive.skin.weights(v, k) != 0 ? primitive.skin.joints(v, k) : 0);
        add(primitive.skin.weights(v, k));
    }
    for (const Points& displacement : primitive.displacements)
        for (int c = 0; c < 3; ++c) add(displacement(v, c));
    return key;
}

std::vector<std::string> morph_names(const GltfDocument& document, std::size_t mesh, std::size_t count) {
    std::vector<std::string> names;
    const GltfJson& json = document.element("meshes", static_cast<std::int64_t>(mesh));
    for (std::size_t i = 0; i < count; ++i) {
        std::string name = fmt::format("morph {}", i);
        if (json.contains("extras") && json["extras"].is_object() && json["extras"].contains("targetNames") &&
            json["extras"]["targetNames"].is_array() && i < json["extras"]["targetNames"].size() &&
            json["extras"]["targetNames"][i].is_string())
            name = json["extras"]["targetNames"][i].get<std::string>();
        names.push_back(std::move(name));
    }
    return names;
}

// One set (the i-th) of texture coordinates or colours of all primitives.
CornerAttribute joined_corners(const std::vector<Primitive>& primitives, std::size_t set,
                               std::vector<Matrix> Primitive::*sets, Index n_triangles) {
    Eigen::Index rows = 0, columns = 0;
    for (const Primitive& primitive : primitives) {
        if (set >= (primitive.*sets).size()) continue;
        rows += (primitive.*sets)[set].rows();
        columns = std::max(columns, (primitive.*sets)[set].cols());
    }
    CornerAttribute joined{Matrix::Ones(rows, columns), Triangles::Constant(n_triangles, 3, -1)};
    Eigen::Index row = 0, triangle = 0;
    for (const Primitive& primitive : primitives) {
        if (set < (primitive.*sets).size()) {
            const Matrix& values = (primitive.*sets)[set];
            joined.values.block(row, 0, values.rows(), values.cols()) = values;
            joined.corners.middleRows(triangle, primitive.triangles.rows()) =
                primitive.triangles.array() + static_cast<Index>(row);
            row += values.rows();
        }
        triangle += primitive.triangles.rows();
    }
    return joined;
}

void join_geometry(const GltfDocument& document, const std::vector<Primitive>& primitives, GltfFile& file) {
    std::unordered_map<std::string, Index> known;
    std::vector<std::pair<const Primitive*, Eigen::Index>> kept;
    std::vector<Index> corners;
    Eigen::Index joints = 0;
    std::size_t n_morphs = 0;
    const Primitive* morphed = nullptr;
    for (const Primitive& primitive : primitives) {
        const std::size_t start = file.vertex_from_file.size();
        for (Eigen::Index v = 0; v < primitive.positions.rows(); ++v) {
            const auto [place, is_new] =
                known.emplace(weld_key(primitive, v), static_cast<Index>(kept.size()));
            if (is_new) kept.emplace_back(&primitive, v);
            file.vertex_from_file.push_back(place->second);
        }
        for (Eigen::Index t = 0; t < primitive.triangles.rows(); ++t)
            for (int c = 0; c < 3; ++c)
                corners.push_back(
                    file.vertex_from_file[start + static_cast<std::size_t>(primitive.triangles(t, c))]);
        joints = std::max(joints, primitive.skin.joints.cols());
        if (primitive.displacements.size() > n_morphs) morphed = &primitive;
        n_morphs = std::max(n_morphs, primitive.displacements.size());
    }
    if (kept.size() < file.vertex_from_file.size()) {
        file.notices.push_back(fmt::format("{} vertices split at seams joined: {} -> {}",
                                           file.vertex_from_file.size() - kept.size(),
                                           file.vertex_from_file.size(), kept.size()));
    }
    const auto n = static_cast<Eigen::Index>(kept.size());
    AttributedMesh& content = file.content;
    content.mesh.vertices.resize(n, 3);
    content.mesh.triangles =
        Eigen::Map<const Triangles>(corners.data(), static_cast<Eigen::Index>(corners.size() / 3), 3);
    content.skin.joints.setZero(n, joints);
    content.skin.weights.setZero(n, joints);
    if (morphed != nullptr) {
        for (const std::string& name : morph_names(document, morphed->mesh, n_morphs))
            content.morphs.push_back({name, Points::Zero(n, 3)});
    }
    for (Eigen::Index v = 0; v < n; ++v) {
        const auto& [primitive, row] = kept[static_cast<std::size_t>(v)];
        content.mesh.vertices.row(v) = primitive->positions.row(row);
        const Eigen::Index k = primitive->skin.joints.cols();
        if (k > 0) {
            content.skin.joints.row(v).head(k) = primitive->skin.joints.row(row);
            content.skin.weights.row(v).head(k) = primitive->skin.weights.row(row);
        }
        for (std::size_t i = 0; i < primitive->displacements.size(); ++i)
            content.morphs[i].displacements.row(v) = primitive->displacements[i].row(row);
    }
}

}  // namespace

GltfFile read_gltf(const std::filesystem::path& path) {
    const GltfDocument document = load_gltf(path);
    GltfFile file;
    try {
        const std::vector<Primitive> primitives = read_primitives(document, file.notices);
        join_geometry(document, primitives, file);
        std::size_t n_coordinates = 0, n_colors = 0;
        for (const Primitive& primitive : primitives) {
            n_coordinates = std::max(n_coordinates, primitive.texture_coordinates.size());
            n_colors = std::max(n_colors, primitive.colors.size());
        }
        const Index n_triangles = file.content.mesh.n_triangles();
        for (std::size_t i = 0; i < n_coordinates; ++i)
            file.content.texture_coordinates.push_back(
                joined_corners(primitives, i, &Primitive::texture_coordinates, n_triangles));
        for (std::size_t i = 0; i < n_colors; ++i)
            file.content.colors.push_back(joined_corners(primitives, i, &Primitive::colors, n_triangles));
        require_valid(file.content.mesh);
    } catch (const GltfJson::exception& error) {
        document.fail(fmt::format("the JSON is not glTF ({})", error.what()));
    } catch (const InvalidInput& error) {
        document.fail(error.what());
    }
    return file;
}

}  // namespace counterpart
