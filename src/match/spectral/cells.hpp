// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/spectral/prepared_shape.hpp"

#include <vector>

namespace counterpart::spectral_match {

/// The vertices around each sample of a shape, and the cells around each cell: where partners are looked for.
/// The shape must outlive it.
class Cells {
  public:
    using Lists = std::vector<std::vector<Index>>;

    explicit Cells(const PreparedShape& shape);

    Index of_vertex(Index v) const { return shape_.cell_of_vertex[at(v)]; }
    const Lists& vertices() const { return vertices_; }
    /// Cells within `rings` steps of each cell, itself included. O(rings^2 cells).
    Lists near(int rings) const;

  private:
    const PreparedShape& shape_;
    Lists vertices_, touching_;
};

/// Maps of all vertices from maps of the samples: each vertex follows its nearest sample.
PairedMaps spread(const PreparedShape& a, const PreparedShape& b, const PairedMaps& sample_maps);

/// Images as match_points between all vertices would find them, but each vertex of `from` looks only near the
/// images that it and the vertices around it have in `guess`: among the vertices of the cells there, and of
/// those that are `near` these. Rows of `ours` and `theirs` are coordinates, `half` half the squared lengths
/// of theirs. O(vertices).
std::vector<Index> nearest_nearby(const Cells& from, const Cells& to, const Cells::Lists& near,
                                  const MatrixF& ours, const MatrixF& theirs, const VectorF& half,
                                  const std::vector<Index>& guess, const ProgressRange& progress = {});

}  // namespace counterpart::spectral_match
