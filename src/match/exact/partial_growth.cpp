// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/exact/partial_growth.hpp"

#include "match/exact/seeding.hpp"
#include "match/exact/walk.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <queue>
#include <unordered_map>

namespace counterpart {
namespace {

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

double mean_length(const TriangleMesh& mesh) {
    double sum = 0;
    for (Index t = 0; t < mesh.n_triangles(); ++t)
        for (int c = 0; c < 3; ++c)
            sum +=
                (mesh.vertices.row(mesh.triangles(t, c)) - mesh.vertices.row(mesh.triangles(t, (c + 1) % 3)))
                    .norm();
    return sum / (3.0 * mesh.n_triangles());
}

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

class Growth {
  public:
    Growth(const TriangleMesh& source_mesh, const TriangleMesh& target_mesh, const CombinatorialMap& source,
           const CombinatorialMap& target, const LengthFit& fit)
        : source_mesh_(source_mesh),
          target_mesh_(target_mesh),
          a_(source),
          b_(target),
          colors_a_(source),
          colors_b_(target),
          image_(static_cast<std::size_t>(source.n_vertices()), -1),
          origin_(static_cast<std::size_t>(target.n_vertices()), -1),
          done_a_(static_cast<std::size_t>(source.n_triangles()), false),
          done_b_(static_cast<std::size_t>(target.n_triangles()), false),
          score_(image_.size(), 0),
          contested_(image_.size(), false),
          fit_(fit) {}

    // Triangles known to correspond; nothing needs to grow from a whole island.
    void settle(const std::vector<FlagPair>& pairs) {
        for (auto [f, g] : pairs) {
            done_a_[static_cast<std::size_t>(triangle_of(f))] =
                done_b_[static_cast<std::size_t>(triangle_of(g))] = true;
            for (int c = 0; c < 3; ++c, f = next(f), g = next(g)) {
                Index& image = image_[static_cast<std::size_t>(a_.origin(f))];
                Index& origin = origin_[static_cast<std::size_t>(b_.origin(g))];
                if (image < 0 && origin < 0) {
                    image = b_.origin(g);
                    origin = a_.origin(f);
                }
            }
        }
    }

    // Goes on from what an earlier growth found.
    void resume(const std::vector<FlagPair>& pairs) {
        for (const auto& [first_f, first_g] : pairs) {
            Flag f = first_f, g = first_g;
            for (int c = 0; c < 3; ++c, f = next(f), g = next(g)) {
                if (image_[static_cast<std::size_t>(a_.origin(f))] < 0)
                    accept(a_.origin(f), b_.origin(g), 10);
            }
        }
        for (const auto& [f, g] : pairs) match_triangles(f, g);
        drain();
    }

    // Matched triangles that touch no unmatched one, in neither mesh.
    std::vector<FlagPair> sound() const {
        const std::vector<bool> torn_a = touched(a_, done_a_), torn_b = touched(b_, done_b_);
        std::vector<FlagPair> pairs;
        for (const FlagPair& pair : matched_) {
            bool whole = true;
            auto [f, g] = pair;
            for (int c = 0; c < 3; ++c, f = next(f), g = next(g))
                whole = whole && !torn_a[static_cast<std::size_t>(a_.origin(f))] &&
                        !torn_b[static_cast<std::size_t>(b_.origin(g))];
            if (whole) pairs.push_back(pair);
        }
        return pairs;
    }
    std::size_t n_matched() const { return matched_.size(); }
    double total_agreement() const {
        double sum = 0;
        for (const auto& [f, g] : matched_) sum += shape_agreement(f, g);
        return sum;
    }

    Seeds seeds(const std::vector<Color>& colors_a, const std::vector<Color>& colors_b,
                unsigned parity) const {
        return find_seeds({a_, colors_a, done_a_}, {b_, colors_b, done_b_}, parity);
    }
    // Mean agreement in shape of what is around a seed; 0 where connectivity does not agree there.
    double trust(FlagPair seed) const {
        const std::vector<FlagPair> around = surroundings(a_, b_, seed);
        double sum = 0;
        for (const auto& [f, g] : around) sum += shape_agreement(f, g);
        return around.empty() ? 0 : sum / static_cast<double>(around.size());
    }
    // Triangles that one mesh has left to match with the other.
    double n_open() const {
        const auto open = [](const std::vector<bool>& done) {
            return std::count(done.begin(), done.end(), false);
        };
        return static_cast<double>(std::min(open(done_a_), open(done_b_)));
    }

    bool holds(FlagPair seed) const {
        auto [f, g] = seed;
        bool all = true;
        for (int c = 0; c < 3; ++c, f = next(f), g = next(g))
            all = all && image_[static_cast<std::size_t>(a_.origin(f))] == b_.origin(g);
        return all;
    }

