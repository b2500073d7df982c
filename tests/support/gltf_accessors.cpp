// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/gltf_accessors.hpp"

#include "../../src/io/gltf_document.hpp"

namespace counterpart::test {
namespace {

std::string view_bytes(const io::GltfDocument& document, const io::GltfJson& place) {
    if (!place.contains("bufferView")) return "";
    const io::GltfJson& view = document.json["bufferViews"].at(place["bufferView"].get<std::size_t>());
    const std::string& bytes = document.buffers.at(view.at("buffer").get<std::size_t>());
    const auto start = view.value("byteOffset", std::size_t{0});
    return start > bytes.size() ? "" : bytes.substr(start, view.at("byteLength").get<std::size_t>());
}

// A view that reaches past its buffer may find padding there in the copy.
bool same_bytes(const std::string& before, const std::string& after) {
    return after.compare(0, before.size(), before) == 0;
}

}  // namespace

std::string accessor_difference(const std::filesystem::path& before, const std::filesystem::path& after) {
    const io::GltfDocument a = io::load_gltf(before), b = io::load_gltf(after);
    if (a.count("accessors") != b.count("accessors")) return "the number of accessors";
    for (const char* list :
         {"meshes", "skins", "nodes", "animations", "materials", "textures", "samplers", "scenes", "cameras"})
        if (a.count(list) > 0 && a.json[list] != b.json[list]) return list;
    for (const char* key : {"extensions", "extensionsUsed", "extensionsRequired", "extras", "scene", "asset"})
        if (a.json.contains(key) && (!b.json.contains(key) || a.json[key] != b.json[key])) return key;
    for (std::size_t i = 0; i < a.count("accessors"); ++i) {
        const io::GltfJson& one = a.json["accessors"][i];
        const io::GltfJson& other = b.json["accessors"][i];
        if (one != other) return "accessor " + std::to_string(i) + ": " + one.dump() + " " + other.dump();
        if (!same_bytes(view_bytes(a, one), view_bytes(b, other)))
            return "the bytes of accessor " + std::to_string(i);
        if (!one.contains("sparse")) continue;
        for (const char* part : {"indices", "values"})
            if (!same_bytes(view_bytes(a, one["sparse"][part]), view_bytes(b, other["sparse"][part])))
                return "the sparse bytes of accessor " + std::to_string(i);
    }
    return "";
}

}  // namespace counterpart::test
