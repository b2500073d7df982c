// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// What chance would give on these very meshes.
#pragma once

#include "match/differences/growth.hpp"

namespace counterpart::differences {

/// A null model: some triangles of a mesh laid on each other where they do not belong, from pairs of darts of
/// equal valences drawn at random. Regular meshes (grids, marching cubes, subdivisions) agree with themselves
/// everywhere.
struct Chance {
    double alike = 0;      ///< share of the pairs whose surroundings agree in connectivity
    double deviation = 0;  ///< of lengths there (see length_deviation): a tenth of those pairs deviate less
};

/// The most that the irregular vertices of a region say (see `information`) which region growing finds by
/// chance, where a mesh is laid on itself; infinite where such a region has no end. O(trials) likewise.
double information_by_chance(const PairSide& mesh);

/// -log2 of the frequency of each vertex's valence. The commonest says nothing, because growing goes on for
/// as long as it meets it; nor do vertices of a boundary, which lies along a boundary wherever it begins to.
std::vector<double> information(MeshView mesh);

/// Of the triangles with these numbers in `mesh.map`. O(trials) beside the sorting of darts.
Chance chance_among(const std::vector<Index>& triangles, const PairSide& mesh);

/// How unlike edges are in length: the median of how far the logarithms of their ratios are from the median
/// ratio. 0 for none.
double length_deviation(std::vector<double> log_ratios);

}  // namespace counterpart::differences
