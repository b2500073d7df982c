// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/exact/island_pairing.hpp"

#include "match/exact/anchoring.hpp"
#include "match/exact/island_assignment.hpp"
#include "match/exact/symmetry_choice.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace counterpart {
namespace {

using Members = std::vector<const Member*>;

Members with_parity(const std::vector<Member>& members, unsigned parity) {
    Members chosen;
    for (const Member& member : members)
        if (member.parity == parity) chosen.push_back(&member);
    return chosen;
}

class Pairer {
  public:
    /// `start`: the motion to assume until islands have fixed it; null: none is known.
    Pairer(const MatchedMaps& maps, const PairGeometry& geometry, bool turned, const Motion* start)
        : maps_(maps),
          turned_(turned),
          determined_(is_determined(maps)),
          geometry_(geometry),
          start_(start) {}

    Pairing run() {
        // What leaves no choice comes first: it anchors the rest. Then single islands, the largest first,
        // because a symmetric one is settled by its own shape; groups of equal islands last.
        std::vector<std::size_t> order;
        for (std::size_t k = 0; k < maps_.classes.size(); ++k)
            if (!maps_.classes[k].source.empty() && !maps_.classes[k].target.empty()) order.push_back(k);
        const auto rank = [&](std::size_t k) {
            const IslandClass& kind = maps_.classes[k];
            const bool single = kind.source.size() == 1 && kind.target.size() == 1;
            return single ? (maps_.groups[k].order() == 1 ? 0 : 1) : 2;
        };
        std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
            return rank(a) != rank(b) ? rank(a) < rank(b) : size(a) > size(b);
        });
        for (const std::size_t k : order) {
            if (rank(k) == 2)
                pair_group(k);
            else
                pair_single(k);
        }
        return std::move(result_);
    }

  private:
    std::size_t size(std::size_t k) const {
        const IslandClass& kind = maps_.classes[k];
        return (kind.in_target ? kind.target : kind.source)[0].from_representative.size();
    }
    bool by_mirror(std::size_t k) const { return turned_ && !maps_.groups[k].mirror.empty(); }

    void add(IslandPair pair, bool anchors) {
        if (anchors && !determined_) {
            const auto points = geometry_.points(pair, 200);
            anchors_.insert(anchors_.end(), points.begin(), points.end());
        }
        result_.pairs.push_back(std::move(pair));
    }

    void pair_single(std::size_t k) {
        const IslandClass& kind = maps_.classes[k];
        const AutomorphismGroup& group = maps_.groups[k];
        IslandPair pair{&kind, &kind.source[0], &kind.target[0], {}};
        if (group.order() == 1) {
            if (by_mirror(k)) pair.automorphism = group.mirror;
        } else {
            const Motion fitted = fit_similarity(anchors_, turned_);
            pair.automorphism = std::move(rank_automorphisms(maps_, group, geometry_, pair, by_mirror(k),
                                                             anchors_.empty() ? start_ : &fitted, 1)[0]);
        }
        add(std::move(pair), true);
    }

    void pair_group(std::size_t k) {
        const IslandClass& kind = maps_.classes[k];
        const bool exchange = turned_ && !by_mirror(k) && !maps_.source.is_one_sided(kind.island);
        Members source_left, target_left;
        for (unsigned parity = 0; parity < 2; ++parity)
            assign(k, with_parity(kind.source, parity),
                   with_parity(kind.target, parity ^ (exchange ? 1U : 0U)), by_mirror(k), source_left,
                   target_left);
        Members nothing;
        if (!source_left.empty() && !target_left.empty())
            assign(k, std::move(source_left), std::move(target_left), by_mirror(k), nothing, nothing);
    }

    // The mean of an island's corners.
    static Eigen::RowVector3d center(const std::vector<PointPair>& points, bool target) {
        Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
        for (const PointPair& point : points) sum += target ? point.target : point.source;
        return sum / static_cast<double>(points.size());
    }

    // The motion near a point of the source: a deformed pose moves every part a little differently.
    Motion similarity_near(const Eigen::RowVector3d& point) const {
        std::vector<PointPair> pairs;
        const std::size_t step = std::max<std::size_t>(1, anchors_.size() / 1024);
        double extent = 0;
        for (std::size_t i = 0; i < anchors_.size(); i += step) {
            pairs.push_back(anchors_[i]);
            extent = std::max(extent, (anchors_[i].source - point).squaredNorm());
        }
        for (PointPair& pair : pairs) {
            const double falloff = (pair.source - point).squaredNorm() + 1e-3 * extent;
            pair.weight = 1 / (falloff * falloff);
        }
        return fit_similarity(pairs, turned_);
    }

    void assign(std::size_t k, Members sources, Members targets, bool mirror, Members& source_left,
                Members& target_left) {
        const IslandClass& kind = maps_.classes[k];
        const std::size_t n = sources.size(), m = targets.size();
        if (n == 0 || m == 0) {
            source_left.insert(source_left.end(), sources.begin(), sources.end());
            target_left.insert(target_left.end(), targets.begin(), targets.end());
            return;
        }
        Points from(static_cast<Eigen::Index>(n), 3), to(static_cast<Eigen::Index>(m), 3);
        for (std::size_t i = 0; i < n; ++i)
            from.row(static_cast<Eigen::Index>(i)) =
                center(geometry_.points({&kind, sources[i], targets[0], {}}, 64), false);
        for (std::size_t j = 0; j < m; ++j)
            to.row(static_cast<Eigen::Index>(j)) =
                center(geometry_.points({&kind, sources[0], targets[j], {}}, 64), true);
        std::vector<Motion> motion(n);
        if (anchors_.empty())
            std::fill(motion.begin(), motion.end(), start_ != nullptr ? *start_ : align_centers(from, to));
        Points expected = from;
        for (std::size_t i = 0; i < n; ++i) {
            const auto row = static_cast<Eigen::Index>(i);
            if (!anchors_.empty()) motion[i] = similarity_near(from.row(row));
            expected.row(row) = motion[i](from.row(row));
        }
        const std::vector<Images> elements = few_elements(k, mirror);
        const auto cost = [&](Index i, Index j) {
            if (elements.empty()) return (expected.row(i) - to.row(j)).squaredNorm();
            return best_element(k, *sources[static_cast<std::size_t>(i)],
                                *targets[static_cast<std::size_t>(j)], elements,
                                motion[static_cast<std::size_t>(i)])
                .first;
        };
        const std::vector<Index> chosen = assign_islands(expected, to, cost);

        std::vector<bool> taken(m, false);
        for (std::size_t i = 0; i < n; ++i) {
            if (chosen[i] < 0) {
                source_left.push_back(sources[i]);
                continue;
            }
            const auto j = static_cast<std::size_t>(chosen[i]);
            taken[j] = true;
            IslandPair pair{&kind, sources[i], targets[j], {}};
            pair.automorphism =
                elements.empty()
                    ? rank_automorphisms(maps_, maps_.groups[k], geometry_, pair, mirror, &motion[i], 1)[0]
                    : elements[best_element(k, *sources[i], *targets[j], elements, motion[i]).second];
            add(std::move(pair), false);
        }
        for (std::size_t j = 0; j < m; ++j)
            if (!taken[j]) target_left.push_back(targets[j]);
    }

    // All automorphisms written out, if they are few and small; else none.
    std::vector<Images> few_elements(std::size_t k, bool mirror) const {
        const AutomorphismGroup& group = maps_.groups[k];
        const IslandClass& kind = maps_.classes[k];
        const Index first = maps_.source.island_begin[static_cast<std::size_t>(kind.island)];
        std::vector<Images> elements;
        if (group.order() > 1 && group.order() * size(k) > (1U << 16U)) return elements;
        for (std::size_t e = 0; e < group.order(); ++e) {
            if (e == 0) {
                Images images = mirror ? group.mirror : Images(size(k));
                for (std::size_t t = 0; !mirror && t < images.size(); ++t)
                    images[t] = make_flag(first + static_cast<Index>(t), 0);
                elements.push_back(std::move(images));
                continue;
            }
            Images images = elements[group.parent[e]];
            for (Flag& f : images) f = image_of(group.generators[group.generator[e]], first, f);
            elements.push_back(std::move(images));
        }
        return elements;
    }

    std::pair<double, std::size_t> best_element(std::size_t k, const Member& source, const Member& target,
                                                const std::vector<Images>& elements,
                                                const Motion& motion) const {
        std::pair<double, std::size_t> best{std::numeric_limits<double>::infinity(), 0};
        const Index first = maps_.source.island_begin[static_cast<std::size_t>(maps_.classes[k].island)];
        const std::size_t step = std::max<std::size_t>(1, size(k) / 64);
        std::vector<PointPair> points;
        for (std::size_t e = 0; e < elements.size(); ++e) {
            points.clear();
            double lengths = 0;
            for (std::size_t t = 0; t < size(k); t += step) {
                const Flag f = source.from_representative[t],
                           g = image_of(target.from_representative, first, elements[e][t]);
                geometry_.add_points(f, g, points);
                lengths += geometry_.triangle_disagreement(f, g);
            }
            const double cost = residual(motion, points) + 3 * lengths / static_cast<double>(points.size());
            if (cost < best.first) best = {cost, e};
        }
        return best;
    }

    const MatchedMaps& maps_;
    bool turned_, determined_;
    const PairGeometry& geometry_;
    const Motion* start_;
    std::vector<PointPair> anchors_;
    Pairing result_;
};

