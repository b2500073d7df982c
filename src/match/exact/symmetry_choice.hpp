// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/exact/island_pairing.hpp"

namespace counterpart {

/// Measures pairs of islands. Lengths of the source are first scaled to the target's.
class PairGeometry {
  public:
    /// `lengths`: whether lengths will be asked for, which takes a pass over both meshes.
    PairGeometry(const MatchedMaps& maps, bool lengths);

    double length_scale() const { return length_scale_; }
    double mean_length() const { return mean_length_; }

    /// Mean squared difference of the edge lengths of at most `most` triangles.
    double length_disagreement(const IslandPair& pair, std::size_t most) const;
    /// Corners of at most `most` of the pair's triangles.
    std::vector<PointPair> points(const IslandPair& pair, std::size_t most) const;
    /// The same for one triangle, given where its corner 0 lies on both sides.
    void add_points(Flag source, Flag target, std::vector<PointPair>& points) const;
    double triangle_disagreement(Flag source, Flag target) const;

    Index first(const IslandPair& pair) const {
        return maps_.source.island_begin[static_cast<std::size_t>(pair.kind->island)];
    }

  private:
    Eigen::RowVector3d on_source(Flag f) const;
    Eigen::RowVector3d on_target(Flag f) const;

    const MatchedMaps& maps_;
    double length_scale_ = 1, mean_length_ = 0;
};

/// The automorphisms of the pair's representative, best first, at most `count`: by edge lengths; the nearly
/// equal best by distance after `similarity`, or after the pair's own best one where that is null. `turned`
/// asks for the orientation-reversing ones. Looks at all of them on a sample of triangles and at the best on
/// more.
std::vector<Images> rank_automorphisms(const MatchedMaps& maps, const AutomorphismGroup& group,
                                       const PairGeometry& geometry, IslandPair pair, bool turned,
                                       const Motion* similarity, std::size_t count);

}  // namespace counterpart
