// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "arrays.hpp"
#include "content.hpp"
#include "guarded.hpp"

#include <counterpart/io/mesh_file.hpp>
#include <counterpart/render/camera.hpp>
#include <counterpart/viewer/viewer_page.hpp>

#include <utility>

#include <emscripten/bind.h>

namespace counterpart::javascript {
namespace {

ViewerAppearance appearance_of(const Content& content) {
    ViewerAppearance appearance;
    if (!content.images.images.empty())
        appearance = {content.content.texture_coordinates[0], content.images.images,
                      content.images.image_of_triangle};
    if (!content.content.colors.empty()) appearance.colors = content.content.colors[0];
    return appearance;
}

// Each of `maps` has a targetFromSource and a description; `confidence`, of the first, may be empty.
val scene_of(const Content& source, const Content& target, const std::string& source_name,
             const std::string& target_name, const val& maps, const val& confidence) {
    return guarded([&] {
        std::vector<ViewerMap> shown;
        for (unsigned i = 0; i < maps["length"].as<unsigned>(); ++i)
            shown.push_back({maps[i]["description"].as<std::string>(),
                             {numbers_of<Index>(maps[i]["targetFromSource"]), target.mesh().n_vertices()}});
        if (!shown.empty()) shown[0].confidence = numbers_of<double>(confidence);
        ViewerOptions options{.source_name = source_name, .target_name = target_name};
        options.source_appearance = appearance_of(source);
        options.target_appearance = appearance_of(target);
        options.up = render::find_camera(source.mesh(),
                                         {.direction = "front", .up = render::find_up_axis(source.mesh())})
                         .row(1)
                         .transpose();
        const ViewerScene scene = viewer_scene(source.mesh(), target.mesh(), shown, options);
        val fields = val::object();
        fields.set("description", scene.description);
        fields.set("arrays", array_of(reinterpret_cast<const unsigned char*>(scene.arrays.data()),
                                      scene.arrays.size()));
        return fields;
    });
}

}  // namespace

EMSCRIPTEN_BINDINGS(viewer) { emscripten::function("viewerScene", &scene_of); }

}  // namespace counterpart::javascript
