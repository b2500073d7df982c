// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/types.hpp>

#include <numeric>
#include <span>
#include <vector>

namespace counterpart::mesh {

/// The triangles around each vertex, in compressed rows, in increasing order. O(V + F).
class Fans {
  public:
    Fans(TrianglesView triangles, Index n_vertices) : first_(static_cast<std::size_t>(n_vertices) + 1, 0) {
        for (const Index v : triangles.reshaped()) ++first_[static_cast<std::size_t>(v) + 1];
        std::partial_sum(first_.begin(), first_.end(), first_.begin());
        std::vector<Index> next(first_.begin(), first_.end() - 1);
        triangles_.resize(static_cast<std::size_t>(triangles.size()));
        for (Index t = 0; t < static_cast<Index>(triangles.rows()); ++t) {
            for (int c = 0; c < 3; ++c) {
                Index& place = next[static_cast<std::size_t>(triangles(t, c))];
                triangles_[static_cast<std::size_t>(place++)] = t;
            }
        }
    }

    std::span<const Index> around(Index vertex) const {
        const auto v = static_cast<std::size_t>(vertex);
        return {triangles_.data() + first_[v], static_cast<std::size_t>(first_[v + 1] - first_[v])};
    }

  private:
    std::vector<Index> first_, triangles_;
};

}  // namespace counterpart::mesh
