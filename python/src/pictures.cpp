// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "arrays.hpp"
#include "bindings.hpp"
#include "call.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/render/charts.hpp>
#include <counterpart/render/figures.hpp>
#include <counterpart/viewer/viewer_page.hpp>

#include <optional>
#include <span>

#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

namespace counterpart::python {
namespace {

using namespace nb::literals;
using namespace render;

struct Picture {
    int width = 1600, height = 1000;
    std::string view = "auto", up = "auto";
    int n_threads = 0;

    RenderOptions options(Progress progress) const {
        RenderOptions result{.width = width, .height = height};
        result.n_threads = n_threads;
        result.progress = std::move(progress);
        return result;
    }
    PlacedMesh placed(const Mesh& mesh) const { return {mesh, {mesh, find_camera(mesh, {view, up})}}; }
    std::vector<PlacedMesh> placed(const Mesh& source, const Mesh& target, const VertexMap& map) const {
        const Camera camera = find_camera(source, {view, up});
        std::vector<Placement> places = {Placement(source, camera),
                                         Placement(target, matching_camera(camera, source, target, map))};
        arrange_in_row(places);
        return {{source, places[0]}, {target, places[1]}};
    }
};

using ImageArray = nb::ndarray<const std::uint8_t, nb::shape<-1, -1, 3>, nb::c_contig, nb::device::cpu>;

nb::ndarray<nb::numpy, std::uint8_t, nb::ndim<3>> pixels(Image image) {
    const std::size_t height = static_cast<std::size_t>(image.height),
                      width = static_cast<std::size_t>(image.width);
    auto [kept, owner] = keep(std::move(image.rgb));
    return {kept->data(), {height, width, 3}, owner};
}

Image image_of(const ImageArray& array) {
    Image image(static_cast<int>(array.shape(1)), static_cast<int>(array.shape(0)), {0, 0, 0});
    image.rgb.assign(array.data(), array.data() + array.size());
    return image;
}

Scene map_scene(const std::vector<PlacedMesh>& placed, const VertexMap& map, const std::string& show,
                const LineOptions& lines) {
    if (show == "colors") return texture_scene(placed[0], placed[1], map, Texture::colors);
    if (show == "checker") return texture_scene(placed[0], placed[1], map, Texture::checker);
    if (show == "lines") return line_scene(placed[0], placed[1], map, lines);
    throw InvalidInput("a map cannot be shown as '" + show + "': colors, checker or lines");
}

nb::bytes bytes_of(const std::string& text) { return nb::bytes(text.data(), text.size()); }

}  // namespace

void bind_pictures(nb::module_& module) {
    nb::class_<Picture>(module, "PictureOptions")
        .def(nb::init<>())
        .def_rw("width", &Picture::width)
        .def_rw("height", &Picture::height)
        .def_rw("view", &Picture::view)
        .def_rw("up", &Picture::up)
        .def_rw("n_threads", &Picture::n_threads);
    module.def(
        "render_mesh",
        [](const Mesh& mesh, const Picture& picture, const nb::object& progress) {
            return pixels(run(progress, [&](Progress report) {
                const PlacedMesh placed = picture.placed(mesh);
                Scene scene;
                scene.surfaces.push_back(plain_surface(mesh, placed.placement));
                return render::render(scene, picture.options(std::move(report)));
            }));
        },
        "mesh"_a, "picture"_a, "progress"_a.none());
    module.def(
        "render_colors",
        [](const Mesh& mesh, const PointArray& colors, const Picture& picture, const nb::object& progress) {
            return pixels(run(progress, [&, copy = Points(map_of(colors))](Progress report) {
                const PlacedMesh placed = picture.placed(mesh);
                Scene scene;
                scene.surfaces.push_back({placed.placement(mesh), copy, {}});
                return render::render(scene, picture.options(std::move(report)));
            }));
        },
        "mesh"_a, "colors"_a, "picture"_a, "progress"_a.none());
    module.def(
        "render_values",
        [](const Mesh& mesh, const VectorArray& values, double max, const std::string& colormap,
           const Picture& picture, const nb::object& progress) {
            return pixels(run(progress, [&, copy = Vector(map_of(values))](Progress report) {
                Scene scene;
                scene.surfaces.push_back(
                    value_surface(picture.placed(mesh), copy, max, colormap_from_name(colormap)));
                return render::render(scene, picture.options(std::move(report)));
            }));
        },
        "mesh"_a, "values"_a, "max"_a, "colormap"_a, "picture"_a, "progress"_a.none());
    module.def(
        "render_map",
        [](const Mesh& source, const Mesh& target, const IndexArray& target_from_source,
           const std::string& show, Index lines, std::uint64_t seed, const Picture& picture,
           const nb::object& progress) {
            return pixels(run(progress, [&](Progress report) {
                const VertexMap map = vertex_map_of(target_from_source, target.n_vertices());
                return render::render(
                    map_scene(picture.placed(source, target, map), map, show, {.count = lines, .seed = seed}),
                    picture.options(std::move(report)));
            }));
        },
        "source"_a, "target"_a, "target_from_source"_a, "show"_a, "lines"_a, "seed"_a, "picture"_a,
        "progress"_a.none());
    module.def("encode_png", [](const ImageArray& image) {
        return bytes_of(run([&] { return encode_png(image_of(image)); }));
    });
    module.def("decode_png", [](const nb::bytes& bytes) {
        return pixels(decode_png({bytes.c_str(), bytes.size()}));
    });
    module.def(
        "viewer_page",
        [](const Mesh& source, const Mesh& target, const std::vector<std::string>& names,
           const std::vector<IndexArray>& maps, const std::vector<VectorArray>& errors,
           const std::vector<VectorArray>& confidences, const std::vector<std::string>& verdicts,
           const std::vector<std::vector<std::string>>& warnings, const IndexArray& truth,
           const std::string& source_name, const std::string& target_name, const std::string& up) {
            std::vector<ViewerMap> shown;
            for (std::size_t i = 0; i < maps.size(); ++i) {
                ViewerMap& map =
                    shown.emplace_back(ViewerMap{names[i], vertex_map_of(maps[i], target.n_vertices())});
                if (i < errors.size())
                    map.error.assign(errors[i].data(), errors[i].data() + errors[i].size());
                map.confidence.assign(confidences[i].data(), confidences[i].data() + confidences[i].size());
                map.verdict = verdicts[i];
                map.warnings = warnings[i];
            }
            return run([&] {
                return viewer_page(
                    source, target, shown,
                    {.source_name = source_name,
                     .target_name = target_name,
                     .truth = vector_of(truth),
                     .up = find_camera(source, {.direction = "front", .up = up}).row(1).transpose()});
            });
        },
        "source"_a, "target"_a, "names"_a, "maps"_a, "errors"_a, "confidences"_a, "verdicts"_a, "warnings"_a,
        "truth"_a, "source_name"_a, "target_name"_a, "up"_a);
}

}  // namespace counterpart::python