// Whether some island leaves no choice: it shows where the others belong.
bool has_anchor(const MatchedMaps& maps) {
    for (std::size_t k = 0; k < maps.classes.size(); ++k)
        if (maps.classes[k].source.size() == 1 && maps.classes[k].target.size() == 1 &&
            maps.groups[k].order() == 1)
            return true;
    return false;
}

}  // namespace

bool is_determined(const MatchedMaps& maps) {
    for (std::size_t k = 0; k < maps.classes.size(); ++k) {
        const IslandClass& kind = maps.classes[k];
        if (kind.source.size() > 1 || kind.target.size() > 1 || maps.groups[k].order() > 1) return false;
    }
    return true;
}

void measure(const MatchedMaps& maps, bool turned, Pairing& pairing) {
    const PairGeometry geometry(maps, true);
    std::vector<PointPair> points;
    double lengths = 0, total = 0;
    for (const IslandPair& pair : pairing.pairs)
        total += static_cast<double>(pair.source->from_representative.size());
    for (const IslandPair& pair : pairing.pairs) {
        const auto n = static_cast<double>(pair.source->from_representative.size());
        lengths += n / total * geometry.length_disagreement(pair, 1000);
        const auto some = geometry.points(pair, static_cast<std::size_t>(1 + 10'000 * n / total));
        points.insert(points.end(), some.begin(), some.end());
    }
    pairing.length_disagreement = lengths;
    pairing.similarity = fit_similarity(points, turned);
    pairing.residual = residual(pairing.similarity, points);
    pairing.displacement = residual(Motion{}, points);
    pairing.tolerance = std::pow(1e-5 * geometry.mean_length(), 2);
}

bool fits_better(const Pairing& a, const Pairing& b) {
    const double tolerance = std::max(a.tolerance, b.tolerance);
    const auto alike = [&](double x, double y) {
        return std::abs(x - y) <= 0.01 * std::max(x, y) + tolerance;
    };
    if (!alike(a.length_disagreement, b.length_disagreement))
        return a.length_disagreement < b.length_disagreement;
    if (!alike(a.residual, b.residual)) return a.residual < b.residual;
    return a.displacement < b.displacement && !alike(a.displacement, b.displacement);
}

Pairing pair_islands(const MatchedMaps& maps, bool turned) {
    const bool determined = is_determined(maps);
    const PairGeometry geometry(maps, !determined);
    Pairing best = Pairer(maps, geometry, turned, nullptr).run();
    if (determined || has_anchor(maps)) return best;

    measure(maps, turned, best);
    constexpr std::size_t most_starts = 12;
    constexpr int most_rounds = 3;
    // Thousands of islands that fit perfectly leave next to no other way; trying takes its time.
    const bool many = maps.source.n_islands() > 400;
    if (many && best.residual <= best.tolerance) return best;
    std::vector<Motion> starts = starting_motions(maps, geometry, turned, most_starts);
    if (maps.source.n_islands() > 1) starts.push_back(best.similarity);
    if (maps.source.n_islands() > 1 && !many) starts.emplace_back();  // as if nothing had moved
    for (Motion motion : starts) {
        Pairing at_start;
        for (int round = 0; round < most_rounds; ++round) {
            Pairing found = Pairer(maps, geometry, turned, &motion).run();
            measure(maps, turned, found);
            if (round > 0 && !fits_better(found, at_start)) break;
            at_start = std::move(found);
            motion = at_start.similarity;
        }
        if (fits_better(at_start, best)) best = std::move(at_start);
    }
    return best;
}

}  // namespace counterpart
