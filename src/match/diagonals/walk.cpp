// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/diagonals/walk.hpp"

#include <algorithm>
#include <cmath>

namespace counterpart::diagonals {

using namespace isomorphism;

Walk::Walk(const Side& source, const Side& target)
    : a_(source),
      b_(target),
      image_(to_size(source.map.n_vertices()), -1),
      origin_(to_size(target.map.n_vertices()), -1),
      done_a_(to_size(source.map.n_triangles()), 0),
      done_b_(to_size(target.map.n_triangles()), 0) {}

WalkEnd Walk::run(Dart f, Dart g, std::size_t max_steps) {
    for (std::deque<Item>& items : waiting_) items.clear();
    paired_.clear();
    triangles_.clear();
    quads_.clear();
    sum_of_mismatches_ = 0;
    n_steps_ = 0;
    bool agree =
        pair(a_.map.origin(f), b_.map.origin(g)) && pair(a_.map.origin(next(f)), b_.map.origin(next(g)));
    agree = agree && enter(f, g) && enter(a_.map.across(f), b_.map.across(g));
    while (agree && n_steps_ < max_steps) {
        const auto items = std::find_if(waiting_.begin(), waiting_.end(), [](auto& d) { return !d.empty(); });
        if (items == waiting_.end()) break;
        const Item item = items->front();
        items->pop_front();
        const bool done = done_a_[to_size(triangle_of(item.f))] != 0;
        if (done != (done_b_[to_size(triangle_of(item.g))] != 0)) agree = false;
        if (done || !agree) continue;
        const Decision decision = decide(item);
        ++n_steps_;
        if (decision.doubt > 2)
            agree = false;
        else if (decision.doubt > to_size(items - waiting_.begin()))
            waiting_[decision.doubt].push_back(item);
        else
            agree = step(item, decision.cell);
    }
    total_steps_ += n_steps_;
    if (!agree) return WalkEnd::contradiction;
    const bool is_open = std::any_of(waiting_.begin(), waiting_.end(), [](auto& d) { return !d.empty(); });
    return is_open ? WalkEnd::out_of_steps : WalkEnd::complete;
}

void Walk::take_back() {
    for (const Index v : paired_) {
        origin_[to_size(image_[to_size(v)])] = -1;
        image_[to_size(v)] = -1;
    }
    for (const auto& [t, u] : triangles_) done_a_[to_size(t)] = done_b_[to_size(u)] = 0;
    paired_.clear();
    triangles_.clear();
    quads_.clear();
}

double Walk::mean_mismatch() const {
    return n_steps_ == 0 ? 0 : sum_of_mismatches_ / static_cast<double>(n_steps_);
}

double Walk::mean_squared_offset() const {
    double sum = 0;
    for (const Index v : paired_) sum += (a_.at(v) - b_.at(image_[to_size(v)])).squaredNorm();
    return paired_.empty() ? 0 : sum / static_cast<double>(paired_.size());
}

std::vector<CutQuad> Walk::take_quads() { return std::move(quads_); }

Walk::Decision Walk::decide(Item item) const {
    const Index u = a_.map.origin(item.f), v = a_.map.origin(next(item.f)), w = a_.map.apex(item.f);
    const Index x = b_.map.apex(item.g);
    std::array<Cell, 3> cells;
    std::size_t n = 0;
    if (fits(w, x)) {
        const Index u_image = image_[to_size(u)], v_image = image_[to_size(v)];
        cells[n++].mismatch = (mismatch(u, w, u_image, x) + mismatch(v, w, v_image, x)) / 2;
    }
    propose_quads(item, cells, n);
    if (n == 0) return {};
    std::sort(cells.begin(), cells.begin() + static_cast<std::ptrdiff_t>(n),
              [](const Cell& p, const Cell& q) { return p.mismatch < q.mismatch; });
    constexpr double clear = 9;  // squared: lengths that fit three times as well as any other
    constexpr double rounding = 1e-20;
    const std::size_t doubt = n == 1 ? 0 : cells[1].mismatch > clear * cells[0].mismatch + rounding ? 1 : 2;
    return {cells[0], doubt};
}

// The source's quad u v . w or u v w . and the target's are cut crosswise, so the apex here is the far corner
// there.
void Walk::propose_quads(Item item, std::array<Cell, 3>& cells, std::size_t& n) const {
    const Index u = a_.map.origin(item.f), v = a_.map.origin(next(item.f)), w = a_.map.apex(item.f);
    const Index x = b_.map.apex(item.g), u_image = image_[to_size(u)], v_image = image_[to_size(v)];
    const auto may_cut = [](const Side& side, Dart f) {
        return !side.may_cut.empty() && side.may_cut[halfedge_of(f)] != 0;
    };
    for (const Dart side : {1U, 2U}) {
        const Dart cut_f = next(item.f, side), cut_g = next(item.g, 3 - side);
        const Dart behind_f = a_.map.across(cut_f), behind_g = b_.map.across(cut_g);
        if (behind_f == no_dart || behind_g == no_dart || !(may_cut(a_, cut_f) || may_cut(b_, cut_g)))
            continue;
        const Index p = a_.map.apex(behind_f), q = b_.map.apex(behind_g);
        if (done_a_[to_size(triangle_of(behind_f))] != 0 || done_b_[to_size(triangle_of(behind_g))] != 0 ||
            triangle_of(behind_f) == triangle_of(item.f) || triangle_of(behind_g) == triangle_of(item.g) ||
            w == p || x == q || !fits(w, q) || !fits(p, x))
            continue;
        const double sum = mismatch(u, w, u_image, q) + mismatch(v, w, v_image, q) +
                           mismatch(u, p, u_image, x) + mismatch(v, p, v_image, x) + mismatch(p, w, x, q);
        cells[n++] = {behind_f, behind_g, side, sum / 5};
    }
}

bool Walk::step(Item item, const Cell& cell) {
    sum_of_mismatches_ += cell.mismatch;
    mark(triangle_of(item.f), triangle_of(item.g));
    const Index w = a_.map.apex(item.f), x = b_.map.apex(item.g);
    const auto cross = [&](Dart f, Dart g) { return enter(a_.map.across(f), b_.map.across(g)); };
    if (cell.behind_f == no_dart)
        return pair(w, x) && cross(next(item.f, 1), next(item.g, 1)) &&
               cross(next(item.f, 2), next(item.g, 2));
    mark(triangle_of(cell.behind_f), triangle_of(cell.behind_g));
    quads_.push_back({{triangle_of(item.f), triangle_of(cell.behind_f)},
                      {triangle_of(item.g), triangle_of(cell.behind_g)}});
    if (!pair(w, b_.map.apex(cell.behind_g)) || !pair(a_.map.apex(cell.behind_f), x)) return false;
    // The three sides of the quad other than f, on each side in its halves.
    const Dart f = cell.behind_f, g = cell.behind_g;
    return cell.side == 1 ? cross(next(f, 1), next(item.g, 1)) && cross(next(f, 2), next(g, 1)) &&
                                cross(next(item.f, 2), next(g, 2))
                          : cross(next(item.f, 1), next(g, 1)) && cross(next(f, 1), next(g, 2)) &&
                                cross(next(f, 2), next(item.g, 2));
}

// What lies behind two edges waits for its turn; a border must be one on both sides.
bool Walk::enter(Dart f, Dart g) {
    if (f == no_dart || g == no_dart) return f == g;
    const bool done = done_a_[to_size(triangle_of(f))] != 0;
    if (done != (done_b_[to_size(triangle_of(g))] != 0)) return false;
    if (done) return true;
    const std::size_t doubt = decide({f, g}).doubt;
    if (doubt > 2) return false;
    waiting_[doubt].push_back({f, g});
    return true;
}

bool Walk::fits(Index v, Index w) const {
    return image_[to_size(v)] < 0 ? origin_[to_size(w)] < 0 : image_[to_size(v)] == w;
}

bool Walk::pair(Index v, Index w) {
    if (!fits(v, w)) return false;
    if (image_[to_size(v)] < 0) {
        image_[to_size(v)] = w;
        origin_[to_size(w)] = v;
        paired_.push_back(v);
    }
    return true;
}

void Walk::mark(Index t, Index u) {
    done_a_[to_size(t)] = done_b_[to_size(u)] = 1;
    triangles_.push_back({t, u});
}

double Walk::mismatch(Index a, Index b, Index image_a, Index image_b) const {
    const double ours = (a_.at(a) - a_.at(b)).norm() / a_.scale,
                 theirs = (b_.at(image_a) - b_.at(image_b)).norm() / b_.scale;
    const double relative = ours + theirs > 0 ? (ours - theirs) / (ours + theirs) : 0;
    return relative * relative;
}

}  // namespace counterpart::diagonals
