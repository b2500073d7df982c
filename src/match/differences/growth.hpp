// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/differences/seeding.hpp"

#include <counterpart/mesh/triangle_mesh.hpp>

#include <array>
#include <cstdint>
#include <functional>
#include <queue>
#include <unordered_map>
#include <vector>

namespace counterpart::differences {

/// One of the two meshes.
struct PairSide {
    MeshView mesh;
    const DartMap& map;
    std::array<std::vector<Color>, 3> colors;  ///< of its vertices, seeing 0, 1, 2 edges far

    PairSide(MeshView mesh_of_side, const DartMap& map_of_side);
    Eigen::RowVector3d position(Index v) const {
        return mesh.vertices.row(map.input_vertex[isomorphism::to_size(v)]);
    }
    double length(Dart d) const {
        return (position(map.origin(d)) - position(map.origin(isomorphism::next(d)))).norm();
    }
};

/// How edge lengths of the two meshes compare where they correspond.
struct LengthFit {
    double scale = 1;        ///< target / source
    double tolerance = 0.4;  ///< logarithm of a ratio of lengths that speaks against a pair
};

/// Region growing over the edges of matched triangles. A matched edge proposes the pair of vertices opposite
/// to it. A pair of equal surroundings is accepted at once, of the others the one with the most evidence.
class Growth {
  public:
    Growth(const PairSide& source, const PairSide& target);

    /// Triangles known to correspond, from which nothing needs to grow.
    void settle(const std::vector<DartPair>& pairs);
    /// From what corresponds: medians, so that what is wrong among it does not count.
    void measure_lengths(const std::vector<DartPair>& pairs);

    /// What is around a seed, if that agrees in connectivity and is nearly congruent; else none.
    std::vector<DartPair> trusted_surroundings(DartPair seed) const;
    /// Mean agreement in shape, 0.2 to 1.
    double mean_agreement(const std::vector<DartPair>& pairs) const;

    /// Whether neither of the seed's triangles is matched.
    bool is_open(DartPair seed) const;
    /// Matches the seed's triangle, unless that contradicts what is matched.
    void add_seed(DartPair seed);
    /// Accepts proposals from the best down to `min_evidence`, while fewer than `max_triangles` are matched.
    void propagate(double min_evidence, std::size_t max_triangles = static_cast<std::size_t>(-1));
    /// Takes back all but what was settled.
    void reset();

    const std::vector<DartPair>& matched() const { return matched_; }
    const std::vector<Index>& image() const { return image_; }  ///< target vertex or -1
    const std::vector<bool>& source_done() const { return source_done_; }
    const std::vector<bool>& target_done() const { return target_done_; }

  private:
    struct Evidence {
        double colors = 0, agreement = 0, score = 0;
        std::vector<DartPair> voters;  // triangles that would match if this pair did
    };
    struct Proposal {
        double score;
        Index v, w;
        bool operator<(const Proposal& other) const {
            return score != other.score ? score < other.score : std::pair(v, w) > std::pair(other.v, other.w);
        }
    };
    static std::uint64_t key(Index v, Index w) {
        return (static_cast<std::uint64_t>(v) << 32U) | static_cast<std::uint64_t>(w);
    }

    void accept(Index v, Index w);
    void match_triangles(Dart d, Dart e);
    void expand();
    void meet(Dart d, Dart e);
    void propose(Index v, Index w, Dart d, Dart e);
    double agreement(Dart d, Dart e) const;
    double shape_difference(Dart d, Dart e) const;

    const PairSide& a_;
    const PairSide& b_;
    LengthFit fit_;
    std::vector<Index> image_, origin_;
    std::vector<bool> source_done_, target_done_;
    std::unordered_map<std::uint64_t, Evidence> evidence_;
    std::priority_queue<Proposal> proposals_;
    std::vector<DartPair> queue_, matched_;
    std::vector<Index> accepted_;  // source vertices
};

struct GrownMatch {
    std::vector<Index> image;  ///< local target vertex of each local source vertex, or -1
    bool reversed = false;     ///< the surfaces are wound against each other
    bool ambiguous = false;    ///< another way to match had nearly as much evidence as a whole
};

/// Grows from every trusted seed. `settled`: triangles that correspond already. `report` is called between
/// steps.
GrownMatch grow_from_seeds(const PairSide& source, const PairSide& target,
                           const std::vector<DartPair>& settled, const std::function<void()>& report);

}  // namespace counterpart::differences
