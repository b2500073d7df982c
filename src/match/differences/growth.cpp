// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/differences/growth.hpp"

#include "match/differences/tuning.hpp"
#include "match/symmetry/pair_geometry.hpp"
#include "numerics/median.hpp"

#include <algorithm>
#include <cmath>

namespace counterpart::differences {

using namespace isomorphism;

PairSide::PairSide(MeshView mesh_of_side, const DartMap& map_of_side)
    : mesh(mesh_of_side), map(map_of_side), colors{vertex_colors(map, 0)} {
    colors[1] = refined_colors(map, colors[0], 1);
    colors[2] = refined_colors(map, colors[1], 1);
}

Growth::Growth(const PairSide& source, const PairSide& target)
    : a_(source),
      b_(target),
      image_(to_size(source.map.n_vertices()), -1),
      origin_(to_size(target.map.n_vertices()), -1),
      source_done_(to_size(source.map.n_triangles()), false),
      target_done_(to_size(target.map.n_triangles()), false) {}

void Growth::settle(const std::vector<DartPair>& pairs) {
    for (auto [d, e] : pairs) {
        source_done_[to_size(triangle_of(d))] = target_done_[to_size(triangle_of(e))] = true;
        for (int c = 0; c < 3; ++c, d = next(d), e = next(e)) {
            Index& image = image_[to_size(a_.map.origin(d))];
            Index& origin = origin_[to_size(b_.map.origin(e))];
            if (image < 0 && origin < 0) {
                image = b_.map.origin(e);
                origin = a_.map.origin(d);
            }
        }
    }
}

void Growth::measure_lengths(const std::vector<DartPair>& pairs) {
    std::vector<double> ratios, differences;
    for (const auto& [d, e] : pairs) {
        const double in_a = a_.length(d), in_b = b_.length(e);
        if (in_a > 0 && in_b > 0) ratios.push_back(in_b / in_a);
    }
    if (ratios.empty()) return;
    fit_.scale = numerics::median(ratios);
    for (const auto& [d, e] : pairs) differences.push_back(shape_difference(d, e));
    fit_.tolerance = std::clamp(tuning.medians * numerics::median(differences), tuning.min_tolerance,
                                tuning.max_tolerance);
}

std::vector<DartPair> Growth::trusted_surroundings(DartPair seed) const {
    std::vector<DartPair> around = surroundings(a_.map, b_.map, seed);
    std::vector<symmetry::PointPair> points;
    double squared_length = 0;
    for (auto [d, e] : around) {
        squared_length += std::pow(b_.length(e), 2) / static_cast<double>(around.size());
        for (int c = 0; c < 3; ++c, d = next(d), e = next(e))
            points.push_back({a_.position(a_.map.origin(d)), b_.position(b_.map.origin(e))});
    }
    const double limit = std::pow(tuning.max_seed_residual, 2) * squared_length;
    if (squared_error(symmetry::fit_alignment(points, false), points) > limit) around.clear();
    return around;
}

double Growth::mean_agreement(const std::vector<DartPair>& pairs) const {
    double sum = 0;
    for (const auto& [d, e] : pairs) sum += agreement(d, e);
    return pairs.empty() ? 0 : sum / static_cast<double>(pairs.size());
}

bool Growth::is_open(DartPair seed) const {
    return !source_done_[to_size(triangle_of(seed.first))] &&
           !target_done_[to_size(triangle_of(seed.second))];
}

void Growth::add_seed(DartPair seed) {
    auto [d, e] = seed;
    for (int c = 0; c < 3; ++c, d = next(d), e = next(e)) {
        const Index v = a_.map.origin(d), w = b_.map.origin(e);
        if (image_[to_size(v)] != w && (image_[to_size(v)] >= 0 || origin_[to_size(w)] >= 0)) return;
    }
    for (int c = 0; c < 3; ++c, d = next(d), e = next(e))
        if (image_[to_size(a_.map.origin(d))] < 0) accept(a_.map.origin(d), b_.map.origin(e));
    match_triangles(d, e);
}

void Growth::propagate(double min_evidence, std::size_t max_triangles) {
    expand();
    while (!proposals_.empty() && proposals_.top().score >= min_evidence && matched_.size() < max_triangles) {
        const Proposal best = proposals_.top();
        proposals_.pop();
        if (image_[to_size(best.v)] >= 0 || origin_[to_size(best.w)] >= 0) continue;
        const auto found = evidence_.find(key(best.v, best.w));
        if (found->second.score > best.score) continue;  // a better entry was popped or is coming
        accept(best.v, best.w);
        for (const auto& [d, e] : std::vector<DartPair>(found->second.voters)) match_triangles(d, e);
        expand();
    }
}

void Growth::reset() {
    for (const Index v : accepted_) {
        origin_[to_size(image_[to_size(v)])] = -1;
        image_[to_size(v)] = -1;
    }
    for (const auto& [d, e] : matched_)
        source_done_[to_size(triangle_of(d))] = target_done_[to_size(triangle_of(e))] = false;
    accepted_.clear();
    matched_.clear();
    evidence_.clear();
    proposals_ = {};
}

void Growth::accept(Index v, Index w) {
    image_[to_size(v)] = w;
    origin_[to_size(w)] = v;
    accepted_.push_back(v);
}

void Growth::match_triangles(Dart d, Dart e) {
    const auto t = to_size(triangle_of(d)), u = to_size(triangle_of(e));
    if (source_done_[t] || target_done_[u]) return;
    source_done_[t] = target_done_[u] = true;
    queue_.emplace_back(d, e);
    matched_.emplace_back(d, e);
}

// Looks over the edges of newly matched triangles.
void Growth::expand() {
    while (!queue_.empty()) {
        auto [d, e] = queue_.back();
        queue_.pop_back();
        for (int side = 0; side < 3; ++side, d = next(d), e = next(e)) {
            const Dart over_d = a_.map.across(d), over_e = b_.map.across(e);
            if (over_d != no_dart && over_e != no_dart && is_open({over_d, over_e})) meet(over_d, over_e);
        }
    }
}

// Two open triangles behind a matched edge.
void Growth::meet(Dart d, Dart e) {
    const Index v = a_.map.apex(d), w = b_.map.apex(e);
    const Index image = image_[to_size(v)], origin = origin_[to_size(w)];
    if (image == w) {
        match_triangles(d, e);
    } else if (image < 0 && origin < 0) {
        const bool is_equal = a_.colors[2][to_size(v)] == b_.colors[2][to_size(w)];
        if (is_equal && shape_difference(d, e) < fit_.tolerance) {
            accept(v, w);
            match_triangles(d, e);
        } else {
            propose(v, w, d, e);
        }
    }
}

void Growth::propose(Index v, Index w, Dart d, Dart e) {
    Evidence& evidence = evidence_[key(v, w)];
    if (evidence.voters.empty())
        for (std::size_t radius = 0; radius < 3; ++radius)
            if (a_.colors[radius][to_size(v)] == b_.colors[radius][to_size(w)])
                evidence.colors += tuning.color_evidence[radius];
    evidence.voters.emplace_back(d, e);
    evidence.agreement += agreement(d, e);
    const auto n = static_cast<double>(evidence.voters.size());
    evidence.score = (evidence.colors + n) * evidence.agreement / n;
    proposals_.push({evidence.score, v, w});
}

double Growth::agreement(Dart d, Dart e) const {
    return tuning.min_agreement +
           (1 - tuning.min_agreement) * std::exp(-std::pow(shape_difference(d, e) / fit_.tolerance, 2));
}

// The largest logarithm of a ratio of edge lengths.
double Growth::shape_difference(Dart d, Dart e) const {
    double least = 1, most = 1;
    for (int c = 0; c < 3; ++c, d = next(d), e = next(e)) {
        const double in_a = fit_.scale * a_.length(d), in_b = b_.length(e);
        if (!(in_a > 0 && in_b > 0)) continue;
        least = std::min(least, in_a / in_b);
        most = std::max(most, in_a / in_b);
    }
    return std::log(std::max(most, 1 / least));
}

namespace {

class Grower {
  public:
    Grower(const PairSide& source, const PairSide& target, const std::vector<DartPair>& settled,
           unsigned parity, const std::function<void()>& report)
        : a_(source), b_(target), parity_(parity), report_(report), growth_(source, target) {
        growth_.settle(settled);
        if (settled.empty() || n_open() == 0) return;
        growth_.measure_lengths(settled);
    }

