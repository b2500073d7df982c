// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/exact/growth.hpp"

#include <algorithm>

namespace counterpart {
namespace {

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

}  // namespace

Growth::Growth(const TriangleMesh& source_mesh, const TriangleMesh& target_mesh,
               const CombinatorialMap& source, const CombinatorialMap& target, const LengthFit& fit)
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

void Growth::settle(const std::vector<FlagPair>& pairs) {
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

void Growth::resume(const std::vector<FlagPair>& pairs) {
    for (const auto& [first_f, first_g] : pairs) {
        Flag f = first_f, g = first_g;
        for (int c = 0; c < 3; ++c, f = next(f), g = next(g)) {
            if (image_[static_cast<std::size_t>(a_.origin(f))] < 0) accept(a_.origin(f), b_.origin(g), 10);
        }
    }
    for (const auto& [f, g] : pairs) match_triangles(f, g);
    drain();
}

std::vector<FlagPair> Growth::sound() const {
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

double Growth::total_agreement() const {
    double sum = 0;
    for (const auto& [f, g] : matched_) sum += shape_agreement(f, g);
    return sum;
}

Seeds Growth::seeds(const std::vector<Color>& colors_a, const std::vector<Color>& colors_b,
                    unsigned parity) const {
    return find_seeds({a_, colors_a, done_a_}, {b_, colors_b, done_b_}, parity);
}

double Growth::trust(FlagPair seed) const {
    const std::vector<FlagPair> around = surroundings(a_, b_, seed);
    double sum = 0;
    for (const auto& [f, g] : around) sum += shape_agreement(f, g);
    return around.empty() ? 0 : sum / static_cast<double>(around.size());
}

double Growth::n_open() const {
    const auto open = [](const std::vector<bool>& done) {
        return std::count(done.begin(), done.end(), false);
    };
    return static_cast<double>(std::min(open(done_a_), open(done_b_)));
}

bool Growth::holds(FlagPair seed) const {
    auto [f, g] = seed;
    bool all = true;
    for (int c = 0; c < 3; ++c, f = next(f), g = next(g))
        all = all && image_[static_cast<std::size_t>(a_.origin(f))] == b_.origin(g);
    return all;
}

bool Growth::is_open(FlagPair seed) const {
    return !done_a_[static_cast<std::size_t>(triangle_of(seed.first))] &&
           !done_b_[static_cast<std::size_t>(triangle_of(seed.second))];
}

void Growth::plant(FlagPair seed) {
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

void Growth::grow(double least, std::size_t most_triangles) {
    drain();
    while (!heap_.empty() && heap_.top().score >= least && matched_.size() < most_triangles) {
        const Proposal best = heap_.top();
        heap_.pop();
        if (image_[static_cast<std::size_t>(best.v)] >= 0 || origin_[static_cast<std::size_t>(best.w)] >= 0)
            continue;
        const auto votes = votes_.find(key(best.v, best.w));
        if (votes->second.score > best.score) continue;  // a better entry was popped or is coming
        accept(best.v, best.w, best.score);
        for (const auto& [f, g] : std::vector<FlagPair>(votes->second.voters)) match_triangles(f, g);
        drain();
    }
}

LengthFit Growth::measure_lengths() const {
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
            const double in_a = fit.scale * length(source_mesh_, a_, f), in_b = length(target_mesh_, b_, g);
            if (in_a > 0 && in_b > 0) worst = std::max(worst, std::abs(std::log(in_a / in_b)));
        }
        differences.push_back(worst);
    }
    fit.tolerance = std::clamp(4 * median(differences), 0.05, 0.4);
    return fit;
}

PartialMatch Growth::result() {
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

std::vector<bool> Growth::touched(const CombinatorialMap& map, const std::vector<bool>& done) {
    std::vector<bool> torn(static_cast<std::size_t>(map.n_vertices()), false);
    for (std::size_t h = 0; h < map.corner.size(); ++h)
        if (!done[h / 3]) torn[static_cast<std::size_t>(map.corner[h])] = true;
    return torn;
}

std::uint64_t Growth::key(Index v, Index w) {
    return (static_cast<std::uint64_t>(v) << 32U) | static_cast<std::uint64_t>(w);
}

void Growth::accept(Index v, Index w, double score) {
    image_[static_cast<std::size_t>(v)] = w;
    origin_[static_cast<std::size_t>(w)] = v;
    score_[static_cast<std::size_t>(v)] = score;
}

void Growth::match_triangles(Flag f, Flag g) {
    const auto t = static_cast<std::size_t>(triangle_of(f)), u = static_cast<std::size_t>(triangle_of(g));
    if (done_a_[t] || done_b_[u]) return;
    done_a_[t] = done_b_[u] = true;
    queue_.emplace_back(f, g);
    matched_.emplace_back(f, g);
}

void Growth::drain() {
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

void Growth::propose(Index v, Index w, Flag f, Flag g) {
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

double Growth::shape_agreement(Flag f, Flag g) const {
    return 0.2 + 0.8 * std::exp(-std::pow(shape_difference(f, g) / fit_.tolerance, 2));
}

double Growth::shape_difference(Flag f, Flag g) const {
    double worst = 0;
    for (int c = 0; c < 3; ++c, f = next(f), g = next(g)) {
        const double in_a = fit_.scale * length(source_mesh_, a_, f), in_b = length(target_mesh_, b_, g);
        if (in_a > 0 && in_b > 0) worst = std::max(worst, std::abs(std::log(in_a / in_b)));
    }
    return worst;
}

double Growth::length(const TriangleMesh& mesh, const CombinatorialMap& map, Flag f) {
    return (mesh.vertices.row(map.input_vertex[static_cast<std::size_t>(map.origin(f))]) -
            mesh.vertices.row(map.input_vertex[static_cast<std::size_t>(map.origin(next(f)))]))
        .norm();
}

}  // namespace counterpart
