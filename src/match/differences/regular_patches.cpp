// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/differences/regular_patches.hpp"

#include "match/differences/chance.hpp"
#include "match/differences/triangle_pairs.hpp"
#include "match/differences/tuning.hpp"
#include "numerics/median.hpp"

#include <algorithm>
#include <cmath>

namespace counterpart::differences {

using namespace isomorphism;

namespace {

class Patches {
  public:
    Patches(const PairSide& side, MeshView target, const std::vector<Index>& map,
            const std::vector<Index>& partner)
        : side_(side),
          source_(side.mesh),
          target_(target),
          map_(map),
          partner_(partner),
          around_(triangles_at_vertices(side.mesh)),
          is_whole_(around_.size(), 0),
          is_told_(around_.size(), 0) {
        const std::vector<Index> there = valences(target);
        for (std::size_t v = 0; v < around_.size(); ++v)
            is_whole_[v] = map[v] >= 0 && to_size(there[to_size(map[v])]) == around_[v].size() &&
                           std::all_of(around_[v].begin(), around_[v].end(),
                                       [&](Index t) { return partner[to_size(t)] >= 0; });
        tell();
    }

    std::vector<Index> untold() const {
        const std::vector<std::vector<Index>> patches = all();
        std::vector<Index> triangles, found;
        for (const std::vector<Index>& patch : patches)
            triangles.insert(triangles.end(), patch.begin(), patch.end());
        if (triangles.empty()) return {};
        const Chance chance = chance_among(local(triangles), side_);
        if (chance.alike <= tuning.regular) return {};
        const double most = std::clamp(tuning.chance_limit * chance.deviation, tuning.length_rounding,
                                       tuning.length_limit),
                     usual = numerics::median(log_ratios(matched()));
        for (const std::vector<Index>& patch : patches)
            if (touches_a_difference(patch) && deviation(patch, usual) >= most) add_vertices(patch, found);
        std::sort(found.begin(), found.end());
        found.erase(std::unique(found.begin(), found.end()), found.end());
        return found;
    }

  private:
    // From irregular vertices, over matched triangles.
    void tell() {
        const std::vector<double> bits = information(source_);
        std::vector<Index> front;
        for (std::size_t v = 0; v < bits.size(); ++v)
            if (is_whole_[v] != 0 && bits[v] > 0) front.push_back(static_cast<Index>(v));
        for (int ring = 0; ring <= tuning.rings && !front.empty(); ++ring) {
            std::vector<Index> next;
            for (const Index v : front) is_told_[to_size(v)] = 1;
            for (const Index v : front)
                for (const Index t : around_[to_size(v)])
                    for (int c = 0; c < 3 && partner_[to_size(t)] >= 0; ++c)
                        if (is_told_[to_size(source_.triangles(t, c))] == 0)
                            next.push_back(source_.triangles(t, c));
            front = std::move(next);
        }
    }
    bool is_of_patch(Index t) const {
        return partner_[to_size(t)] >= 0 && is_told_[to_size(source_.triangles(t, 0))] == 0 &&
               is_told_[to_size(source_.triangles(t, 1))] == 0 &&
               is_told_[to_size(source_.triangles(t, 2))] == 0;
    }
    // Triangles that hang together over edges.
    std::vector<std::vector<Index>> all() const {
        std::vector<Index> kept = partner_;
        for (Index t = 0; t < source_.n_triangles(); ++t)
            if (!is_of_patch(t)) kept[to_size(t)] = -1;
        return matched_regions(side_.map, kept);
    }
    std::vector<Index> matched() const {
        std::vector<Index> result;
        for (Index t = 0; t < source_.n_triangles(); ++t)
            if (partner_[to_size(t)] >= 0) result.push_back(t);
        return result;
    }
    bool touches_a_difference(const std::vector<Index>& patch) const {
        return std::any_of(patch.begin(), patch.end(), [&](Index t) {
            for (int c = 0; c < 3; ++c)
                if (is_whole_[to_size(source_.triangles(t, c))] == 0) return true;
            return false;
        });
    }
    std::vector<double> log_ratios(const std::vector<Index>& triangles) const {
        std::vector<double> ratios;
        for (const Index t : triangles)
            for (int c = 0; c < 3; ++c) {
                const Index v = source_.triangles(t, c), w = source_.triangles(t, (c + 1) % 3);
                const double before = (source_.vertices.row(v) - source_.vertices.row(w)).norm(),
                             after = (target_.vertices.row(map_[to_size(v)]) -
                                      target_.vertices.row(map_[to_size(w)]))
                                         .norm();
                if (before > 0 && after > 0) ratios.push_back(std::log(after / before));
            }
        return ratios;
    }
    // From the usual ratio, not the patch's own: a finer lattice is another one.
    double deviation(const std::vector<Index>& patch, double usual) const {
        std::vector<double> ratios = log_ratios(patch);
        if (ratios.empty()) return 0;
        for (double& ratio : ratios) ratio = std::abs(ratio - usual);
        return numerics::median(std::move(ratios));
    }
    // Their numbers in the map.
    std::vector<Index> local(const std::vector<Index>& triangles) const {
        std::vector<Index> number(to_size(source_.n_triangles()), -1), result;
        for (Index t = 0; t < side_.map.n_triangles(); ++t)
            number[to_size(side_.map.input_triangle[to_size(t)])] = t;
        for (const Index t : triangles) result.push_back(number[to_size(t)]);
        return result;
    }
    void add_vertices(const std::vector<Index>& patch, std::vector<Index>& found) const {
        for (const Index t : patch)
            for (int c = 0; c < 3; ++c) found.push_back(source_.triangles(t, c));
    }

    const PairSide& side_;
    MeshView source_;
    MeshView target_;
    const std::vector<Index>& map_;
    const std::vector<Index>& partner_;
    std::vector<std::vector<Index>> around_;
    std::vector<char> is_whole_, is_told_;  // of source vertices
};

}  // namespace

std::vector<Index> untold_vertices(const PairSide& source, MeshView target, const std::vector<Index>& map,
                                   const std::vector<Index>& partner) {
    return Patches(source, target, map, partner).untold();
}

}  // namespace counterpart::differences