    bool is_open(FlagPair seed) const {
        return !done_a_[static_cast<std::size_t>(triangle_of(seed.first))] &&
               !done_b_[static_cast<std::size_t>(triangle_of(seed.second))];
    }

    void plant(FlagPair seed) {
        auto [f, g] = seed;
        for (int c = 0; c < 3; ++c, f = next(f), g = next(g)) {
            const Index x = image_[static_cast<std::size_t>(a_.origin(f))],
                        y = origin_[static_cast<std::size_t>(b_.origin(g))];
            if ((x >= 0 || y >= 0) && (x != b_.origin(g) || y != a_.origin(f))) return;
        }
        for (int c = 0; c < 3; ++c, f = next(f), g = next(g)) accept(a_.origin(f), b_.origin(g), 10);
        match_triangles(f, g);
        drain();
    }

    // Accepts proposals from the best down to `least`.
    void grow(double least, std::size_t most_triangles = static_cast<std::size_t>(-1)) {
        drain();
        while (!heap_.empty() && heap_.top().score >= least && matched_.size() < most_triangles) {
            const Proposal best = heap_.top();
            heap_.pop();
            if (image_[static_cast<std::size_t>(best.v)] >= 0 ||
                origin_[static_cast<std::size_t>(best.w)] >= 0)
                continue;
            const auto votes = votes_.find(key(best.v, best.w));
            if (votes->second.score > best.score) continue;  // a better entry was popped or is coming
            accept(best.v, best.w, best.score);
            for (const auto& [f, g] : std::vector<FlagPair>(votes->second.voters)) match_triangles(f, g);
            drain();
        }
    }

    // From what was matched: medians, so that what was matched wrongly does not count. One pose twice leaves
    // a narrow tolerance, with which a wrong pair stands out.
    LengthFit measure_lengths() const {
        LengthFit fit = fit_;
        if (matched_.size() < 20) return fit;
        std::vector<double> ratios, differences;
        for (const auto& [f, g] : matched_) {
            const double in_a = length(source_mesh_, a_, f), in_b = length(target_mesh_, b_, g);
            if (in_a > 0 && in_b > 0) ratios.push_back(in_b / in_a);
        }
        if (ratios.empty()) return fit;
        const double correction = median(ratios) / fit.scale;
        fit.scale *= correction;
        for (auto [f, g] : matched_) {
            double worst = 0;
            for (int c = 0; c < 3; ++c, f = next(f), g = next(g)) {
                const double in_a = fit.scale * length(source_mesh_, a_, f),
                             in_b = length(target_mesh_, b_, g);
                if (in_a > 0 && in_b > 0) worst = std::max(worst, std::abs(std::log(in_a / in_b)));
            }
            differences.push_back(worst);
        }
        fit.tolerance = std::clamp(4 * median(differences), 0.05, 0.4);
        return fit;
    }

    PartialMatch result() {
        for (const auto& [pair, votes] : votes_) {
            const auto v = static_cast<std::size_t>(pair >> 32U),
                       w = static_cast<std::size_t>(pair & 0xffffffffU);
            if (image_[v] == static_cast<Index>(w)) continue;
            if (image_[v] >= 0 && votes.score > 0.6 * score_[v]) contested_[v] = true;
            if (origin_[w] < 0) continue;
            const auto rival = static_cast<std::size_t>(origin_[w]);
            if (votes.score > 0.6 * score_[rival]) contested_[rival] = true;
        }
        return {image_, contested_, false, false};
    }

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

    static std::vector<bool> touched(const CombinatorialMap& map, const std::vector<bool>& done) {
        std::vector<bool> torn(static_cast<std::size_t>(map.n_vertices()), false);
        for (std::size_t h = 0; h < map.corner.size(); ++h)
            if (!done[h / 3]) torn[static_cast<std::size_t>(map.corner[h])] = true;
        return torn;
    }

    static std::uint64_t key(Index v, Index w) {
        return (static_cast<std::uint64_t>(v) << 32U) | static_cast<std::uint64_t>(w);
    }

    void accept(Index v, Index w, double score) {
        image_[static_cast<std::size_t>(v)] = w;
        origin_[static_cast<std::size_t>(w)] = v;
        score_[static_cast<std::size_t>(v)] = score;
    }

    void match_triangles(Flag f, Flag g) {
        const auto t = static_cast<std::size_t>(triangle_of(f)), u = static_cast<std::size_t>(triangle_of(g));
        if (done_a_[t] || done_b_[u]) return;
        done_a_[t] = done_b_[u] = true;
        queue_.emplace_back(f, g);
        matched_.emplace_back(f, g);
    }