    GrownMatch run() {
        for (const int radius : tuning.radii) grow_from_unique(radius);
        // A regular mesh whose few irregular vertices lie far apart; then one that looks alike in several
        // places.
        for (const int radius : tuning.wide_radii)
            if (growth_.matched().empty()) grow_from_unique(radius);
        growth_.propagate(tuning.likely);
        bool is_ambiguous = false;
        for (const int radius : {32, 8, 2})
            if (growth_.matched().empty()) is_ambiguous = grow_from_best_trial(radius);
        for (const int radius : tuning.radii)
            if (is_ambiguous) grow_from_unique(radius);
        return {growth_.image(), parity_ == 1, is_ambiguous};
    }
    std::size_t n_matched() const { return growth_.matched().size(); }
    std::size_t n_open() const {
        const auto open = [](const std::vector<bool>& done) {
            return to_size(std::count(done.begin(), done.end(), false));
        };
        return std::min(open(growth_.source_done()), open(growth_.target_done()));
    }

  private:
    struct Colors {
        std::vector<Color> source, target;
    };
    struct Seed {
        double agreement;
        DartPair darts;
    };

    const Colors& look_up_colors(int radius) {
        auto found = colors_.find(radius);
        if (found != colors_.end()) return found->second;
        if (radius <= 2) return colors_[radius] = {a_.colors[to_size(radius)], b_.colors[to_size(radius)]};
        const Colors& half = look_up_colors(radius / 2);
        report_();
        return colors_[radius] = {refined_colors(a_.map, half.source, radius - radius / 2),
                                  refined_colors(b_.map, half.target, radius - radius / 2)};
    }

