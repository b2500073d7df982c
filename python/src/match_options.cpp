// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// The options of matching: plain attributes, set by name.
#include "arrays.hpp"
#include "bindings.hpp"
#include "call.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/io/shape_file.hpp>
#include <counterpart/match/match.hpp>

namespace counterpart::python {
namespace {

using namespace nb::literals;

MatchMethod method_from_name(const std::string& name) {
    if (name == "auto") return MatchMethod::automatic;
    for (const MatchMethod method :
         {MatchMethod::exact, MatchMethod::frontiers, MatchMethod::partial, MatchMethod::spectral,
          MatchMethod::place, MatchMethod::uv, MatchMethod::nearest, MatchMethod::assignment})
        if (name == to_string(method)) return method;
    throw InvalidInput("there is no method '" + name +
                       "': auto, exact, frontiers, partial, spectral, place, uv, nearest or assignment");
}

Part part_from_name(const std::string& name) {
    for (const Part part : {Part::unknown, Part::source, Part::target, Part::both, Part::neither})
        if (name == to_string(part)) return part;
    throw InvalidInput("part cannot be '" + name + "': unknown, source, target, both or neither");
}

Mirror mirror_from_name(const std::string& name) {
    if (name == "auto") return Mirror::automatic;
    if (name == "never") return Mirror::never;
    if (name == "always") return Mirror::always;
    throw InvalidInput("mirror cannot be '" + name + "': auto, never or always");
}

Pairing pairing_from_name(const std::string& name) {
    if (name == "closest") return Pairing::closest;
    if (name == "mutual") return Pairing::mutual;
    if (name == "optimal") return Pairing::optimal;
    throw InvalidInput("there is no pairing '" + name + "': closest, mutual or optimal");
}

using DirectionArray = nb::ndarray<const double, nb::shape<3>, nb::c_contig, nb::device::cpu>;

// An attribute that is set from what `convert` takes. It is never read: the Python side only writes options.
template <class Options, class Value, class Given>
void bind_converted(nb::class_<Options>& options, const char* name, Value Options::*member,
                    Value (*convert)(Given)) {
    options.def_prop_rw(
        name, [](const Options&) { return nb::none(); },
        [member, convert](Options& self, std::remove_cvref_t<Given> given) {
            self.*member = convert(given);
        });
}

// Prepared shapes from this folder.
decltype(MatchOptions::prepared_shape) cached_in(const std::string& folder) {
    return [folder](MeshView mesh, const SpectralShapeOptions& options) {
        CachedShape found = cached_spectral_shape(folder, mesh, options);
        const nb::gil_scoped_acquire lock;
        warn(found.warning);
        return std::move(found.shape);
    };
}

Eigen::Vector3d direction_of(const DirectionArray& array) { return {array(0), array(1), array(2)}; }

void bind_spectral_options(nb::module_& module) {
    nb::class_<SpectralShapeOptions>(module, "SpectralShapeOptions")
        .def(nb::init<>())
        .def_rw("basis_size", &SpectralShapeOptions::basis_size)
        .def_rw("n_samples", &SpectralShapeOptions::n_samples)
        .def_rw("seed", &SpectralShapeOptions::seed)
        .def_rw("n_threads", &SpectralShapeOptions::n_threads);
    nb::class_<SpectralOptions> options(module, "SpectralOptions");
    options.def(nb::init<>())
        .def_rw("soft_landmarks", &SpectralOptions::soft_landmarks)
        .def_rw("aligned", &SpectralOptions::aligned)
        .def_rw("symmetric", &SpectralOptions::symmetric)
        .def_rw("n_alternatives", &SpectralOptions::n_alternatives)
        .def_rw("n_threads", &SpectralOptions::n_threads);
    bind_converted(options, "landmarks", &SpectralOptions::landmarks, pairs_of);
    bind_converted(options, "excluded", &SpectralOptions::excluded, pairs_of);
    bind_converted(options, "mirror", &SpectralOptions::mirror, mirror_from_name);
    bind_converted(options, "up", &SpectralOptions::up, direction_of);
    bind_converted(options, "facing", &SpectralOptions::facing, direction_of);
}

void bind_partial_options(nb::module_& module) {
    nb::class_<PartialOptions> options(module, "PartialOptions");
    options.def(nb::init<>())
        .def_rw("same_scale", &PartialOptions::same_scale)
        .def_rw("mirrored", &PartialOptions::mirrored)
        .def_rw("soft_landmarks", &PartialOptions::soft_landmarks)
        .def_rw("aligned", &PartialOptions::aligned)
        .def_rw("n_samples", &PartialOptions::n_samples)
        .def_rw("n_alternatives", &PartialOptions::n_alternatives)
        .def_rw("seed", &PartialOptions::seed)
        .def_rw("n_threads", &PartialOptions::n_threads);
    bind_converted(options, "part", &PartialOptions::part, part_from_name);
    bind_converted(options, "landmarks", &PartialOptions::landmarks, pairs_of);
    bind_converted(options, "excluded", &PartialOptions::excluded, pairs_of);
    bind_converted(options, "up", &PartialOptions::up, direction_of);
    bind_converted(options, "facing", &PartialOptions::facing, direction_of);
}

}  // namespace

void bind_match_options(nb::module_& module) {
    nb::class_<ExactOptions>(module, "ExactOptions")
        .def(nb::init<>())
        .def_rw("allow_mirror", &ExactOptions::allow_mirror)
        .def_rw("weld_distance", &ExactOptions::weld_distance)
        .def_rw("max_alternatives", &ExactOptions::max_alternatives)
        .def_rw("n_threads", &ExactOptions::n_threads);
    nb::class_<FrontiersOptions> frontiers(module, "FrontiersOptions");
    frontiers.def(nb::init<>())
        .def_rw("source_seed", &FrontiersOptions::source_seed)
        .def_rw("target_seed", &FrontiersOptions::target_seed)
        .def_rw("paper", &FrontiersOptions::paper)
        .def_rw("vertex_hashes", &FrontiersOptions::vertex_hashes)
        .def_rw("edge_splits", &FrontiersOptions::edge_splits)
        .def_rw("n_threads", &FrontiersOptions::n_threads);
    bind_converted(frontiers, "pairing", &FrontiersOptions::pairing, pairing_from_name);
    bind_spectral_options(module);
    bind_partial_options(module);
    nb::class_<MatchOptions> match(module, "MatchOptions");
    match.def(nb::init<>())
        .def_rw("min_shared", &MatchOptions::min_shared)
        .def_rw("exact", &MatchOptions::exact)
        .def_rw("spectral", &MatchOptions::spectral)
        .def_rw("spectral_shape", &MatchOptions::spectral_shape)
        .def_rw("partial", &MatchOptions::partial)
        .def_rw("n_threads", &MatchOptions::n_threads)
        .def(
            "set_uv",
            [](MatchOptions& self, const AttributedMesh& source, const AttributedMesh& target) {
                const auto first = [](const AttributedMesh& mesh) {
                    return mesh.texture_coordinates.empty() ? CornerAttribute{} : mesh.texture_coordinates[0];
                };
                self.uv.source = first(source);
                self.uv.target = first(target);
            },
            "source"_a, "target"_a);
    bind_converted(match, "method", &MatchOptions::method, method_from_name);
    bind_converted(match, "cache", &MatchOptions::prepared_shape, cached_in);
}

}  // namespace counterpart::python
