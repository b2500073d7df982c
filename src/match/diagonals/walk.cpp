// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/diagonals/walk.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace counterpart::diagonals {

using namespace isomorphism;

namespace {

Cut cut_at(const Side& side, Dart f) {
    return side.may_cut.empty() ? Cut::none : side.may_cut[halfedge_of(f)];
}

// What a quad of an unlikely shape adds to its mismatch, as if lengths differed by a fifth more.
constexpr double unlikely_mismatch = 0.05;

void add(std::vector<Index>& steps, Index step) {
    const auto place = std::lower_bound(steps.begin(), steps.end(), step);
    if (place == steps.end() || *place != step) steps.insert(place, step);
}

}  // namespace

Walk::Walk(const Side& source, const Side& target)
    : a_(source),
      b_(target),
      image_(to_size(source.map.n_vertices()), -1),
      origin_(to_size(target.map.n_vertices()), -1),
      paired_by_(image_),
      done_a_(to_size(source.map.n_triangles()), -1),
      done_b_(to_size(target.map.n_triangles()), -1),
      item_at_a_(source.map.corner.size(), -1),
      item_at_b_(target.map.corner.size(), -1) {}

WalkEnd Walk::run(Dart f, Dart g, std::size_t max_steps) {
    take_back();
    steps_.emplace_back();  // the start: nothing goes back behind it
    if (!fits(a_.map.origin(f), b_.map.origin(g))) return WalkEnd::contradiction;
    pair(a_.map.origin(f), b_.map.origin(g));
    if (!fits(a_.map.origin(next(f)), b_.map.origin(next(g)))) return WalkEnd::contradiction;
    pair(a_.map.origin(next(f)), b_.map.origin(next(g)));
    open(f, g);
    open(a_.map.across(f), b_.map.across(g));
    // Of a few steps from very many starts, or of many from few.
    const std::size_t max_tries = max_steps < 100 ? 2 * max_steps + 16 : 8 * max_steps;
    for (std::size_t n_tries = 0; n_tries < max_tries && steps_.size() <= max_steps; ++n_tries) {
        const bool is_complete =
            std::all_of(waiting_.begin(), waiting_.end(), [](const auto& items) { return items.empty(); });
        if (is_complete) return WalkEnd::complete;
        if (!advance()) return WalkEnd::contradiction;
    }
    return WalkEnd::out_of_steps;
}

void Walk::take_back() {
    while (!steps_.empty()) {
        undo_last();
        steps_.pop_back();
    }
    for (auto& items : waiting_) items.clear();
}

double Walk::mean_mismatch() const {
    double sum = 0;
    for (const Step& step : steps_)
        if (step.cells.count > 0) sum += step.cells.cell[step.chosen].mismatch;
    return steps_.size() < 2 ? 0 : sum / static_cast<double>(steps_.size() - 1);
}

double Walk::mean_squared_offset() const {
    double sum = 0;
    for (const Index v : paired_) sum += (a_.at(v) - b_.at(image_[to_size(v)])).squaredNorm();
    return paired_.empty() ? 0 : sum / static_cast<double>(paired_.size());
}

std::vector<CutQuad> Walk::take_quads() {
    std::vector<CutQuad> quads;
    for (const Step& step : steps_) {
        if (step.cells.count == 0) continue;
        const Cell& cell = step.cells.cell[step.chosen];
        const Item& item = items_[step.item];
        if (cell.behind_f != no_dart)
            quads.push_back({{triangle_of(item.f), triangle_of(cell.behind_f)},
                             {triangle_of(item.g), triangle_of(cell.behind_g)}});
    }
    // What this run paired stays, as if it had been so from the start.
    steps_.clear();
    items_.clear();
    paired_.clear();
    triangles_.clear();
    return quads;
}

