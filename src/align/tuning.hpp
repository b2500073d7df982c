// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Constants of fit_surface, set by hand with a few people (FAUST) and a lion to other animals (SMAL) in
// sight; not swept.
#pragma once

#include <array>

namespace counterpart::align {

/// Features of the map that are followed, one after the other; fractions of the scan's diagonal.
constexpr std::array<double, 3> map_lengths = {0.2, 0.1, 0.05};
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
constexpr int let_go_rounds = 12;

/// Of a landmark, in mean vertices.
constexpr double landmark_weight = 100;

}  // namespace counterpart::align
