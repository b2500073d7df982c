// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/symmetry/choice.hpp"

#include "match/symmetry/component_assignment.hpp"
#include "match/symmetry/initial_alignments.hpp"
#include "match/symmetry/tuning.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace counterpart::symmetry {

using namespace isomorphism;

namespace {

using Members = std::vector<const Member*>;

bool is_shared(const ComponentClass& kind) { return !kind.source.empty() && !kind.target.empty(); }
bool is_single(const ComponentClass& kind) { return kind.source.size() == 1 && kind.target.size() == 1; }

Members with_parity(const std::vector<Member>& members, unsigned parity) {
    Members chosen;
    for (const Member& member : members)
        if (member.parity == parity) chosen.push_back(&member);
    return chosen;
}

double length_error(const PairGeometry& geometry, const ComponentPair& pair) {
    return geometry.edge_length_error(pair, exact_tuning.max_final_triangles);
}

class Chooser {
  public:
    Chooser(const MatchedMaps& maps, bool reversed)
        : maps_(maps), reversed_(reversed), geometry_(maps), traversal_(maps.source, maps.source) {
        for (const ComponentClass& kind : maps.classes)
            if (is_shared(kind)) shared_.push_back(&kind);
        // What leaves no choice fixes the alignment. Then single components, the largest first, because a
        // symmetric one is settled by its own shape; equal components last.
        std::stable_sort(
            shared_.begin(), shared_.end(), [&](const ComponentClass* a, const ComponentClass* b) {
                return n_choices(*a) != n_choices(*b) ? n_choices(*a) < n_choices(*b) : size(*a) > size(*b);
            });
    }

    Choice run(const Progress& progress) {
        const bool is_anchored = !shared_.empty() && n_choices(*shared_.front()) == 0;
        if (is_anchored || (shared_.size() == 1 && is_single(*shared_.front()))) return match_all(nullptr);

        Choice best = refined({});  // as the meshes lie
        const auto starts = initial_alignments(maps_, geometry_, traversal_, reversed_);
        for (std::size_t i = 0; i < starts.size() && !is_perfect(best); ++i) {
            report_progress(progress, static_cast<double>(i) / static_cast<double>(starts.size()));
            Choice other = refined(starts[i]);
            if (best.pairs.empty() || geometry_.is_better(other.fit, best.fit)) best = std::move(other);
        }
        return best;
    }

    /// The pair with its best automorphisms under its own alignment.
    std::vector<Images> automorphisms(const ComponentPair& pair, std::size_t count) {
        return best_automorphisms(maps_, geometry_, traversal_, pair, by_mirror(*pair.kind), {}, count);
    }
    const PairGeometry& geometry() const { return geometry_; }
    std::size_t order(const ComponentClass& kind) const { return group(kind).order(); }

  private:
    const AutomorphismGroup& group(const ComponentClass& kind) const {
        return maps_.groups[to_size(&kind - maps_.classes.data())];
    }
    static std::size_t size(const ComponentClass& kind) { return kind.source[0].from_representative.size(); }
    int n_choices(const ComponentClass& kind) const {
        return !is_single(kind) ? 2 : group(kind).order() > 1 ? 1 : 0;
    }
    bool by_mirror(const ComponentClass& kind) const { return reversed_ && !group(kind).mirror.empty(); }
    bool is_perfect(const Choice& choice) const {
        return choice.fit.edge_length_error <= geometry_.tolerance() &&
               choice.fit.rigid_error <= geometry_.tolerance();
    }

    // Matches and fits by turns, while that improves the fit.
    Choice refined(Alignment alignment) {
        Choice best;
        for (int round = 0; round < exact_tuning.max_rounds; ++round) {
            Choice choice = match_all(&alignment);
            measure(maps_, geometry_, reversed_, choice);
            if (round > 0 && !geometry_.is_better(choice.fit, best.fit)) break;
            best = std::move(choice);
            alignment = best.alignment;
            if (is_perfect(best)) break;
        }
        return best;
    }

    Choice match_all(const Alignment* start) {
        choice_ = {};
        anchors_.clear();
        for (const ComponentClass* kind : shared_) {
            if (!is_single(*kind)) {
                match_equal(*kind, start);
                continue;
            }
            ComponentPair pair{kind, &kind->source[0], &kind->target[0], {}};
            // What sits in something that is bent moves with what is around it.
            const Alignment around =
                order(*kind) > 1 && !anchors_.empty() ? fit_near(center_of(pair)) : Alignment{};
            choose_automorphism(pair, anchors_.empty() ? start : &around);
            const auto points = geometry_.points(pair, exact_tuning.max_anchors);
            anchors_.insert(anchors_.end(), points.begin(), points.end());
            choice_.pairs.push_back(std::move(pair));
        }
        return std::move(choice_);
    }

