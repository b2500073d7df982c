// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Every constant of the search for what two meshes share. "Edges" are mean edge lengths around a vertex.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace counterpart::differences {

struct DifferenceTuning {
    // ---- seeds ----
    /// Edges that colors see: wide ones first, because an accident of an edit is the least likely there; the
    /// widest where a regular mesh has nothing unique nearer by.
    std::array<int, 4> radii{8, 4, 2, 1};
    std::array<int, 2> wide_radii{16, 32};
    /// Darts that are looked at for one radius, sampled by color; fewer for the first, because meshes that
    /// differ in a few places are reached from any seed.
    std::size_t max_first_darts = std::size_t{1} << 13U, max_darts = std::size_t{1} << 18U;
    /// Triangles around a seed that must agree.
    std::size_t surroundings = 40;
    /// Root mean square distance, in edges, that they may be from congruent.
    double max_seed_residual = 0.6;
    /// Seeds around which edge lengths are compared first.
    std::size_t measured_seeds = 64;
    /// Seeds where every color is shared by several, and trials of them.
    std::size_t max_rare = 2000, max_trials = 64;
    /// Triangles of a trial.
    std::size_t trial_triangles = 1000;
    /// Share of the best trial that another one reaches if the mesh is ambiguous.
    double ambiguous = 0.85;

    // ---- region growing ----
    /// Evidence of equal colors of radius 0, 1, 2, in triangles that propose a pair.
    std::array<double, 3> color_evidence{0.5, 1.5, 2.0};
    /// Evidence that accepts a pair at first, so that no region runs over an edit before its neighbors do;
    /// and at last. Tried for the last: 0.3 and 1.2. With 1.2 a frame of another pose with a twentieth of its
    /// faces missing is matched to nine tenths only.
    double sure = 3, likely = 0.3;
    /// Agreement of triangles of very different edge lengths: geometry weighs, but has no veto.
    double min_agreement = 0.2;
    /// Logarithm of a ratio of lengths that speaks against a pair: measured as this many medians, within
    /// these limits.
    double medians = 4, min_tolerance = 0.05, max_tolerance = 0.4;

    // ---- verification ----
    /// Bits beyond those that choose one of all placements.
    double significance = 10;
    /// Deviation of lengths (see length_deviation) up to which they confirm what valences say, where chance
    /// matches nothing: 0.01 to 0.1 in right regions of cut bodies, 0.12 to 0.6 in wrong ones. Where chance
    /// does, this share of its own deviation is the most.
    double length_limit = 0.12, chance_limit = 0.5;
    /// Deviation that is rounding: meshes that are the same in shape, too.
    double length_rounding = 1e-4;
    /// Share of chance's pairs whose surroundings agree from which a mesh counts as regular: 0.01 to 0.02 on
    /// scanned faces, 0.05 to 0.25 on remeshed bodies, 0.2 of marching cubes, all of grids.
    double regular = 0.02;
    std::size_t chance_trials = 400;
    /// Regions that are grown by chance, and how large one is that has no end.
    std::size_t chance_regions = 16, chance_triangles = 1000;
    /// Times what regions say that are grown by chance, beyond which valences alone are believed.
    double beyond_chance = 2;
    std::uint64_t chance_seed = 1;
    /// Bits that the lengths around a vertex say for each halving of the deviation, and at most.
    double bits_per_halving = 0.5, max_length_bits = 1.5;
    /// Rings in which anchors are looked for, and how many are enough, and too few.
    int rings = 4;
    std::size_t enough_anchors = 12, min_anchors = 4;
    /// Distance from where the anchors expect a vertex, in edges, that contradicts a region, a vertex, and
    /// that admits a new pair.
    double max_region_offset = 0.75, max_offset = 0.75;
    /// Distance at which a free vertex is taken without further evidence, in rounds; how much more a triangle
    /// (or its worth of equal colors) allows, and how much at most.
    std::array<double, 3> new_offsets{0.2, 0.4, 0.6};
    double offset_per_evidence = 0.2, max_new_offset = 1.5;
    /// Evidence of a new pair that further ones may build on: place alone would drift. With 2 in place of 3
    /// and a depth of 12 the error on parts is 1.1 in place of 0.28, and 11 % are unmatched.
    double anchor_evidence = 3;
    /// The same, counted again when more around the pair is matched. On parts cut from bodies in other poses
    /// 4 finds 1 % more of the vertices and doubles the error in bodies with holes.
    double settled_evidence = 5;
    /// Edges that building on place alone may go. Tried: 4, 8, 12, 16, 24; on parts cut from bodies in other
    /// poses and bodies with holes (mean geodesic error in percent of the square root of the area, share
    /// unmatched): 0.31 and 8 %, 0.37 and 12 % at 12; 0.36 and 7 %, 0.84 and 10 % at 16.
    int max_depth = 12;
    /// Vertices of a region that are asked.
    std::size_t region_sample = 32;
};
inline constexpr DifferenceTuning tuning;

}  // namespace counterpart::differences
