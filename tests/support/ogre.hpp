// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/mesh/triangle_mesh.hpp>

namespace counterpart::test {

/// The figure of make_body with 44 parts of its own, one like the other in connectivity: 20 claws at hands
/// and feet, 22 teeth in two rows across the face, close together, and two eyes. Every part has 42 vertices,
/// 1 % of the whole.
TriangleMesh make_ogre();

}  // namespace counterpart::test