// The clearest of what waits; false where it contradicts what cannot be changed.
bool Walk::advance() {
    const auto items = std::find_if(waiting_.begin(), waiting_.end(), [](auto& d) { return !d.empty(); });
    const std::size_t place = items->front();
    items->pop_front();
    const auto doubt = static_cast<std::size_t>(items - waiting_.begin());
    if (place >= items_.size() || !items_[place].is_open || items_[place].doubt != doubt) return true;
    const Item& item = items_[place];
    Steps reasons;
    if (contradicts(item, reasons)) return go_back(std::move(reasons));
    if (item.f == no_dart || done_a_[to_size(triangle_of(item.f))] >= 0) return true;
    const Cells cells = possible(item);
    if (cells.count == 0) {
        explain(item, now() + 1, reasons);
        return go_back(std::move(reasons));
    }
    if (cells.doubt() > doubt)
        wait(place);
    else
        take(place, cells);
    return true;
}

// To the last step that can be changed of those that a contradiction follows from.
bool Walk::go_back(Steps reasons) {
    while (!reasons.empty() && reasons.back() > 0) {
        const Index last = reasons.back();
        reasons.pop_back();
        while (now() > last) {
            undo_last();
            steps_.pop_back();
        }
        undo_last();
        Step& step = steps_.back();
        for (const Index reason : step.reasons) add(reasons, reason);
        if (step.chosen + 1 < step.cells.count) {
            step.reasons = std::move(reasons);
            ++step.chosen;
            apply(step);
            return true;
        }
        explain(items_[step.item], last, reasons);
        const std::size_t item = step.item;
        steps_.pop_back();
        wait(item);
    }
    return false;
}

void Walk::take(std::size_t item, Cells cells) {
    steps_.push_back({item, cells, 0, {}, items_.size(), paired_.size(), triangles_.size()});
    apply(steps_.back());
}

void Walk::apply(Step& step) {
    const Item item = items_[step.item];
    const Cell cell = step.cells.cell[step.chosen];
    items_[step.item].is_open = false;
    mark(triangle_of(item.f), triangle_of(item.g));
    const Index w = a_.map.apex(item.f), x = b_.map.apex(item.g);
    const auto cross = [&](Dart f, Dart g) { open(a_.map.across(f), b_.map.across(g)); };
    if (cell.behind_f == no_dart) {
        pair(w, x);
        cross(next(item.f, 1), next(item.g, 1));
        cross(next(item.f, 2), next(item.g, 2));
        return;
    }
    mark(triangle_of(cell.behind_f), triangle_of(cell.behind_g));
    pair(w, b_.map.apex(cell.behind_g));
    pair(a_.map.apex(cell.behind_f), x);
    // The three sides of the quad other than f, on each side in its halves.
    const Dart f = cell.behind_f, g = cell.behind_g;
    if (cell.side == 1) {
        cross(next(f, 1), next(item.g, 1));
        cross(next(f, 2), next(g, 1));
        cross(next(item.f, 2), next(g, 2));
    } else {
        cross(next(item.f, 1), next(g, 1));
        cross(next(f, 1), next(g, 2));
        cross(next(f, 2), next(item.g, 2));
    }
}

// The step stays, without its effects.
void Walk::undo_last() {
    const Step& step = steps_.back();
    for (; paired_.size() > step.n_paired; paired_.pop_back()) {
        Index& image = image_[to_size(paired_.back())];
        origin_[to_size(image)] = -1;
        image = -1;
    }
    for (; triangles_.size() > step.n_triangles; triangles_.pop_back()) {
        done_a_[to_size(triangles_.back()[0])] = -1;
        done_b_[to_size(triangles_.back()[1])] = -1;
    }
    for (; items_.size() > step.n_items; items_.pop_back()) {
        if (items_.back().f != no_dart) item_at_a_[halfedge_of(items_.back().f)] = -1;
        if (items_.back().g != no_dart) item_at_b_[halfedge_of(items_.back().g)] = -1;
    }
    if (step.cells.count > 0) items_[step.item].is_open = true;
}

