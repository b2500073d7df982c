// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Constants of fit_surface, set with people (FAUST) and a lion to other animals (SMAL) in sight
// (benchmarks/fit_sweep.py); those of mending within the ranges given, the others by hand.
#pragma once

#include <array>

namespace counterpart::align {

/// Features of the map that are followed, one after the other; fractions of the scan's diagonal. Ending at
/// 0.05, ears stay behind.
constexpr std::array<double, 5> map_lengths = {0.2, 0.1, 0.05, 0.025, 0.0125};
constexpr int rounds_per_map_length = 6;
/// An image this far from where the surface is drawn counts half; fraction of the scan's diagonal.
constexpr double image_doubt = 0.05;

/// Lengths between the last of the map's and the finest, and drawings at each.
constexpr int surface_levels = 6, rounds_per_level = 4;
/// How far a vertex is drawn, in the length of the level: one that the map leaves out hardly at all, or a
/// missing head is drawn down to the shoulders.
constexpr double matched_reach = 3, unmatched_reach = 0.5;
/// Between the normals of the template and of the scan's triangle that it is drawn to.
constexpr double least_cosine = 0.5;

/// A triangle collapses below this share of its area.
constexpr double collapsing = 0.05;
/// What a vertex of such a triangle keeps of its hold on the scan, and by what the others regain theirs.
constexpr double letting_go = 0.2, recovery = 1.5;
/// At the end, rounds of mending (tried 12 .. 40), and after how many a patch grows by an edge (3 .. 30).
constexpr int mending_rounds = 20, rounds_per_ring = 20;
/// What the vertices around keep of their hold in each round (0.75 .. 1; less is smoother and farther from
/// the scan).
constexpr double letting_go_around = 0.95;
/// A triangle below this share of its area is as bad as so many spoiled ones (20 .. 1000).
constexpr double vanishing = 0.02, vanishing_harm = 20;

/// Of a landmark, in mean vertices.
constexpr double landmark_weight = 100;

}  // namespace counterpart::align
