// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "arrays.hpp"
#include "bindings.hpp"
#include "call.hpp"
#include "dictionary.hpp"

#include <counterpart/descriptor/descriptors.hpp>
#include <counterpart/spectral/eigen_basis.hpp>
#include <counterpart/spectral/functional_map.hpp>
#include <counterpart/spectral/zoom_out.hpp>

namespace counterpart::python {
namespace {

using namespace nb::literals;

EigenBasis basis_of(const VectorArray& eigenvalues, const ColumnArray& eigenfunctions,
                    const VectorArray& mass) {
    return {map_of(eigenvalues), map_of(eigenfunctions), map_of(mass)};
}

}  // namespace

void bind_spectral(nb::module_& module) {
    nb::class_<EigenBasis>(module, "EigenBasis")
        .def(
            "__init__",
            [](EigenBasis* self, const VectorArray& eigenvalues, const ColumnArray& eigenfunctions,
               const VectorArray& mass) {
                new (self) EigenBasis(basis_of(eigenvalues, eigenfunctions, mass));
            },
            "eigenvalues"_a, "eigenfunctions"_a, "mass"_a);
    module.def(
        "spectrum",
        [](const Mesh& mesh, int n_functions, const nb::object& progress) {
            EigenBasis basis =
                run(progress, [&](const Progress& report) { return eigen_basis(mesh, n_functions, report); });
            return std::tuple(array(std::move(basis.eigenvalues)),
                              matrix_array(std::move(basis.eigenfunctions)), array(std::move(basis.mass)));
        },
        "mesh"_a, "n_functions"_a, "progress"_a.none());
    module.def(
        "functional_map",
        [](const IndexArray& target_from_source, const EigenBasis& source, const EigenBasis& target, int k) {
            return matrix_array(run([&] {
                return functional_map(
                    vertex_map_of(target_from_source, static_cast<Index>(target.mass.size())), source, target,
                    k);
            }));
        },
        "target_from_source"_a, "source"_a, "target"_a, "k"_a);
    module.def(
        "vertex_map",
        [](const ColumnArray& source_from_target, const EigenBasis& source, const EigenBasis& target) {
            return array(run([&, copy = Eigen::MatrixXd(map_of(source_from_target))] {
                return vertex_map(copy, source, target);
            }));
        },
        "source_from_target"_a, "source"_a, "target"_a);
    module.def(
        "zoom_out",
        [](const IndexArray& target_from_source, const EigenBasis& source, const EigenBasis& target,
           int first, int last, int step, bool bijective, int n_threads, const nb::object& progress) {
            ZoomOutResult result = run(progress, [&](Progress report) {
                return zoom_out(vertex_map_of(target_from_source, static_cast<Index>(target.mass.size())),
                                source, target,
                                {.first = first,
                                 .last = last,
                                 .step = step,
                                 .bijective = bijective,
                                 .n_threads = n_threads,
                                 .progress = std::move(report)});
            });
            return std::tuple(array(result.target_from_source), array(result.source_from_target),
                              matrix_array(std::move(result.source_functions_from_target)));
        },
        "target_from_source"_a, "source"_a, "target"_a, "first"_a, "last"_a, "step"_a, "bijective"_a,
        "n_threads"_a, "progress"_a.none());
    module.def(
        "wave_kernel_signature",
        [](const EigenBasis& basis, int n_energies) {
            return matrix_array(
                run([&] { return wave_kernel_signature(basis, {.n_energies = n_energies}); }));
        },
        "basis"_a, "n_energies"_a);
    module.def(
        "heat_kernel_signature",
        [](const EigenBasis& basis, int n_times) {
            return matrix_array(run([&] { return heat_kernel_signature(basis, {.n_times = n_times}); }));
        },
        "basis"_a, "n_times"_a);
}

}  // namespace counterpart::python
