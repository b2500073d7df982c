// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Bodies with limbs, quickly made.
#pragma once

#include <counterpart/mesh/triangle_mesh.hpp>

#include <utility>
#include <vector>

namespace counterpart::test {

/// An icosphere of radius 1 with spikes of length 2 along +x, 1.2 along +y and 1.6 along -y.
TriangleMesh three_spikes(int n_subdivisions = 4);

/// That body, vertex by vertex, with the spike along +x twice as long: to 5 instead of 3.
TriangleMesh with_longer_spike(TriangleMesh spikes);
/// To which vertex of the one each vertex of the other is nearest in space: tips end halfway down longer
/// spikes.
std::vector<Index> nearest_vertices(const Points& from, const Points& to);

/// Maps of that body, however it is scaled, to itself: each vertex stays; each goes to the vertex nearest to
/// its mirror image in y, so that the spikes along +y and -y are exchanged.
std::vector<Index> staying(const TriangleMesh& spikes);
std::vector<Index> exchanged(const TriangleMesh& spikes);

/// A tube of radius up to 0.25 bent around the z axis at distance 1, almost to a ring: its two ends, at -x,
/// face each other 0.04 apart.
TriangleMesh horseshoe(int n_subdivisions = 4);
/// The vertices at its ends; it may be moved and scaled.
std::pair<Index, Index> ends_of_horseshoe(const TriangleMesh& mesh);

}  // namespace counterpart::test
