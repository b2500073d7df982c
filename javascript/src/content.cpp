// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "content.hpp"

#include "arrays.hpp"
#include "guarded.hpp"

#include <counterpart/io/mesh_file.hpp>
#include <counterpart/io/mesh_objects.hpp>
#include <counterpart/transfer/transfer.hpp>

#include <utility>

#include <emscripten/bind.h>
#include <fmt/format.h>

namespace counterpart::javascript {
namespace {

// `object` null: the whole file.
val read_content(const std::string& name, bool strict, const val& object) {
    return guarded([&] {
        ReadOptions options{.strict = strict};
        if (!object.isNull()) options.object = object.as<std::string>();
        AttributedMeshFile file = read_attributed_mesh(name, options);
        Content content{std::move(file.content), std::move(file.notices)};
        content.images = read_base_colors(content.content, name, options);
        for (std::string& notice : content.images.notices) content.notices.push_back(std::move(notice));
        return content;
    });
}

val write_content(const Content& content, const std::string& name) {
    return guarded([&] {
        write_attributed_mesh(content.content, name);
        return true;
    });
}

val content_of(const val& vertices, const val& triangles) {
    return guarded([&] {
        const std::vector<double> coordinates = numbers_of<double>(vertices);
        const std::vector<Index> corners = numbers_of<Index>(triangles);
        if (coordinates.size() % 3 != 0 || corners.size() % 3 != 0)
            throw InvalidInput(
                fmt::format("{} coordinates and {} corners of triangles: both must be three for each",
                            coordinates.size(), corners.size()));
        Content content;
        content.content.mesh = {PointsView(coordinates.data(), std::ssize(coordinates) / 3, 3),
                                TrianglesView(corners.data(), std::ssize(corners) / 3, 3)};
        require_valid(content.content.mesh);
        return content;
    });
}

val extensions() {
    const MeshExtensions known = mesh_extensions();
    val result = val::object();
    result.set("read", array_of(known.read));
    result.set("written", array_of(known.written));
    return result;
}

}  // namespace

val Content::vertices() const {
    return array_of(content.mesh.vertices.data(), static_cast<std::size_t>(content.mesh.vertices.size()));
}
val Content::triangles() const {
    return array_of(content.mesh.triangles.data(), static_cast<std::size_t>(content.mesh.triangles.size()));
}
val Content::attributes() const {
    std::vector<std::string> names;
    const auto add = [&](bool has, const char* name) {
        if (has) names.emplace_back(name);
    };
    add(!content.colors.empty(), "colors");
    add(!content.texture_coordinates.empty(), "textureCoordinates");
    add(content.normals.values.rows() > 0, "normals");
    add(content.skin.weights.size() > 0, "skin");
    add(!content.morphs.empty(), "morphs");
    add(has_materials(content), "materials");
    return array_of(names);
}
val Content::sentences() const { return array_of(notices); }
val Content::objects() const {
    val objects = val::array();
    for (const MeshObject& object : mesh_objects(content)) {
        val fields = val::object();
        fields.set("name", object.name);
        fields.set("nVertices", object.n_vertices);
        fields.set("nTriangles", object.n_triangles);
        objects.call<void>("push", fields);
    }
    return objects;
}

EMSCRIPTEN_BINDINGS(content) {
    emscripten::class_<Content>("Content")
        .function("vertices", &Content::vertices)
        .function("triangles", &Content::triangles)
        .function("attributes", &Content::attributes)
        .function("notices", &Content::sentences)
        .function("objects", &Content::objects);
    emscripten::function("readContent", &read_content);
    emscripten::function("writeContent", &write_content);
    emscripten::function("contentOf", &content_of);
    emscripten::function("extensions", &extensions);
}

}  // namespace counterpart::javascript