    // Looks over the edges of newly matched triangles: a third vertex that is matched closes the triangle,
    // one that is not is proposed.
    void drain() {
        while (!queue_.empty()) {
            auto [f, g] = queue_.back();
            queue_.pop_back();
            for (int side = 0; side < 3; ++side, f = next(f), g = next(g)) {
                const Flag over_f = a_.across(f), over_g = b_.across(g);
                if (over_f == no_flag || over_g == no_flag) continue;
                if (done_a_[static_cast<std::size_t>(triangle_of(over_f))] ||
                    done_b_[static_cast<std::size_t>(triangle_of(over_g))])
                    continue;
                const Index v = a_.apex(over_f), w = b_.apex(over_g);
                const Index image = image_[static_cast<std::size_t>(v)],
                            origin = origin_[static_cast<std::size_t>(w)];
                if (image == w)
                    match_triangles(over_f, over_g);
                else if (image < 0 && origin < 0)
                    propose(v, w, over_f, over_g);
            }
        }
    }

    void propose(Index v, Index w, Flag f, Flag g) {
        Votes& votes = votes_[key(v, w)];
        if (votes.voters.empty()) {
            constexpr std::array<double, 3> bonus{0.5, 1.5, 2.0};
            for (std::size_t radius = 0; radius < 3; ++radius) {
                if (colors_a_.of_radius[radius][static_cast<std::size_t>(v)] ==
                    colors_b_.of_radius[radius][static_cast<std::size_t>(w)])
                    votes.bonus += bonus[radius];
            }
        }
        votes.voters.emplace_back(f, g);
        votes.agreement += shape_agreement(f, g);
        const auto n = static_cast<double>(votes.voters.size());
        votes.score = (votes.bonus + n) * votes.agreement / n;
        heap_.push({votes.score, v, w});
    }

