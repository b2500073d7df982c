// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "arrays.hpp"
#include "bindings.hpp"
#include "call.hpp"
#include "dictionary.hpp"

#include <counterpart/align/fit_surface.hpp>
#include <counterpart/align/icp.hpp>
#include <counterpart/base/errors.hpp>
#include <counterpart/match/exact.hpp>
#include <counterpart/transfer/morph.hpp>
#include <counterpart/transfer/reorder.hpp>
#include <counterpart/transfer/transfer.hpp>

#include <cmath>

namespace counterpart::python {
namespace {

using namespace nb::literals;

TransformModel model_from_name(const std::string& name) {
    if (name == "rigid") return TransformModel::rigid;
    if (name == "similarity") return TransformModel::similarity;
    if (name == "affine") return TransformModel::affine;
    throw InvalidInput("there is no model '" + name + "': rigid, similarity or affine");
}

nb::dict dictionary(const Affine& transform, Points moved, double rms, int iterations, bool converged) {
    Matrix matrix = Matrix::Identity(4, 4);
    matrix.topLeftCorner<3, 3>() = transform.linear;
    matrix.topRightCorner<3, 1>() = transform.translation;
    return dictionary_of("matrix", matrix_array(std::move(matrix)), "vertices",
                         matrix_array(std::move(moved)), "rms_distance", rms, "n_iterations", iterations,
                         "converged", converged);
}

nb::dict align_pairs(const PointArray& source, const PointArray& target, const std::string& model,
                     const PointArray& vertices) {
    const Points from = map_of(source), to = map_of(target);
    const auto fit = run([&] { return fit_transform(from, to, model_from_name(model)); });
    const double rms = std::sqrt((fit(from) - to).rowwise().squaredNorm().mean());
    return dictionary(fit, fit(map_of(vertices)), rms, 0, true);
}

nb::dict align_icp(const Mesh& source, const Mesh& target, const MatrixArray& start,
                   const IndexArray& triangle, const PointArray& weights, const std::string& model,
                   int max_iterations, double trim, double known_weight, int n_threads,
                   const nb::object& progress) {
    Affine from;
    const auto matrix = map_of(start);
    from.linear = matrix.topLeftCorner<3, 3>();
    from.translation = matrix.topRightCorner<3, 1>();
    SurfaceMap known;
    if (triangle.size() > 0) known = surface_map_of(triangle, weights, target.n_triangles());
    const IcpResult result = run(progress, [&](Progress report) {
        IcpOptions options;
        options.model = model_from_name(model);
        options.max_iterations = max_iterations;
        options.trim = trim;
        options.known_weight = known_weight;
        options.n_threads = n_threads;
        options.progress = std::move(report);
        return icp(source, target, from, known, options);
    });
    return dictionary(result.target_from_source, result.target_from_source(source.view().vertices),
                      result.rms_distance, result.iterations, result.converged);
}

nb::dict fit(const Mesh& model, const Mesh& scan, const IndexArray& triangle, const PointArray& weights,
             const PairArray& landmarks, double stiffness, double reach, int n_threads,
             const nb::object& progress) {
    FitResult result = run(progress, [&](Progress report) {
        return fit_surface(model, scan, surface_map_of(triangle, weights, scan.n_triangles()),
                           {.stiffness = stiffness,
                            .reach = reach,
                            .landmarks = pairs_of(landmarks),
                            .n_threads = n_threads,
                            .progress = std::move(report)});
    });
    return dictionary_of("vertices", matrix_array(std::move(result.vertices)), "distance",
                         array(std::move(result.distance)), "scan_distance",
                         array(std::move(result.scan_distance)), "folded_edges", result.folded_edges,
                         "own_folded_edges", result.own_folded_edges, "least_area_ratio",
                         result.least_area_ratio, "n_free", result.n_free);
}

nb::dict dictionary(TransferResult result) {
    nb::list attributes;
    for (const TransferredAttribute& attribute : result.attributes)
        attributes.append(
            dictionary_of("name", attribute.name, "transferred", attribute.coverage.transferred, "filled",
                          attribute.coverage.filled, "guessed", attribute.coverage.guessed, "seam_triangles",
                          attribute.seam_triangles, "moved_vertices", attribute.moved_vertices,
                          "without_triangles", attribute.without_triangles, "limited_vertices",
                          attribute.limited_vertices, "unbound_vertices", attribute.unbound_vertices));
    return dictionary_of("content", std::move(result.content), "n_matched", result.n_matched, "attributes",
                         attributes, "has_materials", result.has_materials, "messages",
                         list_of(result.messages));
}

void bind_morph(nb::module_& module) {
    module.def(
        "last_pose",
        [](const Mesh& first, const Mesh& last, const IndexArray& triangle, const PointArray& weights) {
            LastPose pose = run([&] {
                return last_pose(first, last, surface_map_of(triangle, weights, last.n_triangles()));
            });
            return std::tuple(matrix_array(std::move(pose.vertices)), pose.n_followers);
        },
        "first"_a, "last"_a, "triangle"_a, "weights"_a);
    module.def(
        "morph_frames",
        [](const Mesh& first, const PointArray& last, int count, int iterations, int n_threads,
           const nb::object& progress) {
            std::vector<Points> frames = run(progress, [&](const Progress& report) {
                return morph_frames(first, map_of(last), count,
                                    {.iterations = iterations, .n_threads = n_threads}, report);
            });
            nb::list list;
            for (Points& frame : frames) list.append(matrix_array(std::move(frame)));
            return list;
        },
        "first"_a, "last"_a, "count"_a, "iterations"_a, "n_threads"_a, "progress"_a.none());
}

}  // namespace

void bind_transfer(nb::module_& module) {
    module.def("align_pairs", align_pairs, "source"_a, "target"_a, "model"_a, "vertices"_a);
    module.def("align_icp", align_icp, "source"_a, "target"_a, "start"_a, "triangle"_a, "weights"_a,
               "model"_a, "max_iterations"_a, "trim"_a, "known_weight"_a, "n_threads"_a, "progress"_a.none());
    module.def("fit", fit, "model"_a, "scan"_a, "triangle"_a, "weights"_a, "landmarks"_a, "stiffness"_a,
               "reach"_a, "n_threads"_a, "progress"_a.none());
    module.def(
        "reorder",
        [](const AttributedMesh& source, const AttributedMesh& target, const ExactOptions& options) {
            struct Reordered {
                AttributedMesh content;
                VertexMap map;
                std::vector<Message> messages;
            };
            Reordered result = run([&]() -> Reordered {
                const ExactResult match = match_exact(source.mesh, target.mesh, options);
                if (!match.identical)
                    throw InvalidInput(
                        "the meshes have different connectivity (" + match.difference +
                        "), so the order cannot be restored; find_differences says where they differ");
                Reordered made{
                    reorder(source, target, match.target_from_source, match.target_corner_from_source),
                    match.target_from_source, match.messages};
                if (match.mirrored) {
                    made.content = turned_inside_out(std::move(made.content));
                    made.messages.push_back(
                        {MessageCode::turned_inside_out, Severity::notice,
                         "its faces are wound the other way than the source's, so that the "
                         "outside stays out"});
                }
                return made;
            });
            return std::tuple(std::move(result.content), array(result.map), list_of(result.messages));
        },
        "source"_a, "target"_a, "options"_a);
    nb::class_<TransferOptions>(module, "TransferOptions")
        .def(nb::init<>())
        .def_rw("colors", &TransferOptions::colors)
        .def_rw("texture_coordinates", &TransferOptions::texture_coordinates)
        .def_rw("normals", &TransferOptions::normals)
        .def_rw("flat_normals", &TransferOptions::flat_normals)
        .def_rw("skin", &TransferOptions::skin)
        .def_rw("morphs", &TransferOptions::morphs)
        .def_rw("materials", &TransferOptions::materials)
        .def_rw("max_influences", &TransferOptions::max_influences)
        .def_rw("n_threads", &TransferOptions::n_threads);
    module.def(
        "transfer",
        [](const AttributedMesh& source, const AttributedMesh& target, const IndexArray& triangle,
           const PointArray& weights, bool inverse, TransferOptions options, const nb::object& progress) {
            return dictionary(run(progress, [&](Progress report) {
                options.progress = std::move(report);
                if (inverse)
                    return transfer_through_inverse(
                        source, target, surface_map_of(triangle, weights, source.mesh.n_triangles()),
                        options);
                return transfer(source, target, surface_map_of(triangle, weights, target.mesh.n_triangles()),
                                options);
            }));
        },
        "source"_a, "target"_a, "triangle"_a, "weights"_a, "inverse"_a, "options"_a, "progress"_a.none());
    bind_morph(module);
}

}  // namespace counterpart::python
