// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/differences/verification.hpp"

#include "match/differences/growth.hpp"
#include "match/differences/triangle_pairs.hpp"
#include "match/differences/tuning.hpp"
#include "match/symmetry/pair_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace counterpart::differences {

using namespace isomorphism;

namespace {

using Region = std::vector<Index>;  // source triangles

// -log2 of the frequency of each vertex's valence; the commonest says nothing, because growing goes on for as
// long as it meets it.
std::vector<double> information(const std::vector<Index>& valence) {
    std::map<Index, double> count;
    for (const Index k : valence) count[k] += 1;
    double most = 0;
    for (const auto& [k, n] : count) most = std::max(most, n);
    std::vector<double> bits;
    for (const Index k : valence)
        bits.push_back(count[k] == most ? 0 : std::log2(static_cast<double>(valence.size()) / count[k]));
    return bits;
}

class Verifier {
  public:
    Verifier(MeshView source, MeshView target, const std::vector<Index>& map,
             const std::vector<Index>& partner, Prediction& prediction)
        : source_(source),
          target_(target),
          map_(map),
          prediction_(prediction),
          source_valence_(valences(source)),
          target_valence_(valences(target)),
          bits_(information(target_valence_)),
          matched_(to_size(source.n_vertices()), 0),
          n_regions_(matched_),
          kept_(map.size(), VertexMap::unmatched) {
        for (Index t = 0; t < source.n_triangles(); ++t)
            for (int c = 0; c < 3 && partner[to_size(t)] >= 0; ++c)
                ++matched_[to_size(source.triangles(t, c))];
    }

    void add(const Region& region) {
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
        const double bits = information_in(all) * (1 + length_agreement(region));
        const bool belongs = is_significant(bits, region.size()) ||
                             (!offsets.empty() && median(offsets) <= tuning.max_region_offset);
        if (!belongs) return;
        bits_kept_ += bits;
        triangles_kept_ += region.size();
        for (const Index v : own) {
            kept_[to_size(v)] = map_[v];
            ++n_regions_[to_size(v)];
        }
    }

    /// Whether all that was kept says enough.
    bool is_significant() const { return is_significant(bits_kept_, triangles_kept_); }

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
    // From 0 to 1: how well edges keep their lengths, but for a common factor. It only adds to what valences
    // say, since a regular mesh repeats its lengths too.
    double length_agreement(const Region& region) const {
        std::vector<double> ratios;
        for (const Index t : region)
            for (int c = 0; c < 3; ++c) {
                const Index v = source_.triangles(t, c), w = source_.triangles(t, (c + 1) % 3);
                const double before = (source_.vertices.row(v) - source_.vertices.row(w)).norm(),
                             after = (target_.vertices.row(map_[v]) - target_.vertices.row(map_[w])).norm();
                if (before > 0 && after > 0) ratios.push_back(std::log(after / before));
            }
        if (ratios.empty()) return 0;
        const double common = median(ratios);
        for (double& ratio : ratios) ratio = std::abs(ratio - common);
        return std::exp(-std::pow(median(ratios) / tuning.length_tolerance, 2));
    }
    bool is_significant(double bits, std::size_t n_triangles) const {
        const double n_a = source_.n_triangles(), n_b = target_.n_triangles();
        return 2 * static_cast<double>(n_triangles) >= std::min(n_a, n_b) ||
               bits >= std::log2(3 * n_a * 6 * n_b) + tuning.significance;
    }

    MeshView source_;
    MeshView target_;
    const std::vector<Index>& map_;
    Prediction& prediction_;
    std::vector<Index> source_valence_, target_valence_;
    std::vector<double> bits_;
    std::vector<Index> matched_;    // triangles around each source vertex
    std::vector<Index> n_regions_;  // that have each source vertex
    std::vector<Index> kept_;
    double bits_kept_ = 0;
    std::size_t triangles_kept_ = 0;
};

}  // namespace

std::vector<Index> without_misplaced(const DartMap& source, MeshView source_mesh, MeshView target_mesh,
                                     const std::vector<Index>& map, const std::vector<Index>& partner,
                                     const std::vector<bool>& known, Prediction& prediction) {
    Verifier verifier(source_mesh, target_mesh, map, partner, prediction);
    const std::vector<Region> regions = matched_regions(source, partner);
    const auto is_known = [&](const Region& region) { return bool(known[to_size(region[0])]); };
    for (const Region& region : regions) verifier.add(region);
    std::for_each(regions.rbegin(), regions.rend(), [&](const Region& region) {
        if (!is_known(region)) verifier.judge(region);
    });
    if (std::none_of(known.begin(), known.end(), [](bool is) { return is; }) && !verifier.is_significant())
        return std::vector<Index>(map.size(), VertexMap::unmatched);
    return verifier.without_single();
}

}  // namespace counterpart::differences
