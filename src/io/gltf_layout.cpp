// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "io/gltf_layout.hpp"

#include <counterpart/base/errors.hpp>

#include <map>
#include <utility>

#include <fmt/format.h>

namespace counterpart::io {
namespace {

bool share_vertices(const MeshObjects& objects, MeshView mesh) {
    std::vector<Index> object_of(static_cast<std::size_t>(mesh.n_vertices()), -1);
    for (Index t = 0; t < mesh.n_triangles(); ++t) {
        const Index object = objects.of_triangle[static_cast<std::size_t>(t)];
        for (int c = 0; c < 3; ++c) {
            Index& known = object_of[static_cast<std::size_t>(mesh.triangles(t, c))];
            if (known >= 0 && known != object) return true;
            known = object;
        }
    }
    return false;
}

// For each triangle the object whose node shows it.
std::vector<Index> nodes_of_triangles(const AttributedMesh& content) {
    const bool is_apart = content.objects.names.size() > 1 && !share_vertices(content.objects, content.mesh);
    return is_apart ? content.objects.of_triangle
                    : std::vector<Index>(static_cast<std::size_t>(content.mesh.n_triangles()), 0);
}

// Its name, where the node shows nothing else.
std::string name_of_node(const MeshObjects& objects, Index object, std::size_t n_nodes) {
    const bool is_object = n_nodes > 1 || objects.names.size() == 1;
    return is_object ? objects.names[static_cast<std::size_t>(object)] : "";
}

// Materials by the names of parts, which primitives of several nodes may share.
class PartMaterials {
  public:
    PartMaterials(const std::vector<std::string>& names, GltfJson& json)
        : names_(names), json_(json), numbers_(names.size(), -1) {}

    /// Gives the primitive the material of the part's name, if it has one.
    void name(GltfJson& primitive, Index part) {
        const auto label = static_cast<std::size_t>(part);
        if (label >= names_.size() || names_[label].empty()) return;
        if (numbers_[label] < 0) {
            numbers_[label] = json_.contains("materials") ? std::ssize(json_["materials"]) : 0;
            json_["materials"].push_back({{"name", names_[label]}});
        }
        primitive["material"] = numbers_[label];
    }

  private:
    const std::vector<std::string>& names_;
    GltfJson& json_;
    std::vector<std::int64_t> numbers_;
};

}  // namespace

GltfLayout layout_of(const AttributedMesh& content) {
    GltfLayout layout;
    // By node, then by part, as the list of primitives is.
    const std::vector<Index> node_of_triangle = nodes_of_triangles(content);
    std::map<std::pair<Index, Index>, Index> numbers;
    const auto key_of = [&](std::size_t t) {
        return std::pair(node_of_triangle[t], content.parts.empty() ? 0 : content.parts[t]);
    };
    for (std::size_t t = 0; t < node_of_triangle.size(); ++t) numbers.emplace(key_of(t), 0);
    GltfJson& json = layout.document.json;
    json = {{"asset", {{"version", "2.0"}, {"generator", "counterpart"}}},
            {"scene", 0},
            {"scenes", {{{"nodes", GltfJson::array()}}}},
            {"nodes", GltfJson::array()},
            {"meshes", GltfJson::array()}};
    PartMaterials materials(content.part_names, json);
    std::vector<Index> object_of_node;
    for (auto& [key, number] : numbers) {
        const auto [object, part] = key;
        if (part < 0) throw InvalidInput(fmt::format("a triangle belongs to part {}", part));
        if (object_of_node.empty() || object_of_node.back() != object) {
            json["scenes"][0]["nodes"].push_back(object_of_node.size());
            json["nodes"].push_back({{"mesh", object_of_node.size()}});
            json["meshes"].push_back({{"primitives", GltfJson::array()}});
            object_of_node.push_back(object);
        }
        number = static_cast<Index>(layout.primitives.size());
        GltfPrimitive& primitive = layout.primitives.emplace_back();
        primitive.mesh = json["meshes"].size() - 1;
        primitive.number = json["meshes"].back()["primitives"].size();
        GltfJson stored = {{"attributes", GltfJson::object()}};
        materials.name(stored, part);
        json["meshes"].back()["primitives"].push_back(std::move(stored));
    }
    for (std::size_t node = 0; node < object_of_node.size(); ++node) {
        std::string name = name_of_node(content.objects, object_of_node[node], object_of_node.size());
        if (!name.empty()) json["nodes"][node]["name"] = std::move(name);
    }
    for (std::size_t t = 0; t < node_of_triangle.size(); ++t)
        layout.primitive_of_triangle.push_back(numbers.at(key_of(t)));
    return layout;
}

}  // namespace counterpart::io