    Eigen::RowVector3d center_of(const ComponentPair& pair) const {
        return spread_of(geometry_.points(pair, exact_tuning.anchor_triangles), &PointPair::source).center;
    }

    void choose_automorphism(ComponentPair& pair, const Alignment* alignment) {
        const bool mirror = by_mirror(*pair.kind);
        if (order(*pair.kind) > 1) {
            auto best = best_automorphisms(maps_, geometry_, traversal_, pair, mirror,
                                           {alignment, !anchors_.empty()}, 2);
            pair.automorphism = std::move(best[1]);
            pair.other_length_error = length_error(geometry_, pair);
            pair.automorphism = std::move(best[0]);
        } else if (mirror)
            pair.automorphism = group(*pair.kind).mirror;
    }

    // Those that keep the orientation, or reverse it as they should; then what is left on both sides.
    void match_equal(const ComponentClass& kind, const Alignment* start) {
        const bool exchange = reversed_ && !by_mirror(kind) && !maps_.source.is_one_sided(kind.component);
        Members sources_left, targets_left, nothing;
        for (const unsigned parity : {0U, 1U})
            assign(kind, with_parity(kind.source, parity),
                   with_parity(kind.target, parity ^ (exchange ? 1U : 0U)), start, sources_left,
                   targets_left);
        assign(kind, sources_left, targets_left, start, nothing, nothing);
    }

    void assign(const ComponentClass& kind, const Members& sources, const Members& targets,
                const Alignment* start, Members& sources_left, Members& targets_left) {
        std::vector<Alignment> alignments;
        std::vector<Moments> from, to;
        for (const Member* source : sources) {
            const Spread spread = spread_of(
                geometry_.points({&kind, source, &kind.target[0], {}}, exact_tuning.anchor_triangles),
                &PointPair::source);
            // A deformed pose moves every part a little differently.
            const Alignment alignment =
                anchors_.empty() ? (start != nullptr ? *start : Alignment{}) : fit_near(spread.center);
            const Eigen::Matrix3d linear = alignment.linear();
            from.push_back(
                moments_of(alignment(spread.center), linear * spread.covariance * linear.transpose()));
            alignments.push_back(alignment);
        }
        for (const Member* target : targets) {
            const Spread spread = spread_of(
                geometry_.points({&kind, &kind.source[0], target, {}}, exact_tuning.anchor_triangles),
                &PointPair::target);
            to.push_back(moments_of(spread.center, spread.covariance));
        }
        std::vector<Index> chosen(sources.size(), -1);
        if (!sources.empty() && !targets.empty()) chosen = assign_components(from, to);
        std::vector<bool> taken(targets.size(), false);
        for (std::size_t i = 0; i < sources.size(); ++i) {
            if (chosen[i] < 0) {
                sources_left.push_back(sources[i]);
                continue;
            }
            taken[to_size(chosen[i])] = true;
            ComponentPair pair{&kind, sources[i], targets[to_size(chosen[i])], {}};
            choose_automorphism(pair, &alignments[i]);
            choice_.pairs.push_back(std::move(pair));
        }
        for (std::size_t j = 0; j < targets.size(); ++j)
            if (!taken[j]) targets_left.push_back(targets[j]);
    }

    // By the anchors nearest to it.
    Alignment fit_near(const Eigen::RowVector3d& point) const {
        std::vector<std::pair<double, std::size_t>> order;
        for (const std::size_t i : evenly_spread(anchors_.size(), exact_tuning.max_anchors))
            order.emplace_back((anchors_[i].source - point).squaredNorm(), i);
        const std::size_t n = std::min(order.size(), exact_tuning.near_anchors);
        std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(n), order.end());
        std::vector<PointPair> some;
        for (std::size_t k = 0; k < n; ++k) some.push_back(anchors_[order[k].second]);
        return fit_alignment_near(point, std::move(some), reversed_);
    }

    const MatchedMaps& maps_;
    bool reversed_;
    PairGeometry geometry_;
    isomorphism::SimultaneousTraversal traversal_;
    std::vector<const ComponentClass*> shared_;
    std::vector<PointPair> anchors_;
    Choice choice_;
};

}  // namespace

bool is_determined(const MatchedMaps& maps) {
    for (std::size_t k = 0; k < maps.classes.size(); ++k)
        if (!is_single(maps.classes[k]) || maps.groups[k].order() > 1) return false;
    return true;
}

