// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "io/chosen_object.hpp"
#include "io/gltf_objects.hpp"
#include "io/gltf_primitives.hpp"
#include "io/object_sections.hpp"

#include <counterpart/base/errors.hpp>

#include <algorithm>
#include <unordered_map>
#include <utility>

#include <fmt/format.h>

namespace counterpart {

using namespace io;

namespace {

// The bytes by which vertices of one mesh are told apart; -0 counts as 0.
std::string weld_key(const GltfPrimitive& primitive, Eigen::Index v) {
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
    for (PointsView displacement : primitive.displacements)
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

std::string material_name(const GltfDocument& document, const GltfPrimitive& primitive) {
    const GltfJson& mesh = document.element("meshes", static_cast<std::int64_t>(primitive.mesh));
    const GltfJson& json = mesh.at("primitives").at(primitive.number);
    if (!json.contains("material")) return "";
    const GltfJson& material = document.element("materials", number_at(document, json, "material", 0));
    return material.contains("name") && material["name"].is_string() ? material["name"].get<std::string>()
                                                                     : "";
}

// One kind of corner values of all primitives; `values_of` gives a primitive's, or null.
template <class ValuesOf>
CornerAttribute joined_corners(const std::vector<GltfPrimitive>& primitives, Index n_triangles,
                               const ValuesOf& values_of) {
    Eigen::Index rows = 0, columns = 0;
    for (const GltfPrimitive& primitive : primitives) {
        if (const Matrix* values = values_of(primitive)) {
            rows += values->rows();
            columns = std::max(columns, values->cols());
        }
    }
    if (rows == 0) return {};
    CornerAttribute joined{Matrix::Ones(rows, columns), Triangles::Constant(n_triangles, 3, -1)};
    Eigen::Index row = 0, triangle = 0;
    for (const GltfPrimitive& primitive : primitives) {
        if (const Matrix* values = values_of(primitive)) {
            joined.values.block(row, 0, values->rows(), values->cols()) = *values;
            joined.corners.middleRows(triangle, primitive.triangles.rows()) =
                primitive.triangles.array() + static_cast<Index>(row);
            row += values->rows();
        }
        triangle += primitive.triangles.rows();
    }
    return joined;
}

// The same, for each set of several.
std::vector<CornerAttribute> joined_sets(const std::vector<GltfPrimitive>& primitives, Index n_triangles,
                                         std::vector<Matrix> GltfPrimitive::*sets) {
    std::size_t count = 0;
    for (const GltfPrimitive& primitive : primitives) count = std::max(count, (primitive.*sets).size());
    std::vector<CornerAttribute> joined;
    for (std::size_t i = 0; i < count; ++i) {
        joined.push_back(joined_corners(primitives, n_triangles, [&](const GltfPrimitive& primitive) {
            return i < (primitive.*sets).size() ? &(primitive.*sets)[i] : nullptr;
        }));
    }
    return joined;
}

// Joined, all primitives get as many joints, blend shapes and names as the richest has.
void require_room(const GltfDocument& document, const std::vector<GltfPrimitive>& primitives) {
    GltfBudget budget(document);
    Eigen::Index rows = 0, columns = 0;
    for (const GltfPrimitive& primitive : primitives) {
        rows += primitive.positions.rows();
        columns = std::max(columns, primitive.skin.joints.cols() +
                                        3 * static_cast<Eigen::Index>(primitive.displacements.size()));
        budget.take(1, static_cast<std::int64_t>(material_name(document, primitive).size()));
    }
    budget.take(rows, columns);
}

void join_geometry(const GltfDocument& document, const std::vector<GltfPrimitive>& primitives,
                   GltfFile& file) {
    std::unordered_map<std::string, Index> known;
    std::vector<std::pair<const GltfPrimitive*, Eigen::Index>> kept;
    std::vector<Index> corners;
    Eigen::Index joints = 0;
    std::size_t n_morphs = 0;
    const GltfPrimitive* morphed = nullptr;
    const GltfPrimitive* previous = nullptr;
    ObjectSections objects;
    for (const GltfPrimitive& primitive : primitives) {
        const std::size_t start = file.vertex_from_file.size();
        if (previous == nullptr || previous->mesh != primitive.mesh)
            objects.begin(object_name(document, primitive), std::ssize(kept), std::ssize(corners) / 3);
        previous = &primitive;
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
    content.objects =
        objects.objects(static_cast<Index>(n), content.mesh.n_triangles(), ObjectSections::SameName::several);
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

// Read again, from a document that shows nothing else.
GltfFile surface_of_object(const GltfDocument& document, const std::vector<GltfPrimitive>& primitives,
                           const AttributedMesh& whole, const std::string& wanted) {
    const MeshObjects& objects = whole.objects;
    const Index object = chosen_object(objects.names, wanted);
    const auto triangle =
        static_cast<std::size_t>(std::find(objects.of_triangle.begin(), objects.of_triangle.end(), object) -
                                 objects.of_triangle.begin());
    const std::size_t mesh = primitives[static_cast<std::size_t>(whole.parts[triangle])].mesh;
    GltfFile file = surface_of(with_only_mesh(document, mesh));
    file.notices.push_back(object_notice(objects.names, object, file.content.mesh));
    return file;
}

}  // namespace

GltfFile io::join_primitives(const GltfDocument& document, const std::vector<GltfPrimitive>& primitives) {
    GltfFile file;
    require_room(document, primitives);
    join_geometry(document, primitives, file);
    AttributedMesh& content = file.content;
    const Index n_triangles = content.mesh.n_triangles();
    content.normals = joined_corners(primitives, n_triangles, [](const GltfPrimitive& primitive) {
        return primitive.normals.rows() > 0 ? &primitive.normals : nullptr;
    });
    content.texture_coordinates = joined_sets(primitives, n_triangles, &GltfPrimitive::texture_coordinates);
    content.colors = joined_sets(primitives, n_triangles, &GltfPrimitive::colors);
    for (std::size_t part = 0; part < primitives.size(); ++part)
        content.parts.insert(content.parts.end(), static_cast<std::size_t>(primitives[part].triangles.rows()),
                             static_cast<Index>(part));
    for (const GltfPrimitive& primitive : primitives)
        content.part_names.push_back(material_name(document, primitive));
    return file;
}

GltfFile io::surface_of(GltfDocument stored, const std::optional<std::string>& object) {
    const std::string name = stored.name;
    try {
        GltfDocument gltf = with_a_mesh_for_each_node(std::move(stored));
        std::vector<std::string> notices;
        const std::vector<GltfPrimitive> primitives = read_primitives(gltf, notices);
        GltfFile file = join_primitives(gltf, primitives);
        const std::vector<std::string>& names = file.content.objects.names;
        if (object && names.size() > 1) return surface_of_object(gltf, primitives, file.content, *object);
        file.notices.insert(file.notices.begin(), notices.begin(), notices.end());
        require_valid(file.content.mesh);
        if (object)
            file.notices.push_back(object_notice(names, chosen_object(names, *object), file.content.mesh));
        file.content.document = std::make_shared<const GltfContent>(std::move(gltf));
        return file;
    } catch (const GltfJson::exception& error) {
        throw IoError(fmt::format("{}: the JSON is not glTF ({})", name, error.what()));
    } catch (const InvalidInput& error) {
        throw IoError(fmt::format("{}: {}", name, error.what()));
    }
}

GltfFile read_gltf(const std::filesystem::path& file, const ReadOptions& options) {
    return surface_of(load_gltf(file, options), options.object);
}

}  // namespace counterpart
