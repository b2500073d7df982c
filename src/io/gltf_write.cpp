// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "io/corner_rows.hpp"
#include "io/formats.hpp"
#include "io/gltf_layout.hpp"
#include "io/gltf_morph_weights.hpp"
#include "io/gltf_split.hpp"
#include "io/gltf_store.hpp"
#include "platform/files.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/io/file.hpp>
#include <counterpart/io/gltf.hpp>

#include <algorithm>

#include <fmt/format.h>

namespace counterpart {

using namespace io;

namespace {

// What to write into, and what it holds already.
struct Stored {
    GltfDocument document;
    std::vector<GltfPrimitive> primitives;
    std::vector<Index> primitive_of_triangle;  // of the content that is to be written
    GltfFile file;                             // nothing if the document's primitives hold nothing yet
};

Stored stored_content(const AttributedMesh& content) {
    const GltfDocument* document = gltf_of(content);
    if (document == nullptr) {
        GltfLayout layout = layout_of(content);
        return {std::move(layout.document),
                std::move(layout.primitives),
                std::move(layout.primitive_of_triangle),
                {}};
    }
    Stored stored{*document, {}, content.parts, {}};
    std::vector<std::string> ignored;
    stored.primitives = read_primitives(stored.document, ignored);
    stored.file = join_primitives(stored.document, stored.primitives);
    stored.primitive_of_triangle.resize(static_cast<std::size_t>(content.mesh.n_triangles()), 0);
    return stored;
}

std::vector<std::vector<Index>> triangles_of_primitives(const Stored& stored) {
    std::vector<std::vector<Index>> triangles(stored.primitives.size());
    for (std::size_t t = 0; t < stored.primitive_of_triangle.size(); ++t) {
        const Index primitive = stored.primitive_of_triangle[t];
        if (primitive < 0 || static_cast<std::size_t>(primitive) >= triangles.size())
            throw InvalidInput(fmt::format("triangle {} belongs to part {} where the file has {} parts", t,
                                           primitive, triangles.size()));
        triangles[static_cast<std::size_t>(primitive)].push_back(static_cast<Index>(t));
    }
    return triangles;
}

// How many blend shapes each mesh is to have: glTF wants as many in all its primitives.
std::vector<std::size_t> morph_counts(const Stored& stored, const AttributedMesh& content,
                                      const std::vector<GltfPrimitive>& wanted) {
    std::vector<std::size_t> counts(std::max<std::size_t>(stored.document.count("meshes"), 1), 0);
    const bool same_set = std::equal(content.morphs.begin(), content.morphs.end(),
                                     stored.file.content.morphs.begin(), stored.file.content.morphs.end(),
                                     [](const auto& a, const auto& b) { return a.name == b.name; });
    for (std::size_t p = 0; p < wanted.size(); ++p) {
        std::size_t& count = counts[stored.primitives[p].mesh];
        count = std::max(count, same_set ? stored.primitives[p].displacements.size() : content.morphs.size());
        for (std::size_t i = count; i < wanted[p].displacements.size(); ++i)
            if (!wanted[p].displacements[i].isZero(0)) count = i + 1;
    }
    return counts;
}

void name_morphs(Stored& stored, const AttributedMesh& content, const std::vector<std::size_t>& counts) {
    std::vector<std::size_t> before(counts.size(), 0);
    for (const GltfPrimitive& primitive : stored.primitives)
        before[primitive.mesh] = std::max(before[primitive.mesh], primitive.displacements.size());
    const std::vector<MorphTarget>& old = stored.file.content.morphs;
    for (std::size_t m = 0; m < counts.size(); ++m) {
        bool same = counts[m] == before[m];
        for (std::size_t i = 0; i < counts[m] && same; ++i) same = old[i].name == content.morphs[i].name;
        if (same) continue;
        if (counts[m] != before[m] && before[m] > 0) forget_morph_weights(stored.document, m);
        GltfJson& mesh = stored.document.json["meshes"][m];
        GltfJson names = GltfJson::array();
        for (std::size_t i = 0; i < counts[m]; ++i) names.push_back(content.morphs[i].name);
        mesh["extras"]["targetNames"] = std::move(names);
    }
}

void require_skeleton(const Stored& stored, const std::vector<GltfPrimitive>& wanted) {
    std::vector<std::int64_t> n_joints(std::max<std::size_t>(stored.document.count("meshes"), 1), 0);
    for (std::size_t i = 0; i < stored.document.count("nodes"); ++i) {
        const GltfJson& node = stored.document.element("nodes", static_cast<std::int64_t>(i));
        if (!node.contains("mesh") || !node.contains("skin")) continue;
        const std::int64_t mesh = number_at(stored.document, node, "mesh", 0);
        stored.document.element("meshes", mesh);  // a node that no scene shows may name any
        const GltfJson& skin = stored.document.element("skins", number_at(stored.document, node, "skin", -1));
        n_joints[static_cast<std::size_t>(mesh)] = static_cast<std::int64_t>(skin.at("joints").size());
    }
    for (std::size_t p = 0; p < wanted.size(); ++p) {
        const SkinBinding& skin = wanted[p].skin;
        if (skin.weights.size() == 0 || skin.weights.isZero(0)) continue;
        const std::int64_t available = n_joints[stored.primitives[p].mesh];
        // A file may have had weights without a skeleton before.
        if (available == 0 && stored.primitives[p].skin.weights.size() > 0) continue;
        if (available == 0)
            throw InvalidInput("there are skin weights but no skeleton that they could refer to");
        const auto in_use = (skin.weights.array() != 0).select(skin.joints.array(), 0);
        if (in_use.minCoeff() < 0 || in_use.maxCoeff() >= available)
            throw InvalidInput(fmt::format("a vertex is bound to joint {} where the skeleton has {}",
                                           in_use.minCoeff() < 0 ? in_use.minCoeff() : in_use.maxCoeff(),
                                           available));
    }
}

// Primitives without triangles are not allowed, nor meshes without primitives.
void remove_empty(Stored& stored, const std::vector<GltfPrimitive>& wanted) {
    GltfJson& json = stored.document.json;
    for (std::size_t p = wanted.size(); p-- > 0;) {
        if (wanted[p].triangles.rows() > 0) continue;
        json["meshes"][stored.primitives[p].mesh]["primitives"].erase(stored.primitives[p].number);
    }
    for (std::size_t m = json["meshes"].size(); m-- > 0;) {
        if (!json["meshes"][m]["primitives"].empty()) continue;
        json["meshes"].erase(m);
        for (GltfJson& node : json["nodes"]) {
            const std::int64_t mesh = number_at(stored.document, node, "mesh", -1);
            if (mesh == static_cast<std::int64_t>(m))
                for (const char* key : {"mesh", "skin", "weights"}) node.erase(key);
            else if (mesh > static_cast<std::int64_t>(m))
                node["mesh"] = mesh - 1;
        }
    }
}

void store(Stored& stored, const AttributedMesh& content) {
    MeshView before = stored.file.content.mesh;
    const auto parts = triangles_of_primitives(stored);
    const bool same_surface = before.n_vertices() == content.mesh.n_vertices() &&
                              before.n_triangles() == content.mesh.n_triangles() &&
                              before.triangles == content.mesh.triangles &&
                              (stored.primitives.size() == 1 || content.parts == stored.file.content.parts);
    std::vector<GltfPrimitive> wanted;
    std::vector<char> same_vertices(stored.primitives.size(), 0);
    GltfOffsets offsets;
    for (std::size_t p = 0; p < stored.primitives.size(); ++p) {
        std::optional<GltfPrimitive> kept;
        if (same_surface)
            kept = in_same_vertices(stored.primitives[p], offsets, stored.file.vertex_from_file, content);
        same_vertices[p] = kept.has_value();
        wanted.push_back(kept ? std::move(*kept) : in_new_vertices(parts[p], content));
        offsets.vertex += static_cast<std::size_t>(stored.primitives[p].positions.rows());
        offsets.triangle += static_cast<Index>(stored.primitives[p].triangles.rows());
    }
    require_skeleton(stored, wanted);
    const std::vector<std::size_t> counts = morph_counts(stored, content, wanted);
    name_morphs(stored, content, counts);
    for (std::size_t p = 0; p < wanted.size(); ++p) {
        wanted[p].displacements.resize(counts[stored.primitives[p].mesh]);
        if (wanted[p].triangles.rows() > 0)
            store_primitive(stored.document, stored.primitives[p], wanted[p], same_vertices[p] != 0);
    }
    remove_empty(stored, wanted);
}

}  // namespace

std::string io::gltf_bytes(const AttributedMesh& content, bool binary, double frames_per_second) {
    require_consistent(content);
    Stored stored = stored_content(content);
    store(stored, content);
    if (frames_per_second > 0) play_morph_targets(stored.document, frames_per_second);
    return gltf_bytes(std::move(stored.document), binary);
}

void write_gltf(const AttributedMesh& content, const std::filesystem::path& file, double frames_per_second) {
    if (!(frames_per_second >= 0)) throw InvalidInput("write_gltf: frames_per_second must not be negative");
    try {
        write_file(gltf_bytes(content, lower_extension(file) != ".gltf", frames_per_second), file);
    } catch (const InvalidInput& error) {
        throw IoError(fmt::format("{}: not written: {}", platform::utf8_name(file), error.what()));
    } catch (const GltfJson::exception& error) {
        throw IoError(fmt::format("{}: not written: the JSON of {} is not glTF ({})",
                                  platform::utf8_name(file),
                                  gltf_of(content) != nullptr ? gltf_of(content)->name : "it", error.what()));
    }
}

}  // namespace counterpart