    // 1 for triangles of equal edge lengths, 0.2 for very different ones: geometry weighs, but has no veto.
    double shape_agreement(Flag f, Flag g) const {
        return 0.2 + 0.8 * std::exp(-std::pow(shape_difference(f, g) / fit_.tolerance, 2));
    }
    // The largest logarithm of a ratio of edge lengths.
    double shape_difference(Flag f, Flag g) const {
        double worst = 0;
        for (int c = 0; c < 3; ++c, f = next(f), g = next(g)) {
            const double in_a = fit_.scale * length(source_mesh_, a_, f), in_b = length(target_mesh_, b_, g);
            if (in_a > 0 && in_b > 0) worst = std::max(worst, std::abs(std::log(in_a / in_b)));
        }
        return worst;
    }
    static double length(const TriangleMesh& mesh, const CombinatorialMap& map, Flag f) {
        return (mesh.vertices.row(map.input_vertex[static_cast<std::size_t>(map.origin(f))]) -
                mesh.vertices.row(map.input_vertex[static_cast<std::size_t>(map.origin(next(f)))]))
            .norm();
    }

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

struct FirstSeed {
    FlagPair seed;
    bool is_ambiguous = false;  // another one, which says otherwise, does nearly as well
};

// The seed to begin with: the one from which most of the mesh is reached in agreement. Where the mesh is
// regular, or nearly symmetric, and its rare spots are cut out, connectivity alone would begin anywhere.
// Tried in three rounds, ever fewer seeds grow ever further: by the shape of what is around them, of a
// thousand triangles, and of all. `enough`: the share of the mesh from which on no other is tried.
std::optional<FirstSeed> first_seed(const std::vector<FlagPair>& seeds, const Growth& growth, double enough,
                                    double least) {
    using Ranked = std::vector<std::pair<double, FlagPair>>;
    constexpr std::size_t region = 1000, everything = static_cast<std::size_t>(-1);
    const auto budget = [&](double triangles, double fewest, double most) {
        return static_cast<std::size_t>(std::clamp(triangles / (1 + growth.n_open()), fewest, most));
    };
    const auto best_first = [](Ranked& ranked) {
        std::stable_sort(ranked.begin(), ranked.end(),
                         [](const auto& a, const auto& b) { return a.first > b.first; });
    };
    Ranked near;
    for (const FlagPair& seed : seeds)
        if (const double trust = growth.trust(seed); trust > 0) near.emplace_back(trust, seed);
    best_first(near);

    Ranked reached;
    std::vector<Growth> tried;  // so that no seed is tried that one before it says already
    const auto grow = [&](const FlagPair& seed, std::size_t most) {
        Growth& trial = tried.emplace_back(growth);
        trial.plant(seed);
        trial.grow(least, most);
        return trial.total_agreement();
    };
    const auto is_said = [&](const FlagPair& seed) {
        return std::any_of(tried.begin(), tried.end(),
                           [&](const Growth& trial) { return trial.holds(seed); });
    };
    if (near.size() > 1 && growth.n_open() > 2 * region) {
        const std::size_t most_regions = budget(10'000'000, 10, 300);
        for (const auto& [trust, seed] : near) {
            if (tried.size() == most_regions) break;
            if (!is_said(seed)) reached.emplace_back(grow(seed, region), seed);
        }
        best_first(reached);
        tried.clear();
    } else {
        reached = near;
    }

    std::optional<FirstSeed> best;
    double most = 0;
    const std::size_t most_trials = budget(1'000'000, 4, 40);
    for (const auto& [agreement, seed] : reached) {
        if (tried.size() == most_trials) break;
        if (is_said(seed)) continue;
        const double all = grow(seed, everything);
        const bool is_close = std::min(all, most) > 0.85 * std::max(all, most);
        if (all > most)
            best = {seed, is_close};
        else if (is_close)
            best->is_ambiguous = true;
        most = std::max(most, all);
        if (most > enough * growth.n_open()) break;
    }
    return best;
}

// A few hundred, evenly spread.
std::vector<FlagPair> some_of(const std::vector<FlagPair>& seeds) {
    const std::size_t step = 1 + seeds.size() / 500;
    std::vector<FlagPair> some;
    for (std::size_t i = 0; i < seeds.size(); i += step) some.push_back(seeds[i]);
    return some;
}

// From what is unique in the widest surroundings first: the least likely to be so by accident of an edit.
// Returns whether another beginning would have done nearly as well.
bool grow_from_seeds(Growth& growth, const SeedColors& colors, unsigned parity) {
    // The sure ones, so that no region runs over an edit before its neighbours do; but where nothing is
    // unique, one region must reach all.
    constexpr double sure = 3, likely = 0.7;
    bool is_ambiguous = false;
    const auto plant = [&](const FlagPair& seed, double least) {
        if (!growth.is_open(seed) || growth.trust(seed) <= 0) return;
        growth.plant(seed);
        growth.grow(least);
    };
    const auto seeds = [&](std::size_t r) {
        return growth.seeds(colors.source[r], colors.target[r], parity);
    };
    for (const bool unique : {true, false}) {
        for (std::size_t r = colors.source.size(); r-- > 0 && growth.n_matched() == 0;) {
            const Seeds at = seeds(r);
            const double least = unique ? sure : likely;
            const auto seed =
                first_seed(some_of(unique ? at.unique : at.rare), growth, unique ? 0.5 : 0.95, least);
            if (!seed) continue;
            plant(seed->seed, least);
            is_ambiguous = seed->is_ambiguous;
        }
    }
    if (growth.n_matched() == 0) return false;
    for (std::size_t r = colors.source.size(); r-- > 0;)
        for (const FlagPair& seed : seeds(r).unique) plant(seed, sure);
    return is_ambiguous;
}

}  // namespace

PartialMatch grow_matching(const TriangleMesh& source_mesh, const TriangleMesh& target_mesh,
                           const CombinatorialMap& source, const CombinatorialMap& target,
                           const std::vector<std::pair<Flag, Flag>>& settled) {
    const SeedColors colors(source, target);
    PartialMatch best;
    Index best_matched = -1;
    for (unsigned parity = 0; parity < 2; ++parity) {
        LengthFit fit;
        const double length_a = mean_length(source_mesh), length_b = mean_length(target_mesh);
        if (length_a > 0 && length_b > 0) fit.scale = length_b / length_a;
        // The first pass measures how lengths compare. The others forget what lies around each difference
        // and close the gaps again, now with evidence from all sides.
        constexpr int passes = 4;
        PartialMatch match;
        std::size_t most = 0;
        std::vector<FlagPair> sound;
        bool is_ambiguous = false;
        for (int pass = 0; pass < passes; ++pass) {
            Growth growth(source_mesh, target_mesh, source, target, fit);
            growth.settle(settled);
            growth.resume(sound);
            if (pass < 2) is_ambiguous = grow_from_seeds(growth, colors, parity);
            for (const double least : {3.0, 0.7, 0.3}) growth.grow(least);
            fit = growth.measure_lengths();
            if (pass == 0) continue;
            sound = growth.sound();
            if (growth.n_matched() < most) continue;
            most = growth.n_matched();
            match = growth.result();
        }
        const auto matched = static_cast<Index>(
            std::count_if(match.image.begin(), match.image.end(), [](Index w) { return w >= 0; }));
        match.turned = parity == 1;
        match.ambiguous = is_ambiguous;
        if (matched > best_matched) {
            best = std::move(match);
            best_matched = matched;
        }
        // The other way round is worth a try only if this one found little.
        if (2 * best_matched > std::min(source.n_vertices(), target.n_vertices())) break;
    }
    return best;
}

}  // namespace counterpart
