// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "arrays.hpp"
#include "bindings.hpp"
#include "call.hpp"
#include "dictionary.hpp"

#include <counterpart/io/shape_file.hpp>
#include <counterpart/match/assignment.hpp>
#include <counterpart/match/choose_method.hpp>
#include <counterpart/match/compare.hpp>
#include <counterpart/match/match.hpp>
#include <counterpart/match/nearest.hpp>
#include <counterpart/match/refine.hpp>
#include <counterpart/match/verdict.hpp>

#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

namespace counterpart::python {
namespace {

using namespace nb::literals;

nb::dict dictionary(const Count& count) {
    return dictionary_of("log10", count.log10, "number", count.number, "is_lower_bound", count.is_lower_bound,
                         "text", to_string(count));
}

nb::dict dictionary(ExactResult result) {
    nb::list interchangeable;
    for (const EqualComponents& equal : result.interchangeable)
        interchangeable.append(dictionary_of("n_triangles", equal.n_triangles, "source", array(equal.source),
                                             "target", array(equal.target)));
    return dictionary_of("identical", result.identical, "difference", result.difference, "target_from_source",
                         array(result.target_from_source), "target_corner_from_source",
                         matrix_array(std::move(result.target_corner_from_source)), "n_components",
                         result.n_components, "interchangeable", interchangeable, "by_place",
                         array(std::move(result.by_place)), "automorphisms", dictionary(result.automorphisms),
                         "mirror_automorphisms", dictionary(result.mirror_automorphisms),
                         "reversed_triangles", result.reversed_triangles, "winding_reversed",
                         result.winding_reversed, "mirrored", result.mirrored, "alternatives",
                         arrays(std::move(result.alternatives)), "messages", list_of(result.messages));
}

nb::dict dictionary(MeshDifferences result) {
    nb::list edits;
    for (Edit& edit : result.edits)
        edits.append(dictionary_of("sentence", edit.sentence, "source_triangles",
                                   array(std::move(edit.source_triangles)), "target_triangles",
                                   array(std::move(edit.target_triangles)), "source_vertices",
                                   array(std::move(edit.source_vertices)), "target_vertices",
                                   array(std::move(edit.target_vertices))));
    return dictionary_of("target_from_source", array(result.target_from_source), "source_share",
                         result.source_share, "target_share", result.target_share, "uncertain",
                         array(std::move(result.uncertain)), "source_vertices",
                         array(std::move(result.source_vertices)), "target_vertices",
                         array(std::move(result.target_vertices)), "source_triangles",
                         array(std::move(result.source_triangles)), "target_triangles",
                         array(std::move(result.target_triangles)), "edits", edits, "n_matched_triangles",
                         result.n_matched_triangles, "largest_region", result.largest_region,
                         "winding_reversed", result.winding_reversed, "is_ambiguous", result.is_ambiguous,
                         "summary", result.summary, "messages", list_of(result.messages));
}

nb::dict dictionary(FrontiersResult result) {
    nb::list components;
    for (const ComponentMatch& component : result.components)
        components.append(dictionary_of("n_vertices", component.n_vertices, "n_frontiers",
                                        component.n_frontiers, "source", component.source, "target",
                                        component.target, "n_alike", component.n_alike, "n_interchangeable",
                                        component.n_interchangeable));
    return dictionary_of("target_from_source", array(result.target_from_source), "confidence",
                         array(std::move(result.confidence)), "components", components,
                         "n_decided_by_position", result.n_decided_by_position, "seconds",
                         seconds_of(result.stages));
}

nb::dict dictionary(SpectralResult result) {
    nb::list alternatives;
    for (const SpectralAlternative& other : result.alternatives)
        alternatives.append(dictionary_of("target_from_source", array(other.target_from_source), "score",
                                          other.score, "description", other.description));
    return dictionary_of("target_from_source", array(result.target_from_source), "source_from_target",
                         array(result.source_from_target), "confidence", array(std::move(result.confidence)),
                         "score", result.score, "margin", result.margin, "alternatives", alternatives,
                         "messages", list_of(result.messages), "seconds", seconds_of(result.stages));
}

nb::dict dictionary(PartialResult result) {
    nb::list alternatives;
    for (const PartialAlternative& other : result.alternatives)
        alternatives.append(dictionary_of("target_from_source", array(other.target_from_source), "score",
                                          other.score, "moved", other.moved));
    return dictionary_of("target_from_source", array(result.target_from_source), "source_from_target",
                         array(result.source_from_target), "confidence", array(std::move(result.confidence)),
                         "part", to_string(result.part), "scale", result.scale, "mirrored", result.mirrored,
                         "source_share", result.source_share, "target_share", result.target_share, "score",
                         result.score, "agreement", result.agreement, "margin", result.margin,
                         "gain_in_mirror", result.gain_in_mirror, "alternatives", alternatives,
                         "source_touching", array(std::move(result.source_touching)), "target_touching",
                         array(std::move(result.target_touching)), "messages", list_of(result.messages),
                         "seconds", seconds_of(result.stages));
}

nb::dict dictionary(const UvResult& result) {
    return dictionary_of("target_from_source", array(result.target_from_source), "surface",
                         arrays(result.surface), "confidence", array(Vector(result.confidence)),
                         "source_share", result.source_share, "target_share", result.target_share,
                         "seam_agreement", result.seam_agreement, "n_by_place", result.n_by_place,
                         "n_undecided", result.n_undecided);
}

nb::dict dictionary(const Verdict& verdict) {
    return dictionary_of("advice", to_string(verdict.advice), "reasons", list_of(verdict.reasons));
}

nb::dict dictionary(const MeshComparison& found) {
    std::string axes;
    for (const int axis : found.axes) axes += "xyz"[axis];
    return dictionary_of("source", counts_of(found.source), "target", counts_of(found.target),
                         "same_connectivity", found.same_connectivity, "same_order", found.same_order,
                         "mirrored", found.mirrored, "source_inside_out", found.source_inside_out,
                         "target_inside_out", found.target_inside_out, "scale", found.scale, "axes", axes,
                         "distance", found.distance, "same_places", found.same_places, "messages",
                         list_of(found.messages));
}

template <class Result>
nb::object dictionary(std::optional<Result> result) {
    return result ? nb::object(dictionary(*std::move(result))) : nb::none();
}

nb::dict dictionary(MatchResult result) {
    return dictionary_of(
        "target_from_source", array(result.target_from_source), "method", to_string(result.method), "reason",
        result.reason, "confidence", array(std::move(result.confidence)), "n_filled", result.n_filled,
        "messages", list_of(result.messages), "verdict", dictionary(verdict(result)), "causes",
        list_of(result.causes), "seconds", seconds_of(result.stages), "exact",
        dictionary(std::move(result.exact)), "differences", dictionary(std::move(result.differences)),
        "frontiers", dictionary(std::move(result.frontiers)), "spectral",
        dictionary(std::move(result.spectral)), "partial", dictionary(std::move(result.partial)), "uv",
        dictionary(std::move(result.uv)));
}

using ShapeSource = decltype(MatchOptions::prepared_shape);

// The shapes that are there, and what `otherwise` makes, or this here, of a mesh whose is not.
ShapeSource prepared(const Mesh& source, const SpectralShape* source_shape, const SpectralShape* target_shape,
                     const ShapeSource& otherwise) {
    return
        [&source, source_shape, target_shape, otherwise](MeshView mesh, const SpectralShapeOptions& options) {
            const bool is_source = mesh.vertices.data() == source.view().vertices.data();
            const SpectralShape* const shape = is_source ? source_shape : target_shape;
            if (shape != nullptr) return *shape;
            return otherwise ? otherwise(mesh, options) : SpectralShape(mesh, options);
        };
}

void bind_refinement(nb::module_& module) {
    module.def(
        "refine_map",
        [](const Mesh& source, const Mesh& target, const IndexArray& triangle, const PointArray& weights,
           int n_threads, const nb::object& progress) {
            RefineResult result = run(progress, [&](Progress report) {
                return refine_map(surface_map_of(triangle, weights, target.n_triangles()), source, target,
                                  {.n_threads = n_threads, .progress = std::move(report)});
            });
            const std::vector<Message> causes =
                run([&] { return probable_causes(source, target, result.messages); });
            return dictionary_of("target_from_source", array(result.target_from_source), "confidence",
                                 array(std::move(result.confidence)), "messages", list_of(result.messages),
                                 "verdict", dictionary(verdict(result.messages)), "causes", list_of(causes),
                                 "seconds", seconds_of(result.stages));
        },
        "source"_a, "target"_a, "triangle"_a, "weights"_a, "n_threads"_a, "progress"_a.none());
}

}  // namespace

void bind_matching(nb::module_& module) {
    bind_match_options(module);
    module.def(
        "match",
        [](const Mesh& source, const Mesh& target, MatchOptions options, const SpectralShape* source_shape,
           const SpectralShape* target_shape, const nb::object& progress) {
            if (source_shape != nullptr || target_shape != nullptr)
                options.prepared_shape = prepared(source, source_shape, target_shape, options.prepared_shape);
            return dictionary(run(progress, [&](Progress report) {
                options.progress = std::move(report);
                return match(source, target, options);
            }));
        },
        "source"_a, "target"_a, "options"_a, "source_shape"_a.none(), "target_shape"_a.none(),
        "progress"_a.none());
    bind_refinement(module);
    module.def(
        "choose_method",
        [](const Mesh& source, const Mesh& target, const MatchOptions& options) {
            const MethodChoice choice = run([&] { return choose_method(source, target, options); });
            return dictionary_of("method", to_string(choice.method), "reason", choice.reason, "messages",
                                 list_of(choice.messages));
        },
        "source"_a, "target"_a, "options"_a);
    module.def(
        "compare",
        [](const Mesh& source, const Mesh& target) {
            return dictionary(run([&] { return compare(source, target); }));
        },
        "source"_a, "target"_a);
    module.def(
        "same_order",
        [](const Mesh& source, const Mesh& target) {
            const auto message = run([&] { return same_order(source, target); });
            return list_of(message ? std::vector{*message} : std::vector<Message>{});
        },
        "source"_a, "target"_a);
    module.def(
        "match_exact",
        [](const Mesh& source, const Mesh& target, ExactOptions options, const nb::object& progress) {
            return dictionary(run(progress, [&](Progress report) {
                options.progress = std::move(report);
                return match_exact(source, target, options);
            }));
        },
        "source"_a, "target"_a, "options"_a, "progress"_a.none());
    module.def(
        "find_differences",
        [](const Mesh& source, const Mesh& target, int n_threads, const nb::object& progress) {
            return dictionary(run(progress, [&](Progress report) {
                return find_differences(source, target,
                                        {.n_threads = n_threads, .progress = std::move(report)});
            }));
        },
        "source"_a, "target"_a, "n_threads"_a, "progress"_a.none());
    module.def(
        "match_frontiers",
        [](const Mesh& source, const Mesh& target, FrontiersOptions options, const nb::object& progress) {
            return dictionary(run(progress, [&](Progress report) {
                options.progress = std::move(report);
                return match_frontiers(source, target, options);
            }));
        },
        "source"_a, "target"_a, "options"_a, "progress"_a.none());

    nb::class_<SpectralShape>(module, "SpectralShape")
        .def(
            "__init__",
            [](SpectralShape* self, const Mesh& mesh, SpectralShapeOptions options,
               const nb::object& progress) {
                run(progress, [&](Progress report) {
                    options.progress = std::move(report);
                    new (self) SpectralShape(mesh, options);
                });
            },
            "mesh"_a, "options"_a, "progress"_a.none())
        .def_static(
            "cached",
            [](const std::string& folder, const Mesh& mesh, SpectralShapeOptions options,
               const nb::object& progress) {
                CachedShape found = run(progress, [&](Progress report) {
                    options.progress = std::move(report);
                    return cached_spectral_shape(folder, mesh, options);
                });
                warn(found.warning);
                return std::move(found.shape);
            },
            "folder"_a, "mesh"_a, "options"_a, "progress"_a.none())
        .def_static(
            "read", [](const std::string& file) { return read_spectral_shape(file); }, "file"_a)
        .def_static(
            "from_bytes",
            [](const nb::bytes& bytes) {
                return SpectralShape::from_bytes({bytes.c_str(), bytes.size()});
            },
            "bytes"_a)
        .def("to_bytes",
             [](const SpectralShape& shape) {
                 const std::string bytes = run([&] { return shape.to_bytes(); });
                 return nb::bytes(bytes.data(), bytes.size());
             })
        .def(
            "write",
            [](const SpectralShape& shape, const std::string& file) { write_spectral_shape(shape, file); },
            "file"_a)
        .def_prop_ro("n_vertices", &SpectralShape::n_vertices);
    module.def(
        "match_spectral",
        [](const SpectralShape& source, const SpectralShape& target, SpectralOptions options,
           const std::optional<IndexArray>& initial, const nb::object& progress) {
            return dictionary(run(progress, [&](Progress report) {
                if (initial) options.initial = vertex_map_of(*initial, target.n_vertices());
                options.progress = std::move(report);
                return match_spectral(source, target, options);
            }));
        },
        "source"_a, "target"_a, "options"_a, "initial"_a.none(), "progress"_a.none());
    module.def(
        "match_spectral",
        [](const Mesh& source, const Mesh& target, SpectralOptions options, const SpectralShapeOptions& shape,
           const nb::object& progress) {
            return dictionary(run(progress, [&](Progress report) {
                options.progress = std::move(report);
                return match_spectral(source, target, options, shape);
            }));
        },
        "source"_a, "target"_a, "options"_a, "shape"_a, "progress"_a.none());
    module.def(
        "match_partial",
        [](const Mesh& source, const Mesh& target, PartialOptions options, const nb::object& progress) {
            return dictionary(run(progress, [&](Progress report) {
                options.progress = std::move(report);
                return match_partial(source, target, options);
            }));
        },
        "source"_a, "target"_a, "options"_a, "progress"_a.none());
    module.def(
        "match_assignment",
        [](const Mesh& source, const Mesh& target, Index max_vertices, const nb::object& progress) {
            const AssignmentResult result = run(progress, [&](Progress report) {
                return match_assignment(source, target,
                                        {.max_vertices = max_vertices, .progress = std::move(report)});
            });
            return dictionary_of("target_from_source", array(result.target_from_source), "cost", result.cost);
        },
        "source"_a, "target"_a, "max_vertices"_a, "progress"_a.none());
    module.def(
        "match_nearest",
        [](const Mesh& source, const Mesh& target, bool similarity, int n_threads,
           const nb::object& progress) {
            return array(run(progress, [&](Progress report) {
                             return match_nearest(source, target,
                                                  {.alignment = similarity ? NearestAlignment::similarity
                                                                           : NearestAlignment::centroids,
                                                   .n_threads = n_threads,
                                                   .progress = std::move(report)});
                         }).target_from_source);
        },
        "source"_a, "target"_a, "similarity"_a, "n_threads"_a, "progress"_a.none());
}

}  // namespace counterpart::python
