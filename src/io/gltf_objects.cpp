// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "io/gltf_objects.hpp"

#include "io/gltf_morph_weights.hpp"
#include "io/gltf_scene.hpp"

#include <algorithm>
#include <utility>

namespace counterpart::io {
namespace {

std::string name_in(const GltfJson& json) {
    return json.contains("name") && json["name"].is_string() ? json["name"].get<std::string>() : "";
}

// The shown meshes that a node before has shown already.
std::vector<ShownMesh> shown_again(const GltfDocument& document) {
    std::vector<char> known(document.count("meshes"), 0);
    std::vector<ShownMesh> again;
    for (const ShownMesh& shown : shown_meshes(document))
        if (known[static_cast<std::size_t>(shown.mesh)]++) again.push_back(shown);
    return again;
}

std::int64_t count_at(const GltfDocument& document, const GltfJson& object, const char* key) {
    const std::int64_t accessor = number_at(document, object, key, -1);
    return accessor < 0 ? 0 : number_at(document, document.element("accessors", accessor), "count", 0);
}

// About how many numbers it takes to read each mesh and, joined, to give its vertices the joints and blend
// shapes that any mesh has.
std::vector<double> costs_of_meshes(const GltfDocument& document) {
    std::vector<double> costs;
    std::size_t most_targets = 0;
    std::vector<std::int64_t> n_vertices;
    for (std::size_t m = 0; m < document.count("meshes"); ++m) {
        const GltfJson& mesh = document.element("meshes", static_cast<std::int64_t>(m));
        constexpr double numbers_per_character = 8;  // JSON takes more memory than its text
        const auto text = mesh.dump(-1, ' ', false, GltfJson::error_handler_t::replace).size();
        double cost = numbers_per_character * static_cast<double>(text);
        std::int64_t rows_of_mesh = 0;
        for (const GltfJson& primitive : mesh.at("primitives")) {
            const std::int64_t rows = count_at(document, primitive.at("attributes"), "POSITION");
            const std::size_t targets = primitive.contains("targets") ? primitive["targets"].size() : 0;
            cost += static_cast<double>(rows) * static_cast<double>(4 * primitive["attributes"].size()) +
                    static_cast<double>(count_at(document, primitive, "indices"));
            most_targets = std::max(most_targets, targets);
            rows_of_mesh += rows;
        }
        costs.push_back(cost);
        n_vertices.push_back(rows_of_mesh);
    }
    constexpr double most_joints = 8;
    for (std::size_t m = 0; m < costs.size(); ++m)
        costs[m] +=
            static_cast<double>(n_vertices[m]) * (most_joints + 6 * static_cast<double>(most_targets));
    return costs;
}

}  // namespace

std::string object_name(const GltfDocument& document, const GltfPrimitive& primitive) {
    std::string name = primitive.node < 0 ? "" : name_in(document.element("nodes", primitive.node));
    return name.empty() ? name_in(document.element("meshes", static_cast<std::int64_t>(primitive.mesh)))
                        : name;
}

GltfDocument with_a_mesh_for_each_node(GltfDocument document) {
    const std::vector<ShownMesh> again = shown_again(document);
    if (again.empty()) return document;
    const std::vector<double> costs = costs_of_meshes(document);
    double cost = 0;
    for (const ShownMesh& shown : again) cost += costs[static_cast<std::size_t>(shown.mesh)];
    constexpr double share = 0.25;
    if (cost > share * static_cast<double>(GltfBudget(document).left())) return document;
    GltfJson& meshes = document.json["meshes"];
    for (const ShownMesh& shown : again) {
        GltfJson copy = meshes[static_cast<std::size_t>(shown.mesh)];
        document.json["nodes"][static_cast<std::size_t>(shown.node)]["mesh"] = meshes.size();
        meshes.push_back(std::move(copy));
    }
    return document;
}

GltfDocument with_only_mesh(GltfDocument document, std::size_t mesh) {
    GltfJson only = std::move(document.json["meshes"][mesh]);
    document.json["meshes"] = GltfJson::array();
    document.json["meshes"].push_back(std::move(only));
    std::vector<std::int64_t> emptied;
    for (std::size_t i = 0; i < document.count("nodes"); ++i) {
        GltfJson& node = document.json["nodes"][i];
        if (!node.contains("mesh")) continue;
        if (number_at(document, node, "mesh", -1) == static_cast<std::int64_t>(mesh)) {
            node["mesh"] = 0;
        } else {
            for (const char* key : {"mesh", "skin", "weights"}) node.erase(key);
            emptied.push_back(static_cast<std::int64_t>(i));
        }
    }
    if (!emptied.empty()) forget_weight_channels(document, emptied);
    return document;
}

}  // namespace counterpart::io