// What lies behind two edges waits for its turn.
void Walk::open(Dart f, Dart g) {
    if (f == no_dart && g == no_dart) return;
    if (f != no_dart) item_at_a_[halfedge_of(f)] = static_cast<Index>(items_.size());
    if (g != no_dart) item_at_b_[halfedge_of(g)] = static_cast<Index>(items_.size());
    items_.push_back({f, g, now()});
    wait(items_.size() - 1);
}

void Walk::wait(std::size_t place) {
    Item& item = items_[place];
    Steps unused;
    const bool is_known = item.f == no_dart || item.g == no_dart ||
                          done_a_[to_size(triangle_of(item.f))] >= 0 ||
                          done_b_[to_size(triangle_of(item.g))] >= 0;
    item.doubt = is_known ? 0 : possible(item).doubt();
    waiting_[item.doubt].push_back(place);
}

// A new pair may decide what waits around it.
void Walk::look_again(Index v, Index w) {
    const auto around = [&](const Side& side, Index vertex, const std::vector<Index>& item_at) {
        const auto in_triangle = [&](Index t) {
            for (int c = 0; c < 3; ++c) {
                const Index place = item_at[halfedge_of(make_dart(t, c))];
                if (place < 0 || !items_[to_size(place)].is_open || items_[to_size(place)].doubt == 0)
                    continue;
                const std::size_t doubt = possible(items_[to_size(place)]).doubt();
                if (doubt >= items_[to_size(place)].doubt) continue;
                items_[to_size(place)].doubt = doubt;
                waiting_[doubt].push_back(to_size(place));
            }
        };
        for (const Dart corner : side.corners_at(vertex)) {
            in_triangle(triangle_of(corner));
            const Dart opposite = side.map.across(next(corner));
            if (opposite != no_dart) in_triangle(triangle_of(opposite));
        }
    };
    around(a_, v, item_at_a_);
    around(b_, w, item_at_b_);
}

std::size_t Walk::Cells::doubt() const {
    if (count < 2) return 0;
    // Of squared lengths: how many times as well the best must fit as any other.
    constexpr std::array<double, n_doubts - 2> clear{81, 9, 4, 1.5};
    constexpr double rounding = 1e-20;
    const auto first = std::find_if(clear.begin(), clear.end(), [&](double factor) {
        return cell[1].mismatch > factor * cell[0].mismatch + rounding;
    });
    return 1 + static_cast<std::size_t>(first - clear.begin());
}

Walk::Cells Walk::possible(const Item& item) const {
    const Index u = a_.map.origin(item.f), v = a_.map.origin(next(item.f)), w = a_.map.apex(item.f);
    const Index x = b_.map.apex(item.g);
    Cells cells;
    if (fits(w, x)) {
        const Index u_image = image_[to_size(u)], v_image = image_[to_size(v)];
        cells.cell[cells.count++].mismatch = (mismatch(u, w, u_image, x) + mismatch(v, w, v_image, x)) / 2;
    }
    propose_quads(item, cells);
    std::sort(cells.cell.begin(), cells.cell.begin() + static_cast<std::ptrdiff_t>(cells.count),
              [](const Cell& p, const Cell& q) { return p.mismatch < q.mismatch; });
    return cells;
}

// Whether the connectivity allows a quad with the diagonal on that side, whatever is known of its vertices.
bool Walk::may_be_quad(const Item& item, Dart side, Cell& cell) const {
    const Dart cut_f = next(item.f, side), cut_g = next(item.g, 3 - side);
    cell = {a_.map.across(cut_f), b_.map.across(cut_g), side, 0};
    return cell.behind_f != no_dart && cell.behind_g != no_dart &&
           std::max(cut_at(a_, cut_f), cut_at(b_, cut_g)) != Cut::none &&
           triangle_of(cell.behind_f) != triangle_of(item.f) &&
           triangle_of(cell.behind_g) != triangle_of(item.g) &&
           a_.map.apex(item.f) != a_.map.apex(cell.behind_f) &&
           b_.map.apex(item.g) != b_.map.apex(cell.behind_g);
}

