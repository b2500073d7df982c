// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/exact/partial_growth.hpp"
#include "match/exact/seeding.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <queue>
#include <unordered_map>
#include <utility>
#include <vector>

namespace counterpart {

// Vertex colours that see 0, 1 and 2 edges far.
struct Colors {
    std::array<std::vector<Color>, 3> of_radius;
    explicit Colors(const CombinatorialMap& map)
        : of_radius{vertex_colors(map, 0), vertex_colors(map, 1), vertex_colors(map, 2)} {}
};

// How edge lengths of the two meshes compare where they correspond.
struct LengthFit {
    double scale = 1;        // target / source
    double tolerance = 0.4;  // logarithm of a ratio of lengths that speaks against a pair
};

/// A vertex matching that grows over the edges of matched triangles. Every matched edge proposes the pair of
/// vertices opposite to it; the proposal with the most evidence is accepted next.
class Growth {
  public:
    Growth(const TriangleMesh& source_mesh, const TriangleMesh& target_mesh, const CombinatorialMap& source,
           const CombinatorialMap& target, const LengthFit& fit);

    /// Triangles known to correspond; nothing needs to grow from a whole island.
    void settle(const std::vector<FlagPair>& pairs);

    /// Goes on from what an earlier growth found.
    void resume(const std::vector<FlagPair>& pairs);

    /// Matched triangles that touch no unmatched one, in neither mesh.
    std::vector<FlagPair> sound() const;
    std::size_t n_matched() const { return matched_.size(); }
    /// Sum over the matched triangles of how well they agree in shape, 0.2 .. 1 each.
    double total_agreement() const;

    Seeds seeds(const std::vector<Color>& colors_a, const std::vector<Color>& colors_b,
                unsigned parity) const;

    /// Mean agreement in shape of what is around a seed; 0 where connectivity does not agree there.
    double trust(FlagPair seed) const;

    /// Triangles that one mesh has left to match with the other.
    double n_open() const;
    /// Whether the seed's vertices are matched as it says.
    bool holds(FlagPair seed) const;
    /// Whether neither of its triangles is matched.
    bool is_open(FlagPair seed) const;

    /// Matches the seed's triangle, unless that contradicts what is matched.
    void plant(FlagPair seed);

    /// Accepts proposals from the best down to `least`, while fewer than `most_triangles` are matched.
    void grow(double least, std::size_t most_triangles = static_cast<std::size_t>(-1));

    /// From what was matched: medians, so that what was matched wrongly does not count. One pose twice leaves
    /// a narrow tolerance, with which a wrong pair stands out.
    LengthFit measure_lengths() const;
    PartialMatch result();  ///< also marks what is contested

  private:
    struct Votes {
        double bonus = 0, agreement = 0, score = 0;
        std::vector<FlagPair> voters;  // triangles that would match if this pair did
    };
    struct Proposal {
        double score;
        Index v, w;
        bool operator<(const Proposal& other) const {
            return score != other.score ? score < other.score : std::pair(v, w) > std::pair(other.v, other.w);
        }
    };

    static std::vector<bool> touched(const CombinatorialMap& map, const std::vector<bool>& done);
    static std::uint64_t key(Index v, Index w);
    void accept(Index v, Index w, double score);
    void match_triangles(Flag f, Flag g);

    // Looks over the edges of newly matched triangles: a third vertex that is matched closes the triangle,
    // one that is not is proposed.
    void drain();
    void propose(Index v, Index w, Flag f, Flag g);

    // 1 for triangles of equal edge lengths, 0.2 for very different ones: geometry weighs, but has no veto.
    double shape_agreement(Flag f, Flag g) const;

    // The largest logarithm of a ratio of edge lengths.
    double shape_difference(Flag f, Flag g) const;
    static double length(const TriangleMesh& mesh, const CombinatorialMap& map, Flag f);

    const TriangleMesh& source_mesh_;
    const TriangleMesh& target_mesh_;
    const CombinatorialMap& a_;
    const CombinatorialMap& b_;
    Colors colors_a_, colors_b_;
    std::vector<Index> image_, origin_;
    std::vector<bool> done_a_, done_b_;
    std::vector<double> score_;
    std::vector<bool> contested_;
    std::unordered_map<std::uint64_t, Votes> votes_;
    std::priority_queue<Proposal> heap_;
    std::vector<FlagPair> queue_;
    LengthFit fit_;
    std::vector<FlagPair> matched_;
};

}  // namespace counterpart
