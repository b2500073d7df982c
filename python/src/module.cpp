// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "bindings.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/base/progress.hpp>

namespace counterpart::python {
namespace {

// An exception of the library under the name that users see.
template <class Error>
nb::handle bind_error(nb::module_& module, const char* name, nb::handle base, const char* doc) {
    auto error = nb::exception<Error>(module, name, base);
    error.attr("__doc__") = doc;
    return error;
}

}  // namespace

NB_MODULE(_core, module) {
    module.attr("version") = COUNTERPART_VERSION;
    const nb::handle invalid = bind_error<InvalidInput>(
        module, "InvalidInput", PyExc_ValueError,
        "The data or options cannot be used; the message names the element and what to do.");
    bind_error<UnsuitableMesh>(
        module, "UnsuitableMesh", invalid,
        "A valid mesh that this method cannot handle (too few vertices, no area); another method may.");
    bind_error<IoError>(
        module, "IoError", PyExc_OSError,
        "A file cannot be read or written; the message names the file, the line and the reason.");
    bind_error<NumericalError>(module, "NumericalError", PyExc_ArithmeticError,
                               "A computation on valid input failed (singular system, no convergence).");
    bind_error<Canceled>(module, "Canceled", PyExc_RuntimeError, "The progress callback returned False.");
    bind_meshes(module);
    bind_content(module);
    bind_matching(module);
    bind_maps(module);
    bind_spectral(module);
    bind_transfer(module);
    bind_pictures(module);
}

}  // namespace counterpart::python
