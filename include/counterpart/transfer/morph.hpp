// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/progress.hpp>
#include <counterpart/map/surface_map.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

#include <memory>
#include <vector>

namespace counterpart {

struct MorphOptions {
    /// Alternations of fitting rotations and positions per frame, 0 .. 100. 0 keeps the interpolated
    /// rotations; each further one brings the edges closer to their interpolated lengths.
    int iterations = 3;
    /// Threads to use; 0 = all. Does not change the result.
    int n_threads = 0;
};

/// Shapes in between two key frames of the same connectivity, as rigid as possible: the neighborhood of each
/// vertex rotates from the first pose to the last while its shape, up to that rotation, changes evenly. Keeps
/// one sparse factorization for all frames. at() may be called from several threads.
///
/// Sorkine and Alexa, "As-Rigid-As-Possible Surface Modeling", SGP 2007 (the energy and its alternation);
/// Alexa, Cohen-Or, Levin, "As-Rigid-As-Possible Shape Interpolation", SIGGRAPH 2000 (rotations and shape
/// interpolated apart). Setting up costs about O(V^1.5), a frame O(V log V).
class Morph {
  public:
    /// `first` gives connectivity and pose 0, `last` (n_vertices x 3) pose 1. Throws InvalidInput if their
    /// sizes differ, a coordinate is not finite, or an option is out of range.
    Morph(MeshView first, PointsView last, const MorphOptions& options = {});
    ~Morph();
    Morph(Morph&&) noexcept;
    Morph& operator=(Morph&&) noexcept;

    /// The shape at `time` in [0, 1]; exactly the key frames at 0 and 1. The mean of the vertices moves
    /// in a straight line.
    Points at(double time) const;

    /// Lets the neighborhoods of these triangles, which inverted in some frame, follow the rotation of what
    /// surrounds them; each call widens these neighborhoods by three rings.
    void soften_around(const std::vector<Index>& triangles);

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// The last key frame in the connectivity of the first.
struct LastPose {
    Points vertices;        ///< n_vertices of the first mesh x 3
    Index n_followers = 0;  ///< unmatched vertices, which follow their neighbors
};
/// Where the map takes the vertices of `first`. Unmatched vertices follow the similarity that fits the whole
/// and, on top of it, the displacements of their neighbors (a harmonic extension). O(n^1.5) for n unmatched
/// vertices. Throws InvalidInput if the map does not fit the meshes or a component has no matched vertex.
LastPose last_pose(MeshView first, MeshView last, const SurfaceMap& last_from_first);

/// `count` shapes in between, evenly spaced in time, without the key frames. If triangles invert from one
/// frame to the next, calls soften_around and starts again, up to three times; returns the pass with the
/// fewest inversions.
std::vector<Points> morph_frames(MeshView first, PointsView last, int count, const MorphOptions& options = {},
                                 const Progress& progress = {});

/// The triangles whose normals rotate by more than 90 degrees between two frames.
std::vector<Index> inverted_triangles(TrianglesView triangles, PointsView before, PointsView after);

/// How well a frame preserves the shape of its key frames.
struct MorphQuality {
    double mean_edge_error = 0;  ///< mean over the edges of |length / interpolated length - 1|
    double largest_edge_error = 0;
    double volume_ratio = 0;       ///< signed volume / the smaller volume of the key frames
    Index inverted_triangles = 0;  ///< see inverted_triangles; since the frame before
};
/// `before` is the frame before `frame` in the sequence (the first key frame for the first). Edges whose
/// interpolated length is 0 are left out. O(V + F).
MorphQuality measure_morph(MeshView first, PointsView last, double time, PointsView frame, PointsView before);

}  // namespace counterpart
