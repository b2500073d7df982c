// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// The functions of the module, by subject. They take arrays of one type and layout and return arrays, numbers
// and dictionaries: python/counterpart3d/*.py gives them the face that users see.
#pragma once

#include <nanobind/nanobind.h>

namespace counterpart::python {

namespace nb = nanobind;

void bind_meshes(nb::module_& module);
void bind_content(nb::module_& module);
void bind_match_options(nb::module_& module);
void bind_matching(nb::module_& module);
void bind_maps(nb::module_& module);
void bind_spectral(nb::module_& module);
void bind_transfer(nb::module_& module);
void bind_pictures(nb::module_& module);

}  // namespace counterpart::python
