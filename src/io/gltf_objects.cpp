// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "io/gltf_objects.hpp"

#include "io/gltf_morph_weights.hpp"

#include <utility>

namespace counterpart::io {
namespace {

std::string name_in(const GltfJson& json) {
    return json.contains("name") && json["name"].is_string() ? json["name"].get<std::string>() : "";
}

}  // namespace

std::string object_name(const GltfDocument& document, const GltfPrimitive& primitive) {
    std::string name = primitive.node < 0 ? "" : name_in(document.element("nodes", primitive.node));
    return name.empty() ? name_in(document.element("meshes", static_cast<std::int64_t>(primitive.mesh)))
                        : name;
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
