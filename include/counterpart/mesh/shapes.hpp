// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/mesh/triangle_mesh.hpp>

namespace counterpart {

/// Unit sphere: an icosahedron subdivided 4-to-1 `subdivisions` times (0 .. 10); 10 * 4^subdivisions + 2
/// vertices.
TriangleMesh make_icosphere(int subdivisions);

/// Torus around the z axis with major radius 1 and minor radius 0.4; rings * segments vertices, both at
/// least 3.
TriangleMesh make_torus(int rings, int segments);

/// Unit square in the xy plane with columns x rows cells, each split along the same diagonal; both at
/// least 1.
TriangleMesh make_grid(int columns, int rows);

struct BodyOptions {
    int subdivisions = 2;    ///< 0 .. 7; the vertices are 4 times as many with each: about 4500 with 2
    bool symmetric = false;  ///< both arms alike: one mirror symmetry (x -> -x), of the connectivity too
};

/// A figure with head, arms, legs and a tail, closed, of genus 0, about 1 high (y), facing +z. Unless
/// `symmetric`, its connectivity has no symmetry, so that a copy of it can be matched in one way only.
TriangleMesh make_body(const BodyOptions& options = {});

}  // namespace counterpart
