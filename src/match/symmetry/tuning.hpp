// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Every constant of the exact method, with what it does to results.
#pragma once

#include <cstddef>

namespace counterpart::symmetry {

struct ExactTuning {
    /// Relative difference below which two squared errors tie.
    double tie = 0.01;
    /// Edge lengths, in mean edge lengths, that are rounding.
    double rounding = 1e-5;
    /// Triangles on which every automorphism is compared, and how many darts all of them may have together.
    std::size_t min_sample = 8, max_sample = 256, max_sampled_darts = std::size_t{1} << 24U;
    /// Automorphisms that are compared on the whole component, or this many of its triangles.
    /// Half of them by lengths, the others by place of those whose lengths, of the sample, are nearly as
    /// good.
    double nearly = 0.5;
    std::size_t n_finalists = 32, max_final_triangles = 100'000;
    /// Triangles of a component that fix where it lies.
    std::size_t anchor_triangles = 200;
    /// Pairs of points that are known, and how many of them, the nearest, the alignment near a component is
    /// fitted to: of 1024 over a whole head too few lie around an eye.
    std::size_t max_anchors = 8192, near_anchors = 192;
    /// Components of one class that are assigned optimally, O(n^3); beyond, the closest first.
    std::size_t max_optimal = 400;
    /// Partners that the closest-first assignment looks at.
    int n_nearest = 16;
    /// Initial alignments where nothing is unambiguous: looked at, tried, and rounds of each.
    std::size_t max_initial = 4096, max_tried = 12;
    int max_rounds = 3;
    /// Components on which an initial alignment is judged.
    std::size_t alignment_sample = 32;

    /// Lengths decide between two ways if the squared error of the worse one is so many times as large.
    double clear = 4;

    /// Automorphisms that a chosen one is compared with, and triangles on which they are.
    std::size_t n_compared = 32, confirming_triangles = 2000;
    /// Equal components of one class that are confirmed for all.
    std::size_t n_confirmed = 16;
    /// It is confirmed by a deviation of lengths up to this share of that of the others, or by being so many
    /// times as far below theirs as the best would be by chance; and a deviation that is as good as none.
    double clear_share = 0.5, beyond_chance = 1.25, alike = 0.01;
    /// And by this rank correlation of mean curvature: 0.95 to 1 of eggs and blobs that are bent or twisted,
    /// 0.6 to 0.98 of those warped by 5 to 15 %; 0.3 to 0.6 of two wraps of one blob, 0.9 where they are
    /// turned by 11 degrees only.
    double curve_alike = 0.65;

    // ---- non-manifold meshes ----
    /// Isomorphisms that are compared, and triangles of them that may be measured together.
    std::size_t max_isomorphisms = 1000, max_measured_triangles = 20'000'000;
    /// Steps of the search: per triangle of the mesh, and in all meshes.
    std::size_t search_steps_per_triangle = 100, min_search_steps = 1'000'000;
    /// Triangles of all written-out automorphisms of one component.
    std::size_t max_written_out = std::size_t{1} << 22U;
};
inline constexpr ExactTuning exact_tuning;

}  // namespace counterpart::symmetry
