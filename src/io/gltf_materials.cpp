// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "io/gltf_primitives.hpp"

#include <counterpart/base/errors.hpp>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>

namespace counterpart::io {
namespace {

using Element = std::pair<std::string, std::int64_t>;  // a top-level list and a number in it

// Copies elements from one document to another, each once, with all that they refer to.
class Import {
  public:
    Import(const GltfDocument& from, GltfDocument& to) : from_(from), to_(to) { take_images_in(from_); }

    std::int64_t material(std::int64_t number) {
        return copied("materials", number, [this](GltfJson& json) { follow_textures(json); });
    }
    // What the copies need may not be known in the new document.
    void extensions() {
        for (const char* list : {"extensionsUsed", "extensionsRequired"}) {
            if (!from_.json.contains(list)) continue;
            std::set<std::string> known;
            for (const GltfJson& name : to_.json[list]) known.insert(name.get<std::string>());
            for (const GltfJson& json : from_.json[list]) {
                const auto name = json.get<std::string>();
                if (name.find("material") == std::string::npos && name.find("texture") == std::string::npos)
                    continue;
                if (known.insert(name).second) to_.json[list].push_back(name);
            }
            if (to_.json[list].is_null()) to_.json.erase(list);
        }
    }

  private:
    template <class Follow>
    std::int64_t copied(const char* list, std::int64_t number, const Follow& follow) {
        const auto known = copies_.find({list, number});
        if (known != copies_.end()) return known->second;
        GltfJson json = from_.element(list, number);
        follow(json);
        GltfJson& elements = to_.json[list];
        elements.push_back(std::move(json));
        const auto place = static_cast<std::int64_t>(elements.size()) - 1;
        copies_[{list, number}] = place;
        return place;
    }
    template <class Follow>
    void redirect(GltfJson& json, const char* key, const char* list, const Follow& follow) {
        if (json.contains(key)) json[key] = copied(list, number_at(from_, json, key, 0), follow);
    }
    // Whatever ends in "Texture" refers to one, in extensions too.
    void follow_textures(GltfJson& json) {
        if (!json.is_structured()) return;
        for (auto entry = json.begin(); entry != json.end(); ++entry) {
            if (json.is_object() && entry.key().ends_with("Texture") && entry->is_object())
                redirect(*entry, "index", "textures", [this](GltfJson& texture) { follow_images(texture); });
            follow_textures(*entry);
        }
    }
    void follow_images(GltfJson& texture) {
        const auto image = [this](GltfJson& json) {
            if (json.contains("bufferView"))
                json["bufferView"] =
                    append_view(to_, view_bytes(from_, number_at(from_, json, "bufferView", 0)));
        };
        redirect(texture, "sampler", "samplers", [](GltfJson&) {});
        redirect(texture, "source", "images", image);
        if (!texture.contains("extensions")) return;
        for (GltfJson& extension : texture["extensions"])
            if (extension.is_object()) redirect(extension, "source", "images", image);
    }
    GltfDocument from_;
    GltfDocument& to_;
    std::map<Element, std::int64_t> copies_;
};

GltfJson& json_of(GltfDocument& document, const GltfPrimitive& primitive) {
    return document.json["meshes"][primitive.mesh]["primitives"][primitive.number];
}

void set_material(GltfJson& primitive, std::int64_t material) {
    if (material < 0)
        primitive.erase("material");
    else
        primitive["material"] = material;
    if (!primitive.contains("extensions")) return;
    primitive["extensions"].erase("KHR_materials_variants");
    if (primitive["extensions"].empty()) primitive.erase("extensions");
}

}  // namespace

const GltfDocument* gltf_of(const AttributedMesh& content) {
    const auto* gltf = dynamic_cast<const GltfContent*>(content.document.get());
    return gltf == nullptr ? nullptr : &gltf->gltf();
}

bool GltfContent::has_materials() const {
    if (!gltf_.json.contains("meshes")) return false;
    for (const GltfJson& mesh : gltf_.json["meshes"])
        for (const GltfJson& primitive : mesh.at("primitives"))
            if (primitive.contains("material")) return true;
    return false;
}

std::shared_ptr<const Document> GltfContent::without_skeleton() const {
    GltfDocument result = gltf_;
    for (const char* list : {"skins", "animations"}) result.json.erase(list);
    for (std::size_t i = 0; i < result.count("nodes"); ++i) result.json["nodes"][i].erase("skin");
    return std::make_shared<const GltfContent>(std::move(result));
}

std::shared_ptr<const Document> GltfContent::without_materials() const {
    GltfDocument result = gltf_;
    std::vector<std::string> ignored;
    for (const GltfPrimitive& primitive : read_primitives(gltf_, ignored))
        set_material(json_of(result, primitive), -1);
    return std::make_shared<const GltfContent>(std::move(result));
}

Document::Assignment GltfContent::with_materials_of(const Document& other, const std::vector<Index>& parts,
                                                    const std::vector<Index>& source_parts) const {
    const auto* content = dynamic_cast<const GltfContent*>(&other);
    if (content == nullptr) throw InvalidInput("materials come from glTF files only");
    const GltfDocument& source = content->gltf();
    GltfDocument document = gltf_;
    std::vector<std::string> ignored;
    const std::vector<GltfPrimitive> own = read_primitives(document, ignored);
    const std::vector<GltfPrimitive> given = read_primitives(source, ignored);
    Import import(source, document);
    import.extensions();

    using Place = std::pair<std::size_t, std::size_t>;  // mesh, primitive
    std::map<std::pair<Index, Index>, Place> place_of;  // of an own part with a part of the source
    std::vector<char> taken(own.size(), 0);
    std::vector<Place> places;  // of the triangles
    for (std::size_t t = 0; t < source_parts.size(); ++t) {
        const Index part = parts.empty() ? 0 : parts[t], from = source_parts[t];
        if (part < 0 || part >= static_cast<Index>(own.size()) || from < 0 ||
            from >= static_cast<Index>(given.size()))
            throw InvalidInput(fmt::format("triangle {} names a part that its document has not", t));
        const GltfPrimitive& primitive = own[static_cast<std::size_t>(part)];
        const auto [known, is_new] =
            place_of.try_emplace({part, from}, Place{primitive.mesh, primitive.number});
        if (is_new) {
            const GltfPrimitive& wanted = given[static_cast<std::size_t>(from)];
            const std::int64_t number = number_at(
                source, source.json["meshes"][wanted.mesh]["primitives"][wanted.number], "material", -1);
            GltfJson json = json_of(document, primitive);
            set_material(json, number < 0 ? -1 : import.material(number));
            if (std::exchange(taken[static_cast<std::size_t>(part)], char{1}) != 0) {
                GltfJson& primitives = document.json["meshes"][primitive.mesh]["primitives"];
                known->second.second = primitives.size();
                primitives.push_back(std::move(json));
            } else {
                json_of(document, primitive) = std::move(json);
            }
        }
        places.push_back(known->second);
    }
    std::map<Place, Index> number;
    for (const GltfPrimitive& primitive : read_primitives(document, ignored))
        number.emplace(Place{primitive.mesh, primitive.number}, static_cast<Index>(number.size()));
    Assignment result;
    for (const Place& place : places) result.parts.push_back(number.at(place));
    result.document = std::make_shared<const GltfContent>(std::move(document));
    return result;
}

}  // namespace counterpart::io