    std::vector<DartPair> find(int radius, bool shared) {
        const Colors& colors = look_up_colors(radius);
        return find_seeds({a_.map, colors.source, growth_.source_done()},
                          {b_.map, colors.target, growth_.target_done()}, parity_, shared,
                          radius == tuning.radii[0] ? tuning.max_first_darts : tuning.max_darts);
    }

    void grow_from_unique(int radius) {
        const std::vector<DartPair> seeds = find(radius, false);
        if (growth_.matched().empty()) measure_lengths(seeds);
        for (const DartPair& seed : seeds) {
            report_();
            if (!growth_.is_open(seed) || growth_.trusted_surroundings(seed).empty()) continue;
            growth_.add_seed(seed);
            growth_.propagate(tuning.sure);
        }
    }

    void measure_lengths(const std::vector<DartPair>& seeds) {
        std::vector<DartPair> pairs;
        for (const std::size_t i : symmetry::evenly_spread(seeds.size(), tuning.measured_seeds))
            for (const DartPair& pair : growth_.trusted_surroundings(seeds[i])) pairs.push_back(pair);
        growth_.measure_lengths(pairs);
    }

    // Nothing is unique: a region is grown from each of some seeds, and the best one goes on over the whole
    // mesh. Returns whether another one, which says otherwise, did nearly as well.
    bool grow_from_best_trial(int radius) {
        std::vector<Seed> seeds;
        for (const DartPair& darts : find(radius, true)) {
            const std::vector<DartPair> around = growth_.trusted_surroundings(darts);
            if (!around.empty()) seeds.push_back({growth_.mean_agreement(around), darts});
        }
        std::stable_sort(seeds.begin(), seeds.end(),
                         [](const Seed& x, const Seed& y) { return x.agreement > y.agreement; });
        if (seeds.empty()) return false;
        seeds.resize(std::min(seeds.size(), tuning.max_trials));
        double most = 0, second = 0;
        DartPair best = seeds[0].darts;
        std::vector<Index> said;
        for (const Seed& seed : seeds) {
            const Index v = a_.map.origin(seed.darts.first), w = b_.map.origin(seed.darts.second);
            if (!said.empty() && said[to_size(v)] == w) continue;  // the best trial includes it
            growth_.add_seed(seed.darts);
            growth_.propagate(tuning.likely, tuning.trial_triangles);
            const double reached =
                growth_.mean_agreement(growth_.matched()) * static_cast<double>(growth_.matched().size());
            if (reached > most) {
                second = most;
                most = reached;
                best = seed.darts;
                said = growth_.image();
            } else {
                second = std::max(second, reached);
            }
            growth_.reset();
            report_();
        }
        growth_.add_seed(best);
        growth_.propagate(tuning.likely);
        return second > tuning.ambiguous * most;
    }

    const PairSide& a_;
    const PairSide& b_;
    unsigned parity_;
    const std::function<void()>& report_;
    Growth growth_;
    std::unordered_map<int, Colors> colors_;
};

}  // namespace

GrownMatch grow_from_seeds(const PairSide& source, const PairSide& target,
                           const std::vector<DartPair>& settled, const std::function<void()>& report) {
    Grower straight(source, target, settled, 0, report);
    const std::size_t n_open = straight.n_open();
    if (n_open == 0) return straight.run();
    GrownMatch match = straight.run();
    // The other way round is worth a try only if this one found little, and believed only if it finds far
    // more: a body is nearly its own mirror image.
    if (2 * straight.n_matched() >= n_open) return match;
    Grower reversed(source, target, settled, 1, report);
    GrownMatch other = reversed.run();
    return reversed.n_matched() > 2 * straight.n_matched() ? other : match;
}

}  // namespace counterpart::differences
