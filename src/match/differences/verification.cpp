// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/differences/verification.hpp"

#include "match/differences/chance.hpp"
#include "match/differences/triangle_pairs.hpp"
#include "match/differences/tuning.hpp"
#include "match/symmetry/pair_geometry.hpp"
#include "numerics/median.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace counterpart::differences {

using namespace isomorphism;

namespace {

using Region = std::vector<Index>;  // source triangles

class Verifier {
  public:
    Verifier(const PairSide& source, const PairSide& target, const std::vector<Index>& map,
             const std::vector<Index>& partner, Prediction& prediction)
        : source_(source.mesh),
          target_(target.mesh),
          map_(map),
          prediction_(prediction),
          side_(source),
          chance_bits_(information_by_chance(source)),
          local_(to_size(source.mesh.n_triangles()), -1),
          source_valence_(valences(source_)),
          target_valence_(valences(target_)),
          bits_(information(target_)),
          matched_(to_size(source_.n_vertices()), 0),
          n_regions_(matched_),
          kept_(map.size(), VertexMap::unmatched) {
        for (Index t = 0; t < source.map.n_triangles(); ++t)
            local_[to_size(source.map.input_triangle[to_size(t)])] = t;
        for (Index t = 0; t < source_.n_triangles(); ++t)
            for (int c = 0; c < 3 && partner[to_size(t)] >= 0; ++c)
                ++matched_[to_size(source_.triangles(t, c))];
        overall_ = lengths_of(source.map.input_triangle);
    }

    void add(const Region& region, bool is_known) {
        if (is_known) count(region);
        for (const Index v : vertices(region)) {
            kept_[to_size(v)] = map_[v];
            ++n_regions_[to_size(v)];
        }
    }

    /// Unmatches the region's vertices unless the region says enough for itself, or those matched around it
    /// expect them where they are. A limb that is bent, or a few borderline vertices that expect wrongly, are
    /// no reason to doubt a region that chance would not explain.
    void judge(const Region& region) {
        const std::vector<Index> all = vertices(region);
        std::vector<Index> own, border;
        for (const Index v : all) {
            if (--n_regions_[to_size(v)] > 0) continue;  // another region has it too
            own.push_back(v);
            if (matched_[to_size(v)] < source_valence_[to_size(v)]) border.push_back(v);
            kept_[to_size(v)] = VertexMap::unmatched;
        }
        std::vector<double> offsets;
        for (const std::size_t i : symmetry::evenly_spread(border.size(), tuning.region_sample))
            if (const auto offset = prediction_.offset(border[i], map_[border[i]], kept_))
                offsets.push_back(*offset);
        const bool belongs = is_significant(evidence(region)) ||
                             (!offsets.empty() && numerics::median(offsets) <= tuning.max_region_offset);
        if (!belongs) return;
        count(region);
        for (const Index v : own) {
            kept_[to_size(v)] = map_[v];
            ++n_regions_[to_size(v)];
        }
    }

    /// Whether all that was kept says enough, and is not what chance gives.
    bool is_significant() const { return is_significant(kept_evidence_); }
    /// See Verified.
    double agreement() const {
        return std::max(0.0, 1 - length_deviation(log_ratios(region_kept_)) / lengths_of(region_kept_).limit);
    }

    std::vector<Index> without_single() const {
        std::vector<Index> result = kept_;
        for (Index v = 0; v < source_.n_vertices(); ++v) {
            if (kept_[v] < 0 || is_whole(v)) continue;
            const auto offset = prediction_.offset(v, kept_[v], kept_);
            if (offset && *offset > tuning.max_offset) result[to_size(v)] = VertexMap::unmatched;
        }
        return result;
    }

