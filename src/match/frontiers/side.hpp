// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "base/to_size.hpp"

#include <counterpart/frontier/frontiers.hpp>
#include <counterpart/match/frontiers.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace counterpart::frontiers {

/// One connected mesh with its frontiers around a seed vertex.
struct FrontierSide {
    FrontierSide(MeshView mesh, const Adjacency& adjacency, Index source);

    MeshView mesh;
    const Adjacency& adjacency;
    Points points;  ///< in mean edge lengths, mean at the origin
    Frontiers frontiers;
    FrontierLoops loops;
    std::vector<Index> slot;                  ///< per vertex: its position in loops.order
    std::vector<std::uint64_t> subtree_hash;  ///< subtree_hashes
};

/// Pairs of vertices of corresponding frontiers.
struct MatchedPairs {
    std::vector<Index> source, target;
    void add(Index s, Index t) {
        source.push_back(s);
        target.push_back(t);
    }
};

Points rows_of(PointsView points, std::span<const Index> rows);

/// One target index per row, -1 for none.
std::vector<Index> pair_up(const Matrix& cost, Pairing pairing, const Progress& progress = {});

/// For work of which no part is told, but which may be stopped: a callback that stays at the beginning.
inline Progress checking(const Progress& progress) { return part_of(progress, 0, 0); }

/// cost(i, j) of pairing source vertex i at aligned(i) with target vertex j: squared distance or the metric.
Matrix pairing_cost(std::span<const Index> source, PointsView aligned, std::span<const Index> target,
                    PointsView target_points, const PairingMetric& metric);

/// x moved onto y as published: centroids aligned, then TPS-RPM from T = 10 S where S, the sum
/// of the squared distances to the closest points, is above the threshold per point. In mean edge lengths.
Points align_whole_frontier(PointsView x, PointsView y, double deformation_threshold,
                            const Progress& progress);

/// Throws InvalidInput at the first frontier whose sizes, or numbers of loops, differ.
void require_same_frontiers(const FrontierSide& source, const FrontierSide& target);

/// Image of each vertex of `source` (connected, same connectivity), -1 for none.
struct SideMatch {
    std::vector<Index> image;
    Index n_decided_by_position = 0;
};
/// As published. Both call options.progress from any thread.
SideMatch match_whole_frontiers(const FrontierSide& source, const FrontierSide& target,
                                const FrontiersOptions& options);
/// Level by level, each guided by the previous ones. `prior`: rotation of the target against the source where
/// it is known, null to find it.
SideMatch match_frontiers_in_sequence(const FrontierSide& source, const FrontierSide& target,
                                      const FrontiersOptions& options, const Eigen::Matrix3d* prior);

}  // namespace counterpart::frontiers