void measure(const MatchedMaps& maps, const PairGeometry& geometry, bool reversed, Choice& choice) {
    constexpr std::size_t max_triangles = 10'000;
    const double total = maps.source.n_triangles();
    std::vector<PointPair> points;
    choice.fit = {};
    for (const ComponentPair& pair : choice.pairs) {
        const double share = static_cast<double>(pair.size()) / total;
        const auto n = static_cast<std::size_t>(1 + max_triangles * share);
        choice.fit.edge_length_error += share * geometry.edge_length_error(pair, n);
        const auto some = geometry.points(pair, n);
        points.insert(points.end(), some.begin(), some.end());
    }
    choice.alignment = fit_alignment(points, reversed);
    choice.fit.rigid_error = squared_error(choice.alignment, points);
    choice.fit.offset = squared_error({}, points);
}

Choice choose_isomorphism(const MatchedMaps& maps, bool reversed, const Progress& progress) {
    Choice choice;
    if (std::none_of(maps.classes.begin(), maps.classes.end(), is_shared)) return choice;
    if (!is_determined(maps)) return Chooser(maps, reversed).run(progress);
    for (std::size_t k = 0; k < maps.classes.size(); ++k) {
        const ComponentClass& kind = maps.classes[k];
        choice.pairs.push_back(
            {&kind, &kind.source[0], &kind.target[0], reversed ? maps.groups[k].mirror : Images{}});
    }
    return choice;
}

std::vector<Choice> other_choices(const MatchedMaps& maps, const Choice& choice, bool reversed,
                                  std::size_t max) {
    Chooser chooser(maps, reversed);
    std::vector<Choice> others;
    const auto add = [&](Choice other) {
        measure(maps, chooser.geometry(), reversed, other);
        others.push_back(std::move(other));
        return others.size() < max;
    };
    const auto with_turns = [&] {
        for (std::size_t p = 0; p < choice.pairs.size(); ++p) {
            const ComponentPair& pair = choice.pairs[p];
            if (chooser.order(*pair.kind) == 1) continue;
            for (Images& images : chooser.automorphisms(pair, max + 1)) {
                if (images == pair.automorphism) continue;
                Choice other = choice;
                other.pairs[p].automorphism = std::move(images);
                if (!add(std::move(other))) return false;
            }
        }
        return true;
    };
    const auto with_exchanges = [&] {
        for (std::size_t p = 0; p < choice.pairs.size(); ++p) {
            for (std::size_t q = p + 1; q < choice.pairs.size(); ++q) {
                const ComponentPair &a = choice.pairs[p], &b = choice.pairs[q];
                if (a.kind != b.kind || a.source->parity != b.source->parity ||
                    a.target->parity != b.target->parity)
                    continue;
                Choice other = choice;
                std::swap(other.pairs[p].target, other.pairs[q].target);
                for (const std::size_t i : {p, q})
                    if (chooser.order(*a.kind) > 1)
                        other.pairs[i].automorphism = chooser.automorphisms(other.pairs[i], 1)[0];
                if (!add(std::move(other))) return;
            }
        }
    };
    if (max > 0 && with_turns()) with_exchanges();
    std::stable_sort(others.begin(), others.end(), [](const Choice& a, const Choice& b) {
        return a.fit.edge_length_error + a.fit.rigid_error < b.fit.edge_length_error + b.fit.rigid_error;
    });
    return others;
}

std::vector<std::size_t> decided_by_place(const MatchedMaps& maps, const Choice& choice, bool reversed) {
    if (is_determined(maps)) return {};
    Chooser chooser(maps, reversed);
    const PairGeometry& geometry = chooser.geometry();
    const auto other_partner = [&](ComponentPair pair) {
        const std::vector<Member>& members = pair.kind->target;
        if (members.size() == 1) return std::numeric_limits<double>::infinity();
        const auto next = to_size(pair.target - members.data() + 1) % members.size();
        pair.target = &members[next];
        if (chooser.order(*pair.kind) > 1) pair.automorphism = chooser.automorphisms(pair, 1)[0];
        return length_error(geometry, pair);
    };
    std::vector<std::size_t> result;
    for (std::size_t p = 0; p < choice.pairs.size(); ++p) {
        const ComponentPair& pair = choice.pairs[p];
        const double limit = exact_tuning.clear * length_error(geometry, pair) + geometry.tolerance();
        if (pair.other_length_error <= limit || other_partner(pair) <= limit) result.push_back(p);
    }
    return result;
}

}  // namespace counterpart::symmetry
