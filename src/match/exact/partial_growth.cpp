// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/exact/partial_growth.hpp"

#include "match/exact/walk.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>
#include <unordered_map>

namespace counterpart {
namespace {

using FlagPair = std::pair<Flag, Flag>;

struct Colors {
    std::array<std::vector<Color>, 3> of_radius;
    explicit Colors(const CombinatorialMap& map)
        : of_radius{vertex_colors(map, 0), vertex_colors(map, 1), vertex_colors(map, 2)} {}
};

// Flags gone along with their island's winding (or against it) by colour.
std::vector<std::pair<Color, Flag>> colored_flags(const CombinatorialMap& map,
                                                  const std::vector<Color>& colors,
                                                  const std::vector<bool>& settled, unsigned parity) {
    std::vector<std::pair<Color, Flag>> flags;
    for (Index t = 0; t < map.n_triangles(); ++t) {
        if (settled[static_cast<std::size_t>(t)]) continue;
        for (int c = 0; c < 3; ++c) {
            const Flag f = make_flag(t, c, map.parity(make_flag(t, c)) ^ parity);
            flags.emplace_back(flag_color(map, colors, f), f);
        }
    }
    std::sort(flags.begin(), flags.end());
    return flags;
}

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

    // Pairs of flags whose colour occurs once on each side; where there are none, a few of the rarest colour.
    std::vector<FlagPair> seeds(unsigned parity) const {
        const auto in_a = colored_flags(a_, colors_a_.of_radius[2], done_a_, 0);
        const auto in_b = colored_flags(b_, colors_b_.of_radius[2], done_b_, parity);
        std::vector<FlagPair> unique, rare;
        std::size_t fewest = static_cast<std::size_t>(-1);
        for (std::size_t i = 0, j = 0, i_end, j_end; i < in_a.size() && j < in_b.size();) {
            const Color color = std::max(in_a[i].first, in_b[j].first);
            while (i < in_a.size() && in_a[i].first < color) ++i;
            while (j < in_b.size() && in_b[j].first < color) ++j;
            if (i == in_a.size() || j == in_b.size()) break;
            if (in_a[i].first != in_b[j].first) continue;
            for (i_end = i; i_end < in_a.size() && in_a[i_end].first == in_a[i].first;) ++i_end;
            for (j_end = j; j_end < in_b.size() && in_b[j_end].first == in_a[i].first;) ++j_end;
            const std::size_t ways = (i_end - i) * (j_end - j);
            if (ways == 1) unique.emplace_back(in_a[i].second, in_b[j].second);
            if (ways < fewest) {
                fewest = ways;
                rare.clear();
                for (std::size_t k = j; k < std::min(j_end, j + 100); ++k)
                    rare.emplace_back(in_a[i].second, in_b[k].second);
            }
            i = i_end;
            j = j_end;
        }
        return unique.empty() ? rare : unique;
    }

    // A seed counts if what is around it agrees far beyond chance: the walk closes around vertices as it
    // must.
    bool is_trustworthy(FlagPair seed) const {
        constexpr std::size_t enough = 40;
        std::unordered_map<Index, Index> image, origin,
            triangles{{triangle_of(seed.first), triangle_of(seed.second)}};
        std::vector<FlagPair> queue{seed};
        int agree = 0, disagree = 0;
        const auto consistent = [&](Index v, Index w) {
            const auto [to, new_v] = image.try_emplace(v, w);
            const auto [from, new_w] = origin.try_emplace(w, v);
            return to->second == w && from->second == v;
        };
        auto [f, g] = seed;
        for (int c = 0; c < 3; ++c, f = next(f), g = next(g)) consistent(a_.origin(f), b_.origin(g));
        for (std::size_t k = 0; k < queue.size(); ++k) {
            auto [f0, g0] = queue[k];
            for (int side = 0; side < 3; ++side, f0 = next(f0), g0 = next(g0)) {
                const Flag over_f = a_.across(f0), over_g = b_.across(g0);
                if (over_f == no_flag && over_g == no_flag) continue;
                if (over_f == no_flag || over_g == no_flag) {
                    ++disagree;
                    continue;
                }
                const auto known = triangles.find(triangle_of(over_f));
                if (known != triangles.end()) {
                    ++(known->second == triangle_of(over_g) ? agree : disagree);
                    continue;
                }
                if (queue.size() >= enough) continue;
                const Index v = a_.apex(over_f), w = b_.apex(over_g);
                const bool met = image.contains(v) || origin.contains(w);
                if (!consistent(v, w)) {
                    ++disagree;
                    continue;
                }
                if (met) agree += 2;
                triangles.emplace(triangle_of(over_f), triangle_of(over_g));
                queue.emplace_back(over_f, over_g);
            }
        }
        // Every step looks back over the edge it came by; that much agreement is free.
        const int earned = agree - static_cast<int>(queue.size() - 1);
        const bool whole = queue.size() < enough && disagree == 0 && queue.size() >= 4;
        return whole || (queue.size() >= enough / 2 && earned >= 3 * disagree && earned >= 10);
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
    void grow(double least) {
        drain();
        while (!heap_.empty() && heap_.top().score >= least) {
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
        return {image_, contested_, false};
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

void grow_from_seeds(Growth& growth, unsigned parity) {
    for (const FlagPair& seed : growth.seeds(parity)) {
        if (!growth.is_open(seed) || !growth.is_trustworthy(seed)) continue;
        growth.plant(seed);
        growth.grow(3);  // the sure ones, so that no region runs over an edit before its neighbours do
    }
}

}  // namespace

PartialMatch grow_matching(const TriangleMesh& source_mesh, const TriangleMesh& target_mesh,
                           const CombinatorialMap& source, const CombinatorialMap& target,
                           const std::vector<std::pair<Flag, Flag>>& settled) {
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
        for (int pass = 0; pass < passes; ++pass) {
            Growth growth(source_mesh, target_mesh, source, target, fit);
            growth.settle(settled);
            growth.resume(sound);
            if (pass < 2) grow_from_seeds(growth, parity);
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