// The source's quad u v . w or u v w . and the target's are cut crosswise, so the apex here is the far corner
// there.
void Walk::propose_quads(const Item& item, Cells& cells) const {
    const Index u = a_.map.origin(item.f), v = a_.map.origin(next(item.f)), w = a_.map.apex(item.f);
    const Index x = b_.map.apex(item.g), u_image = image_[to_size(u)], v_image = image_[to_size(v)];
    for (const Dart side : {1U, 2U}) {
        Cell cell;
        if (!may_be_quad(item, side, cell)) continue;
        const Index p = a_.map.apex(cell.behind_f), q = b_.map.apex(cell.behind_g);
        if (done_a_[to_size(triangle_of(cell.behind_f))] >= 0 ||
            done_b_[to_size(triangle_of(cell.behind_g))] >= 0 || !fits(w, q) || !fits(p, x))
            continue;
        const double sum = mismatch(u, w, u_image, q) + mismatch(v, w, v_image, q) +
                           mismatch(u, p, u_image, x) + mismatch(v, p, v_image, x) + mismatch(p, w, x, q);
        const Cut cut = std::max(cut_at(a_, next(item.f, side)), cut_at(b_, next(item.g, 3 - side)));
        cell.mismatch = sum / 5 + (cut == Cut::unlikely ? unlikely_mismatch : 0);
        cells.cell[cells.count++] = cell;
    }
}

// A border must be one on both sides, and triangles are paired with each other only.
bool Walk::contradicts(const Item& item, Steps& reasons) const {
    if (item.f == no_dart || item.g == no_dart) {
        add(reasons, item.opened);
        return true;
    }
    const Index f_by = done_a_[to_size(triangle_of(item.f))], g_by = done_b_[to_size(triangle_of(item.g))];
    if (f_by == g_by) return false;
    for (const Index step : {item.opened, f_by, g_by})
        if (step >= 0) add(reasons, step);
    return true;
}

// The steps before `before` that leave an item the cells that it has, or none.
void Walk::explain(const Item& item, Index before, Steps& reasons) const {
    add(reasons, item.opened);
    const Index w = a_.map.apex(item.f), x = b_.map.apex(item.g);
    explain_pair(w, x, before, reasons);
    for (const Dart side : {1U, 2U}) {
        Cell cell;
        if (!may_be_quad(item, side, cell)) continue;
        for (const Index by :
             {done_a_[to_size(triangle_of(cell.behind_f))], done_b_[to_size(triangle_of(cell.behind_g))]})
            if (by >= 0 && by < before) add(reasons, by);
        explain_pair(w, b_.map.apex(cell.behind_g), before, reasons);
        explain_pair(a_.map.apex(cell.behind_f), x, before, reasons);
    }
}

void Walk::explain_pair(Index v, Index w, Index before, Steps& reasons) const {
    if (image_[to_size(v)] == w) return;
    for (const Index paired : {image_[to_size(v)] >= 0 ? v : -1, origin_[to_size(w)]})
        if (paired >= 0 && paired_by_[to_size(paired)] < before) add(reasons, paired_by_[to_size(paired)]);
}

bool Walk::fits(Index v, Index w) const {
    return image_[to_size(v)] < 0 ? origin_[to_size(w)] < 0 : image_[to_size(v)] == w;
}

void Walk::pair(Index v, Index w) {
    if (image_[to_size(v)] >= 0) return;
    image_[to_size(v)] = w;
    origin_[to_size(w)] = v;
    paired_by_[to_size(v)] = now();
    paired_.push_back(v);
    look_again(v, w);
}

void Walk::mark(Index t, Index u) {
    done_a_[to_size(t)] = done_b_[to_size(u)] = now();
    triangles_.push_back({t, u});
}

double Walk::mismatch(Index a, Index b, Index image_a, Index image_b) const {
    const double ours = (a_.at(a) - a_.at(b)).norm() / a_.scale,
                 theirs = (b_.at(image_a) - b_.at(image_b)).norm() / b_.scale;
    const double relative = ours + theirs > 0 ? (ours - theirs) / (ours + theirs) : 0;
    return relative * relative;
}

}  // namespace counterpart::diagonals
