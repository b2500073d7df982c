// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/progress.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

#include <memory>
#include <vector>

namespace counterpart {

struct MorphOptions {
    /// Alternations of fitting rotations and positions per frame, 0 .. 100. 0 keeps the interpolated
    /// rotations; each one more brings the edges closer to their interpolated lengths.
    int iterations = 3;
    /// Threads to use; 0 = all. The result does not depend on it.
    int n_threads = 0;
};

/// In-between shapes of two key frames with one connectivity, as rigid as possible: the neighbourhood of each
/// vertex turns from the first pose to the last while its shape, seen from within, changes evenly. Keeps one
/// sparse factorization for all frames. at() may be called from several threads.
///
/// Sorkine and Alexa, "As-Rigid-As-Possible Surface Modeling", SGP 2007 (the energy and its alternation);
/// Alexa, Cohen-Or, Levin, "As-Rigid-As-Possible Shape Interpolation", SIGGRAPH 2000 (rotations and shape
/// interpolated apart). Setting up costs about O(V^1.5), a frame O(V log V).
class Morph {
  public:
    /// `first` gives connectivity and pose 0, `last` (n_vertices x 3) pose 1. Throws InvalidInput if their
    /// sizes differ, a coordinate is not finite, or an option is out of range.
    Morph(const TriangleMesh& first, const Points& last, const MorphOptions& options = {});
    ~Morph();
    Morph(Morph&&) noexcept;
    Morph& operator=(Morph&&) noexcept;

    /// The shape at `time` in [0, 1]; exactly the key frames at 0 and 1. The mean of the vertices moves
    /// straight.
    Points at(double time) const;

    /// Lets the surroundings of these triangles, which were seen to turn over, follow the rotation of what
    /// lies around them; each call widens the softened patches by three rings.
    void soften(const std::vector<Index>& triangles);

  private:
    struct Machinery;
    std::unique_ptr<Machinery> machinery_;
};

/// `count` in-betweens, evenly spaced in time, without the key frames. Where triangles turn over from one
/// frame to the next, softens and starts again, up to three times; the pass with the fewest is returned.
std::vector<Points> morph_frames(const TriangleMesh& first, const Points& last, int count,
                                 const MorphOptions& options = {}, const Progress& progress = {});

/// The triangles whose normals turn by over 90 degrees from one frame to another.
std::vector<Index> inverted_triangles(const Triangles& triangles, const Points& before, const Points& after);

/// How well an in-between keeps to its key frames.
struct MorphQuality {
    double mean_edge_error = 0;  ///< mean over the edges of |length / interpolated length - 1|
    double largest_edge_error = 0;
    double volume_ratio = 0;       ///< signed volume over the smaller one of the key frames
    Index inverted_triangles = 0;  ///< see inverted_triangles; since the frame before
};
/// `before` is the frame before `frame` in the sequence (the first key frame for the first). Edges whose
/// interpolated length is 0 are left out. O(V + F).
MorphQuality measure_morph(const TriangleMesh& first, const Points& last, double time, const Points& frame,
                           const Points& before);

}  // namespace counterpart
