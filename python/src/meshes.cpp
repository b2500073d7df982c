// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "arrays.hpp"
#include "bindings.hpp"
#include "call.hpp"
#include "dictionary.hpp"

#include <counterpart/geodesic/distances.hpp>
#include <counterpart/mesh/analyze.hpp>
#include <counterpart/mesh/attributed_mesh.hpp>
#include <counterpart/mesh/measure.hpp>
#include <counterpart/mesh/shapes.hpp>
#include <counterpart/mesh/variants.hpp>

#include <numeric>

namespace counterpart::python {
nb::dict counts_of(const MeshReport& report) {
    nb::list components;
    for (const ComponentReport& component : report.components)
        components.append(dictionary_of(
            "n_vertices", component.n_vertices, "n_edges", component.n_edges, "n_triangles",
            component.n_triangles, "n_boundary_loops", component.n_boundary_loops, "is_manifold",
            component.is_manifold, "is_orientable", component.is_orientable, "genus", component.genus()));
    return dictionary_of("n_vertices", report.n_vertices, "n_edges", report.n_edges, "n_triangles",
                         report.n_triangles, "n_isolated_vertices", report.n_isolated_vertices,
                         "n_duplicate_vertices", report.n_duplicate_vertices, "n_degenerate_triangles",
                         report.n_degenerate_triangles, "n_zero_area_triangles", report.n_zero_area_triangles,
                         "n_duplicate_triangles", report.n_duplicate_triangles, "n_boundary_edges",
                         report.n_boundary_edges, "n_nonmanifold_edges", report.n_nonmanifold_edges,
                         "n_nonmanifold_vertices", report.n_nonmanifold_vertices, "n_boundary_loops",
                         report.n_boundary_loops, "is_consistently_oriented", report.is_consistently_oriented,
                         "is_closed", report.is_closed(), "is_manifold", report.is_manifold(), "area",
                         report.area, "mean_edge_length", report.mean_edge_length, "components", components);
}

namespace {

using namespace nb::literals;

AttributedMesh content_of(TriangleMesh mesh) {
    AttributedMesh content;
    content.mesh = std::move(mesh);
    return content;
}

Matrix distances(const Mesh& mesh, std::vector<Index> sources, bool shortcuts,
                 const DistanceOptions& options) {
    return distance_rows(DistanceGraph(mesh, {.shortcuts = shortcuts}), sources, options);
}

}  // namespace

void bind_meshes(nb::module_& module) {
    nb::class_<Mesh>(module, "Mesh")
        .def(nb::init<PointArray, TriangleArray>(), "vertices"_a.noconvert(), "triangles"_a.noconvert())
        .def(
            "__init__", [](Mesh* self, const AttributedMesh& content) { new (self) Mesh(content.mesh); },
            "content"_a, nb::keep_alive<1, 2>())
        .def_prop_ro("n_vertices", &Mesh::n_vertices)
        .def_prop_ro("n_triangles", &Mesh::n_triangles);

    module.def("make_icosphere", [](int subdivisions) { return arrays(make_icosphere(subdivisions)); });
    module.def("make_torus", [](int rings, int segments) { return arrays(make_torus(rings, segments)); });
    module.def("make_grid", [](int columns, int rows) { return arrays(make_grid(columns, rows)); });
    module.def("make_body", [](int subdivisions, bool symmetric) {
        return arrays(make_body({.subdivisions = subdivisions, .symmetric = symmetric}));
    });
    module.def("subdivide", [](const Mesh& mesh) { return arrays(subdivide(mesh)); });
    module.def("deform", [](const Mesh& mesh, double bend, double twist, double warp, std::uint64_t seed) {
        return content_of(deform(mesh, {.bend = bend, .twist = twist, .warp = warp, .seed = seed}));
    });
    module.def("shuffle", [](const Mesh& mesh, std::uint64_t seed) {
        ShuffleResult result = shuffle(mesh, seed);
        return std::tuple(content_of(std::move(result.mesh)),
                          array(std::move(result.shuffled_from_original)));
    });
    module.def("move_at_random",
               [](const Mesh& mesh, std::uint64_t seed) { return content_of(move_at_random(mesh, seed)); });

    module.def("inspect", [](const Mesh& mesh) { return counts_of(run([&] { return analyze(mesh); })); });
    module.def("vertex_areas", [](const Mesh& mesh) { return array(vertex_areas(mesh)); });
    module.def("vertex_normals", [](const Mesh& mesh) { return matrix_array(vertex_normals(mesh)); });
    module.def(
        "distances",
        [](const Mesh& mesh, const IndexArray& sources, bool shortcuts, int n_threads,
           const nb::object& progress) {
            return matrix_array(run(progress, [&](Progress report) {
                return distances(mesh, vector_of(sources), shortcuts, {n_threads, std::move(report)});
            }));
        },
        "mesh"_a, "sources"_a, "shortcuts"_a, "n_threads"_a, "progress"_a.none());
}

}  // namespace counterpart::python
