// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Meshes with attributes, and their files.
#include "arrays.hpp"
#include "bindings.hpp"
#include "call.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/io/gltf.hpp>
#include <counterpart/io/landmark_points.hpp>
#include <counterpart/io/mesh_file.hpp>
#include <counterpart/io/mesh_objects.hpp>
#include <counterpart/mesh/attributed_mesh.hpp>

#include <iterator>
#include <map>

#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/map.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

namespace counterpart::python {
namespace {

using namespace nb::literals;

template <class T>
using ReadOnly = NewMatrix<const T>;

// An array of what `content` holds, which it keeps alive: read-only, since the library trusts what it holds.
template <class Derived>
ReadOnly<typename Derived::Scalar> view_of(AttributedMesh& content, Eigen::PlainObjectBase<Derived>& matrix) {
    static_assert(Derived::IsRowMajor);
    return {matrix.data(),
            {static_cast<std::size_t>(matrix.rows()), static_cast<std::size_t>(matrix.cols())},
            nb::find(content)};
}

using AttributeArrays = std::tuple<ReadOnly<double>, ReadOnly<Index>>;

std::optional<AttributeArrays> view_of(AttributedMesh& content, CornerAttribute& attribute) {
    if (attribute.corners.rows() == 0) return std::nullopt;
    return AttributeArrays(view_of(content, attribute.values), view_of(content, attribute.corners));
}

std::vector<AttributeArrays> view_of(AttributedMesh& content, std::vector<CornerAttribute>& attributes) {
    std::vector<AttributeArrays> list;
    for (CornerAttribute& attribute : attributes)
        if (auto arrays = view_of(content, attribute)) list.push_back(*std::move(arrays));
    return list;
}

CornerAttribute attribute_of(const MatrixArray& values, const TriangleArray& corners) {
    return {map_of(values), map_of(corners)};
}

using JointArray = nb::ndarray<const Index, nb::ndim<2>, nb::c_contig, nb::device::cpu>;

// How many corners each polygon has, and the vertices there; nothing of a mesh of triangles.
std::optional<std::tuple<NewVector<Index>, NewVector<Index>>> polygons_of(const TriangleMesh& mesh) {
    const Polygons& polygons = mesh.polygons;
    if (polygons.empty()) return std::nullopt;
    std::vector<Index> sizes, corners(static_cast<std::size_t>(polygons.n_corners()));
    for (Index p = 0; p < polygons.count(); ++p) sizes.push_back(polygons.size(p));
    for (Eigen::Index i = 0; i < polygons.corners.size(); ++i)
        corners[static_cast<std::size_t>(polygons.corners.data()[i])] = mesh.triangles.data()[i];
    return std::tuple(array(std::move(sizes)), array(std::move(corners)));
}

SkinBinding skin_of(const JointArray& joints, const MatrixArray& weights) {
    using Joints = decltype(SkinBinding::joints);
    return {Eigen::Map<const Joints>(joints.data(), static_cast<Eigen::Index>(joints.shape(0)),
                                     static_cast<Eigen::Index>(joints.shape(1))),
            map_of(weights)};
}

nb::object document_state(const AttributedMesh& content) {
    if (!content.document) return nb::none();
    const std::string bytes = content.document->to_bytes();
    return nb::bytes(bytes.data(), bytes.size());
}

nb::bytes bytes_of(const std::string& text) { return nb::bytes(text.data(), text.size()); }

// Their names may be in any encoding.
nb::tuple objects_state(const MeshObjects& objects) {
    std::vector<nb::bytes> names;
    for (const std::string& name : objects.names) names.push_back(bytes_of(name));
    return nb::make_tuple(names, array(objects.of_triangle), array(objects.of_vertex));
}

// All that a mesh holds, in the order of `restore`.
nb::tuple state_of(AttributedMesh& self) {
    nb::list morphs;
    for (MorphTarget& morph : self.morphs)
        morphs.append(nb::make_tuple(morph.name, view_of(self, morph.displacements)));
    nb::list values;
    for (VertexValues& column : self.values)
        values.append(nb::make_tuple(column.name, view_of(self, column.values)));
    return nb::make_tuple(view_of(self, self.mesh.vertices), view_of(self, self.mesh.triangles),
                          array(self.mesh.polygons.first), view_of(self, self.mesh.polygons.corners),
                          view_of(self, self.normals), view_of(self, self.texture_coordinates),
                          view_of(self, self.colors), view_of(self, self.skin.joints),
                          view_of(self, self.skin.weights), morphs, array(self.parts), self.part_names,
                          document_state(self), values, array(self.mesh.left_out),
                          objects_state(self.objects));
}

using ObjectsState = std::tuple<std::vector<nb::bytes>, IndexArray, IndexArray>;
using AttributeState = std::tuple<MatrixArray, TriangleArray>;
using State = std::tuple<PointArray, TriangleArray, IndexArray, TriangleArray, std::optional<AttributeState>,
                         std::vector<AttributeState>, std::vector<AttributeState>, JointArray, MatrixArray,
                         std::vector<std::tuple<std::string, PointArray>>, IndexArray,
                         std::vector<std::string>, std::optional<nb::bytes>,
                         std::vector<std::tuple<std::string, MatrixArray>>, IndexArray, ObjectsState>;

AttributedMesh restore(const State& state) {
    const auto& [vertices, triangles, first, corners, normals, texture_coordinates, colors, joints, weights,
                 morphs, parts, part_names, document, values, left_out, objects] = state;
    AttributedMesh self;
    self.mesh = {
        map_of(vertices), map_of(triangles), {vector_of(first), map_of(corners)}, vector_of(left_out)};
    require_valid(self.mesh);
    const auto attribute = [](const AttributeState& pair) {
        return attribute_of(std::get<0>(pair), std::get<1>(pair));
    };
    if (normals) self.normals = attribute(*normals);
    for (const AttributeState& pair : texture_coordinates)
        self.texture_coordinates.push_back(attribute(pair));
    for (const AttributeState& pair : colors) self.colors.push_back(attribute(pair));
    self.skin = skin_of(joints, weights);
    for (const auto& [name, displacements] : morphs) self.morphs.push_back({name, map_of(displacements)});
    for (const auto& [name, column] : values) self.values.push_back({name, map_of(column)});
    self.parts = vector_of(parts);
    self.part_names = part_names;
    if (document) self.document = document_from_bytes({document->c_str(), document->size()});
    const auto& [object_names, of_triangle, of_vertex] = objects;
    for (const nb::bytes& name : object_names) self.objects.names.emplace_back(name.c_str(), name.size());
    self.objects.of_triangle = vector_of(of_triangle);
    self.objects.of_vertex = vector_of(of_vertex);
    return self;
}

LandmarkPoints points_of(const std::vector<std::string>& names, const PointArray& points) {
    LandmarkPoints result;
    for (std::size_t i = 0; i < names.size(); ++i)
        result.landmarks.push_back({names[i], {points(i, 0), points(i, 1), points(i, 2)}});
    return result;
}

std::optional<Anatomical> axes_from_name(const std::optional<std::string>& name) {
    if (!name) return std::nullopt;
    if (*name == "LPS") return Anatomical::lps;
    if (*name == "RAS") return Anatomical::ras;
    throw InvalidInput("axes must be LPS or RAS, not '" + *name + "'");
}

void bind_landmarks(nb::module_& module) {
    module.def(
        "read_landmark_points",
        [](const std::filesystem::path& file, const std::optional<std::string>& axes) {
            const LandmarkPoints found =
                run([&] { return read_landmark_points(file, axes_from_name(axes)); });
            std::vector<std::string> names;
            Points points(std::ssize(found.landmarks), 3);
            for (const Landmark& landmark : found.landmarks) {
                points.row(std::ssize(names)) = landmark.point;
                names.push_back(landmark.name);
            }
            return std::tuple(names, matrix_array(std::move(points)),
                              found.axes ? std::optional(to_string(*found.axes)) : std::nullopt);
        },
        "file"_a, "axes"_a.none());
    module.def(
        "write_landmark_points",
        [](const std::vector<std::string>& names, const PointArray& points,
           const std::optional<std::string>& axes, const std::filesystem::path& file) {
            LandmarkPoints written = points_of(names, points);
            written.axes = axes_from_name(axes);
            run([&] { write_landmark_points(written, file); });
        },
        "names"_a, "points"_a, "axes"_a.none(), "file"_a);
    module.def(
        "landmark_pairs",
        [](const Mesh& source, const Mesh& target, const std::vector<std::string>& source_names,
           const PointArray& source_points, const std::vector<std::string>& target_names,
           const PointArray& target_points) {
            const auto pairs = landmark_pairs(points_of(source_names, source_points), source,
                                              points_of(target_names, target_points), target);
            Eigen::Matrix<Index, Eigen::Dynamic, 2, Eigen::RowMajor> rows(std::ssize(pairs), 2);
            for (std::size_t i = 0; i < pairs.size(); ++i)
                rows.row(static_cast<Eigen::Index>(i)) << pairs[i].first, pairs[i].second;
            return matrix_array(std::move(rows));
        },
        "source"_a, "target"_a, "source_names"_a, "source_points"_a, "target_names"_a, "target_points"_a);
}

}  // namespace

void bind_content(nb::module_& module) {
    bind_landmarks(module);
    nb::class_<AttributedMesh>(module, "Content")
        .def(
            "__init__",
            [](AttributedMesh* self, const PointArray& vertices, const TriangleArray& triangles) {
                TriangleMesh mesh{map_of(vertices), map_of(triangles)};
                require_valid(mesh);
                new (self) AttributedMesh();
                self->mesh = std::move(mesh);
            },
            "vertices"_a.noconvert(), "triangles"_a.noconvert())
        .def_static(
            "of_polygons",
            [](const PointArray& vertices, const IndexArray& sizes, const IndexArray& corners) {
                AttributedMesh content;
                const Points copy = map_of(vertices);
                content.mesh = cut_into_triangles(copy, vector_of(sizes), vector_of(corners));
                require_valid(content.mesh);
                return content;
            },
            "vertices"_a.noconvert(), "sizes"_a.noconvert(), "corners"_a.noconvert())
        .def("__getstate__", &state_of)
        .def("__setstate__",
             [](AttributedMesh& self, const State& state) { new (&self) AttributedMesh(restore(state)); })
        .def_prop_ro(
            "polygons", [](const AttributedMesh& self) { return polygons_of(self.mesh); },
            nb::rv_policy::move)
        .def_prop_ro("vertices", [](AttributedMesh& self) { return view_of(self, self.mesh.vertices); })
        .def_prop_ro("triangles", [](AttributedMesh& self) { return view_of(self, self.mesh.triangles); })
        .def_prop_ro("normals", [](AttributedMesh& self) { return view_of(self, self.normals); })
        .def_prop_ro("texture_coordinates",
                     [](AttributedMesh& self) { return view_of(self, self.texture_coordinates); })
        .def_prop_ro("colors", [](AttributedMesh& self) { return view_of(self, self.colors); })
        .def_prop_ro(
            "skin",
            [](AttributedMesh& self) -> std::optional<std::tuple<ReadOnly<Index>, ReadOnly<double>>> {
                if (self.skin.joints.rows() == 0) return std::nullopt;
                return std::tuple(view_of(self, self.skin.joints), view_of(self, self.skin.weights));
            })
        .def_prop_ro("morphs",
                     [](AttributedMesh& self) {
                         std::map<std::string, ReadOnly<double>> morphs;
                         for (MorphTarget& morph : self.morphs)
                             morphs.insert_or_assign(morph.name, view_of(self, morph.displacements));
                         return morphs;
                     })
        .def_prop_ro("values",
                     [](AttributedMesh& self) {
                         std::map<std::string, ReadOnly<double>> values;
                         for (VertexValues& column : self.values)
                             values.insert_or_assign(column.name, view_of(self, column.values));
                         return values;
                     })
        .def_prop_ro(
            "left_out", [](const AttributedMesh& self) { return array(self.mesh.left_out); },
            nb::rv_policy::move)
        .def("add_values",
             [](AttributedMesh& self, const std::string& name, const MatrixArray& values) {
                 self.values.push_back({name, map_of(values)});
             })
        .def_prop_ro("parts", [](AttributedMesh& self) { return array(self.parts); })
        .def_prop_ro("part_names", [](AttributedMesh& self) { return self.part_names; })
        .def("set_normals",
             [](AttributedMesh& self, const MatrixArray& values, const TriangleArray& corners) {
                 self.normals = attribute_of(values, corners);
             })
        .def("add_texture_coordinates",
             [](AttributedMesh& self, const MatrixArray& values, const TriangleArray& corners) {
                 self.texture_coordinates.push_back(attribute_of(values, corners));
             })
        .def("add_colors",
             [](AttributedMesh& self, const MatrixArray& values, const TriangleArray& corners) {
                 self.colors.push_back(attribute_of(values, corners));
             })
        .def("set_skin", [](AttributedMesh& self, const JointArray& joints,
                            const MatrixArray& weights) { self.skin = skin_of(joints, weights); })
        .def("add_morph", [](AttributedMesh& self, const std::string& name, const PointArray& displacements) {
            self.morphs.push_back({name, map_of(displacements)});
        });

    module.def(
        "read",
        [](const std::filesystem::path& file, bool allow_external, bool strict,
           const std::optional<std::string>& object) {
            AttributedMeshFile read = run([&] {
                return read_attributed_mesh(
                    file, {.allow_external = allow_external, .strict = strict, .object = object});
            });
            return std::tuple(std::move(read.content), std::move(read.notices));
        },
        "file"_a, "allow_external"_a, "strict"_a, "object"_a.none());
    module.def(
        "objects",
        [](const std::filesystem::path& file, bool allow_external) {
            std::vector<std::tuple<nb::bytes, Index, Index>> list;
            for (const MeshObject& object :
                 run([&] { return mesh_objects(file, {.allow_external = allow_external}); }))
                list.emplace_back(bytes_of(object.name), object.n_vertices, object.n_triangles);
            return list;
        },
        "file"_a, "allow_external"_a);
    module.def(
        "write",
        [](const AttributedMesh& content, const std::filesystem::path& file) {
            run([&] { write_attributed_mesh(content, file); });
        },
        "content"_a, "file"_a);
    module.def(
        "write_triangles",
        [](const Mesh& mesh, const std::filesystem::path& file) { run([&] { write_mesh(mesh, file); }); },
        "mesh"_a, "file"_a);
}

}  // namespace counterpart::python
