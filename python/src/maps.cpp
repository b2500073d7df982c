// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "arrays.hpp"
#include "bindings.hpp"
#include "call.hpp"
#include "dictionary.hpp"

#include <counterpart/evaluation/evaluate.hpp>
#include <counterpart/evaluation/map_quality.hpp>
#include <counterpart/io/map_file.hpp>
#include <counterpart/map/carry_points.hpp>
#include <counterpart/map/complete.hpp>
#include <counterpart/map/invert.hpp>
#include <counterpart/map/project.hpp>

#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/variant.h>

namespace counterpart::python {
namespace {

using namespace nb::literals;

nb::object dictionary(const std::optional<CorrespondenceCost>& cost) {
    if (!cost) return nb::none();
    return dictionary_of("raw", cost->raw, "normalized", cost->normalized);
}

nb::dict dictionary(const MapQuality& quality) {
    return dictionary_of("n_matched", quality.n_matched, "n_distinct", quality.n_distinct, "coverage",
                         quality.coverage, "preserved_edges", quality.preserved_edges, "collapsed_edges",
                         quality.collapsed_edges);
}

nb::dict dictionary(EvaluationReport report) {
    return dictionary_of(
        "n_pairs", report.n_pairs, "n_unmatched", report.n_unmatched, "n_other_component",
        report.n_other_component, "n_exact", report.n_exact, "target_area", report.target_area, "error",
        array(std::move(report.error)), "mean_error", report.mean_error, "median_error", report.median_error,
        "percentile_95_error", report.percentile_95_error, "max_error", report.max_error, "cost",
        dictionary(std::optional<CorrespondenceCost>(report.cost)), "base_vertex_cost",
        dictionary(report.base_vertex_cost), "thresholds", array(std::move(report.thresholds)),
        "fraction_within", array(std::move(report.fraction_within)));
}

void bind_map_files(nb::module_& module) {
    module.def(
        "read_map",
        [](const std::filesystem::path& file, bool one_based)
            -> std::variant<NewVector<Index>, std::tuple<NewVector<Index>, NewMatrix<double>>> {
            const auto map = run([&]() -> std::variant<VertexMap, SurfaceMap> {
                if (one_based) return read_vertex_map(file, IndexBase::one);
                return read_map(file);
            });
            if (const auto* vertices = std::get_if<VertexMap>(&map)) return array(*vertices);
            return arrays(std::get<SurfaceMap>(map));
        },
        "file"_a, "one_based"_a);
    module.def(
        "write_map",
        [](const IndexArray& map, const std::filesystem::path& file, bool one_based) {
            run([&] {
                write_vertex_map(vertex_map_of(map, std::numeric_limits<Index>::max()), file,
                                 one_based ? IndexBase::one : IndexBase::zero);
            });
        },
        "map"_a, "file"_a, "one_based"_a);
    module.def(
        "write_surface_map",
        [](const IndexArray& triangle, const PointArray& weights, const std::filesystem::path& file) {
            const SurfaceMap map = surface_map_of(triangle, weights, std::numeric_limits<Index>::max());
            run([&] { write_surface_map(map, file); });
        },
        "triangle"_a, "weights"_a, "file"_a);
}

}  // namespace

void bind_maps(nb::module_& module) {
    bind_map_files(module);
    module.def(
        "evaluate",
        [](const Mesh& source, const Mesh& target, const IndexArray& target_from_source,
           const PairArray& truth, bool shortcuts, Index n_base_vertices, const VectorArray& thresholds,
           int n_threads, const nb::object& progress) {
            return dictionary(run(progress, [&](Progress report) {
                return evaluate(vertex_map_of(target_from_source, target.n_vertices()), {pairs_of(truth)},
                                source, target,
                                {.shortcuts = shortcuts,
                                 .n_base_vertices = n_base_vertices,
                                 .thresholds = {thresholds.data(), thresholds.data() + thresholds.size()},
                                 .n_threads = n_threads,
                                 .progress = std::move(report)});
            }));
        },
        "source"_a, "target"_a, "target_from_source"_a, "truth"_a, "shortcuts"_a, "n_base_vertices"_a,
        "thresholds"_a, "n_threads"_a, "progress"_a.none());
    module.def(
        "map_quality",
        [](const Mesh& source, const Mesh& target, const IndexArray& target_from_source) {
            return dictionary(run([&] {
                return map_quality(vertex_map_of(target_from_source, target.n_vertices()), source, target);
            }));
        },
        "source"_a, "target"_a, "target_from_source"_a);
    module.def(
        "project_map",
        [](const Mesh& source, const Mesh& target, const IndexArray& target_from_source, int rings,
           int passes, int extend, double exact_share, int n_threads, const nb::object& progress) {
            return arrays(run(progress, [&](Progress report) {
                return project_map(source, target, vertex_map_of(target_from_source, target.n_vertices()),
                                   {.rings = rings,
                                    .passes = passes,
                                    .extend = extend,
                                    .exact_share = exact_share,
                                    .n_threads = n_threads,
                                    .progress = std::move(report)});
            }));
        },
        "source"_a, "target"_a, "target_from_source"_a, "rings"_a, "passes"_a, "extend"_a, "exact_share"_a,
        "n_threads"_a, "progress"_a.none());
    module.def(
        "invert_surface_map",
        [](const Mesh& source, const Mesh& target, const IndexArray& triangle, const PointArray& weights,
           int n_threads, const nb::object& progress) {
            return arrays(run(progress, [&](Progress report) {
                return with_inverse(surface_map_of(triangle, weights, target.n_triangles()), source, target,
                                    {.n_threads = n_threads, .progress = std::move(report)})
                    .source_from_target;
            }));
        },
        "source"_a, "target"_a, "triangle"_a, "weights"_a, "n_threads"_a, "progress"_a.none());
    module.def(
        "complete_map",
        [](const Mesh& source, const Mesh& target, const IndexArray& triangle, const PointArray& weights,
           std::optional<int> max_edges) {
            const CompletedMap completed = run([&] {
                return complete_map(surface_map_of(triangle, weights, target.n_triangles()), source, target,
                                    {.max_edges = max_edges});
            });
            return std::tuple(arrays(completed.target_from_source), counts_of(completed.coverage));
        },
        "source"_a, "target"_a, "triangle"_a, "weights"_a, "max_edges"_a.none());
    module.def(
        "surface_map",
        [](const Mesh& target, const IndexArray& target_from_source) {
            return arrays(run([&] {
                return surface_map_of(vertex_map_of(target_from_source, target.n_vertices()), target.view());
            }));
        },
        "target"_a, "target_from_source"_a);
    module.def(
        "nearest_corners",
        [](const Mesh& target, const IndexArray& triangle, const PointArray& weights) {
            return array(run([&] {
                return nearest_corners(surface_map_of(triangle, weights, target.n_triangles()), target);
            }));
        },
        "target"_a, "triangle"_a, "weights"_a);
    module.def(
        "pull",
        [](const Mesh& target, const IndexArray& triangle, const PointArray& weights,
           const MatrixArray& values) {
            return matrix_array(run([&, copy = Matrix(map_of(values))] {
                return transfer_values(surface_map_of(triangle, weights, target.n_triangles()), target, copy);
            }));
        },
        "target"_a, "triangle"_a, "weights"_a, "values"_a);
    module.def(
        "carry_points",
        [](const MatrixArray& points, const Mesh& source, const Mesh& target, const IndexArray& triangle,
           const PointArray& weights) {
            return matrix_array(run([&, copy = Points(map_of(points))] {
                return carry_points(copy, source, target,
                                    surface_map_of(triangle, weights, target.n_triangles()));
            }));
        },
        "points"_a, "source"_a, "target"_a, "triangle"_a, "weights"_a);
    module.def(
        "compose_maps",
        [](const IndexArray& b_from_a, const IndexArray& c_from_b) {
            constexpr Index most = std::numeric_limits<Index>::max();
            return array(compose_maps(vertex_map_of(b_from_a, static_cast<Index>(c_from_b.size())),
                                      vertex_map_of(c_from_b, most)));
        },
        "b_from_a"_a, "c_from_b"_a);
}

}  // namespace counterpart::python
