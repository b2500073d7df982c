// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Bodies with limbs, quickly made.
#pragma once

#include <counterpart/mesh/triangle_mesh.hpp>

namespace counterpart::test {

/// An icosphere of radius 1 with spikes of length 2 along +x, 1.2 along +y and 1.6 along -y.
TriangleMesh three_spikes(int n_subdivisions = 4);

}  // namespace counterpart::test
