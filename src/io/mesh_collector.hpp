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

/// Gathers vertices and faces while a file is read. A polygon becomes a fan around its first corner: a rule
/// that depends on connectivity alone, so that every pose of one mesh is cut the same way.
class MeshCollector {
  public:
    void reserve(std::size_t n_vertices, std::size_t n_faces) {
        coordinates_.reserve(3 * n_vertices);
        corners_.reserve(3 * n_faces);
    }
    void add_vertex(double x, double y, double z) { coordinates_.insert(coordinates_.end(), {x, y, z}); }
    /// `corners` has at least three entries.
    void add_face(std::span<const Index> corners) {
        for (std::size_t i = 2; i < corners.size(); ++i)
            corners_.insert(corners_.end(), {corners[0], corners[i - 1], corners[i]});
        n_polygons_ += corners.size() > 3;
    }

    std::int64_t n_vertices() const { return static_cast<std::int64_t>(coordinates_.size() / 3); }
    /// The mesh, with a notice if polygons were cut. Throws InvalidInput if there are more than max_count
    /// triangles.
    MeshFile finish();

  private:
    std::vector<double> coordinates_;
    std::vector<Index> corners_;
    std::int64_t n_polygons_ = 0;
};

}  // namespace counterpart::io