  private:
    std::vector<Index> vertices(const Region& region) const {
        std::vector<Index> found;
        for (const Index t : region)
            for (int c = 0; c < 3; ++c) found.push_back(source_.triangles(t, c));
        std::sort(found.begin(), found.end());
        found.erase(std::unique(found.begin(), found.end()), found.end());
        return found;
    }
    // All triangles around it have a counterpart.
    bool is_whole(Index v) const {
        return matched_[to_size(v)] == source_valence_[to_size(v)] &&
               source_valence_[to_size(v)] == target_valence_[to_size(map_[v])];
    }
    double information_in(const std::vector<Index>& of_region) const {
        double bits = 0;
        for (const Index v : of_region)
            if (is_whole(v)) bits += bits_[to_size(map_[v])];
        return bits;
    }
    std::vector<double> log_ratios(const Region& region) const {
        std::vector<double> ratios;
        for (const Index t : region)
            for (int c = 0; c < 3; ++c) {
                const Index v = source_.triangles(t, c), w = source_.triangles(t, (c + 1) % 3);
                const double before = (source_.vertices.row(v) - source_.vertices.row(w)).norm(),
                             after = (target_.vertices.row(map_[v]) - target_.vertices.row(map_[w])).norm();
                if (before > 0 && after > 0) ratios.push_back(std::log(after / before));
            }
        return ratios;
    }
    struct Lengths {
        double limit;   // of the deviation that confirms
        bool may_veto;  // because chance matches, too
    };
    Lengths lengths_of(const Region& region) const {
        constexpr std::size_t few = 100;  // triangles, on which chance cannot be tried
        if (region.size() < few && overall_) return *overall_;
        Region local = region;
        for (Index& t : local) t = local_[to_size(t)];
        const Chance chance = chance_among(local, side_);
        return chance.alike > tuning.regular
                   ? Lengths{std::clamp(tuning.chance_limit * chance.deviation, tuning.length_rounding,
                                        tuning.length_limit),
                             true}
                   : Lengths{tuning.length_limit, false};
    }
    // In bits. Of lengths nothing where these deviate as chance's do.
    struct Evidence {
        double valences = 0, lengths = 0;
        bool lengths_agree = false;
    };
    Evidence evidence(const Region& region) const {
        const double deviation = length_deviation(log_ratios(region));
        const auto [limit, may_veto] = lengths_of(region);
        const std::vector<Index> all = vertices(region);
        Evidence result{information_in(all), 0, !may_veto || deviation < limit};
        const double most = tuning.max_length_bits / tuning.bits_per_halving,
                     halvings = deviation > 0 ? std::log2(limit / deviation) : most;
        result.lengths =
            static_cast<double>(all.size()) * tuning.bits_per_halving * std::clamp(halvings, 0.0, most);
        return result;
    }
    void count(const Region& region) {
        const Evidence more = evidence(region);
        kept_evidence_.valences += more.valences;
        kept_evidence_.lengths += more.lengths_agree ? more.lengths : -more.valences;
        kept_evidence_.lengths_agree = true;  // of what does not, neither counts
        region_kept_.insert(region_kept_.end(), region.begin(), region.end());
    }
    // By lengths and valences, or by valences alone, if these say more than chance could.
    bool is_significant(const Evidence& evidence) const {
        const double n_a = source_.n_triangles(), n_b = target_.n_triangles(),
                     least = std::log2(3 * n_a * 6 * n_b) + tuning.significance;
        return evidence.valences >= least + tuning.beyond_chance * chance_bits_ ||
               (evidence.lengths_agree && evidence.valences + evidence.lengths >= least);
    }

    MeshView source_;
    MeshView target_;
    const std::vector<Index>& map_;
    Prediction& prediction_;
    const PairSide& side_;
    double chance_bits_;
    std::vector<Index> local_;  // number of each source triangle in the map
    std::vector<Index> source_valence_, target_valence_;
    std::vector<double> bits_;
    std::vector<Index> matched_;    // triangles around each source vertex
    std::vector<Index> n_regions_;  // that have each source vertex
    std::vector<Index> kept_;
    Evidence kept_evidence_;
    Region region_kept_;
    std::optional<Lengths> overall_;  // of all the source
};

}  // namespace

Verified verified(const PairSide& source, const PairSide& target, const std::vector<Index>& map,
                  const std::vector<Index>& partner, const std::vector<bool>& known, Prediction& prediction) {
    Verifier verifier(source, target, map, partner, prediction);
    const std::vector<Region> regions = matched_regions(source.map, partner);
    const auto is_known = [&](const Region& region) { return bool(known[to_size(region[0])]); };
    for (const Region& region : regions) verifier.add(region, is_known(region));
    std::for_each(regions.rbegin(), regions.rend(), [&](const Region& region) {
        if (!is_known(region)) verifier.judge(region);
    });
    if (!verifier.is_significant()) return {std::vector<Index>(map.size(), VertexMap::unmatched), 0};
    return {verifier.without_single(), verifier.agreement()};
}

}  // namespace counterpart::differences
