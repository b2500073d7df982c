// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/io/mesh_file.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace counterpart::io {

/// The largest number of vertices or triangles that Index can count.
constexpr std::int64_t max_count = 2'147'483'647;

/// Gathers vertices and faces while a file is read. Polygons are cut into triangles (cut_into_triangles): one
/// that is convex by a rule that depends on connectivity alone, so that most poses of a mesh are cut alike.
class MeshCollector {
  public:
    void reserve(std::size_t n_vertices, std::size_t n_faces) {
        coordinates_.reserve(3 * n_vertices);
        corners_.reserve(3 * n_faces);
        sizes_.reserve(n_faces);
    }
    void add_vertex(double x, double y, double z) { coordinates_.insert(coordinates_.end(), {x, y, z}); }
    /// `corners` has at least three entries.
    void add_face(std::span<const Index> corners) {
        corners_.insert(corners_.end(), corners.begin(), corners.end());
        sizes_.push_back(static_cast<Index>(corners.size()));
        n_polygons_ += corners.size() > 3;
        n_large_ += corners.size() > static_cast<std::size_t>(max_ear_corners);
    }

    std::int64_t n_vertices() const { return static_cast<std::int64_t>(coordinates_.size() / 3); }
    std::int64_t n_triangles() const {
        return static_cast<std::int64_t>(corners_.size()) - 2 * static_cast<std::int64_t>(sizes_.size());
    }
    /// The mesh, with a notice if polygons were cut; vertices that are no numbers are in left_out, their
    /// faces still there. Throws InvalidInput if there are more than max_count triangles.
    MeshFile finish();

  private:
    std::vector<double> coordinates_;
    std::vector<Index> corners_, sizes_;
    std::int64_t n_polygons_ = 0, n_large_ = 0;
};

}  // namespace counterpart::io
