// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/symmetry/pair_geometry.hpp"

#include "match/symmetry/tuning.hpp"

#include <algorithm>
#include <cmath>

namespace counterpart::symmetry {

using namespace isomorphism;

namespace {

// Of triangles: an edge between two counts twice.
double mean_side_length(MeshView mesh) {
    double sum = 0;
    for (Index t = 0; t < mesh.n_triangles(); ++t)
        for (int c = 0; c < 3; ++c)
            sum +=
                (mesh.vertices.row(mesh.triangles(t, c)) - mesh.vertices.row(mesh.triangles(t, (c + 1) % 3)))
                    .norm();
    return sum / (3.0 * mesh.n_triangles());
}

}  // namespace

std::vector<std::size_t> evenly_spread(std::size_t size, std::size_t max) {
    std::vector<std::size_t> chosen(std::min(size, max));
    for (std::size_t i = 0; i < chosen.size(); ++i) chosen[i] = i * size / chosen.size();
    return chosen;
}

PairGeometry::PairGeometry(const MatchedMaps& maps) : maps_(maps) {
    // Where components are missing the totals do not compare, but the means nearly do.
    const double source = mean_side_length(maps.source_mesh), target = mean_side_length(maps.target_mesh);
    if (source > 0 && target > 0) length_scale_ = target / source;
    tolerance_ = std::pow(exact_tuning.rounding * target, 2);
}

Eigen::RowVector3d PairGeometry::on_source(Dart d) const {
    return maps_.source_mesh.vertices.row(maps_.source.input_vertex[to_size(maps_.source.origin(d))]);
}
Eigen::RowVector3d PairGeometry::on_target(Dart d) const {
    return maps_.target_mesh.vertices.row(maps_.target.input_vertex[to_size(maps_.target.origin(d))]);
}

double PairGeometry::edge_length_error(Dart source, Dart target) const {
    double sum = 0;
    for (int c = 0; c < 3; ++c, source = next(source), target = next(target))
        sum += std::pow(length_scale_ * (on_source(source) - on_source(next(source))).norm() -
                            (on_target(target) - on_target(next(target))).norm(),
                        2);
    return sum / 3;
}

double PairGeometry::edge_length_error(const ComponentPair& pair, std::size_t max_triangles) const {
    double sum = 0;
    const auto sample = evenly_spread(pair.size(), max_triangles);
    for (const std::size_t k : sample) sum += edge_length_error(pair.on_source(k), pair.on_target(k));
    return sum / static_cast<double>(sample.size());
}

void PairGeometry::add_points(Dart source, Dart target, std::vector<PointPair>& points) const {
    for (int c = 0; c < 3; ++c, source = next(source), target = next(target))
        points.push_back({on_source(source), on_target(target)});
}

std::vector<PointPair> PairGeometry::points(const ComponentPair& pair, std::size_t max_triangles) const {
    std::vector<PointPair> points;
    for (const std::size_t k : evenly_spread(pair.size(), max_triangles))
        add_points(pair.on_source(k), pair.on_target(k), points);
    return points;
}

double PairGeometry::tie(double value) const { return (1 + exact_tuning.tie) * value + tolerance_; }

bool PairGeometry::is_better(const Fit& a, const Fit& b) const {
    for (const auto figure : {&Fit::edge_length_error, &Fit::rigid_error, &Fit::offset})
        if (std::max(a.*figure, b.*figure) > tie(std::min(a.*figure, b.*figure)))
            return a.*figure < b.*figure;
    return false;
}

namespace {

/// All automorphisms of one component, each known by where it takes some sampled triangles.
class Ranking {
  public:
    Ranking(const MatchedMaps& maps, const PairGeometry& geometry, const ComponentPair& pair, bool reversed,
            const Frame& frame)
        : group_(maps.groups[to_size(pair.kind - maps.classes.data())]),
          geometry_(geometry),
          pair_(pair),
          reversed_(reversed),
          frame_(frame),
          sample_(evenly_spread(pair.size(), std::clamp(exact_tuning.max_sampled_darts / group_.order(),
                                                        exact_tuning.min_sample, exact_tuning.max_sample))) {}

    std::vector<Images> run(isomorphism::SimultaneousTraversal& traversal, std::size_t count) {
        const std::vector<Dart> roots = compare_all();
        keep_finalists(std::max(count, exact_tuning.n_finalists));
        std::vector<Images> full(candidates_.size());
        for (std::size_t i = 0; i < full.size(); ++i) {
            pair_.automorphism =
                traversal.run(pair_.kind->component, pair_.kind->root, roots[candidates_[i].element]);
            candidates_[i].element = i;
            candidates_[i].fit.edge_length_error =
                geometry_.edge_length_error(pair_, exact_tuning.max_final_triangles);
            full[i] = pair_.automorphism;
        }
        rank([&](Candidate& candidate) {
            pair_.automorphism = full[candidate.element];
            measure(geometry_.points(pair_, exact_tuning.max_final_triangles), candidate.fit);
        });
        std::vector<Images> best;
        for (std::size_t i = 0; i < std::min(count, candidates_.size()); ++i)
            best.push_back(std::move(full[candidates_[i].element]));
        return best;
    }

  private:
    struct Candidate {
        std::size_t element;
        Fit fit;
    };
    using Candidates = std::vector<Candidate>::iterator;

    Dart on_target(Dart d) const { return image_of(pair_.target->from_representative, pair_.kind->first, d); }

    // Follows the tree of generators that spans the orbit; returns where each element takes the root.
    std::vector<Dart> compare_all() {
        const std::size_t n = sample_.size(), order = group_.order();
        const Index first = pair_.kind->first;
        std::vector<Dart> roots(order, pair_.kind->root);
        images_.resize(order * n);
        for (std::size_t e = 0; e < order; ++e) {
            const Images* const step = e > 0       ? &group_.generators[group_.generator[e]]
                                       : reversed_ ? &group_.mirror
                                                   : nullptr;
            const auto apply = [&](Dart d) { return step == nullptr ? d : image_of(*step, first, d); };
            roots[e] = apply(roots[group_.parent[e]]);
            Candidate candidate{e, {}};
            for (std::size_t s = 0; s < n; ++s) {
                const Dart before = e > 0 ? images_[group_.parent[e] * n + s]
                                          : make_dart(first + static_cast<Index>(sample_[s]), 0);
                images_[e * n + s] = apply(before);
                candidate.fit.edge_length_error +=
                    geometry_.edge_length_error(pair_.on_source(sample_[s]), on_target(images_[e * n + s]));
            }
            candidate.fit.edge_length_error /= static_cast<double>(n);
            candidates_.push_back(candidate);
        }
        return roots;
    }

    void measure(const std::vector<PointPair>& points, Fit& fit) const {
        fit.rigid_error = squared_error(
            frame_.alignment != nullptr ? *frame_.alignment : fit_alignment(points, reversed_), points);
        fit.offset = squared_error({}, points);
    }

    // A sample of a component may miss where automorphisms differ: of one that is alike in itself, the
    // lengths of some edges tell nothing, place does.
    void keep_finalists(std::size_t count) {
        std::stable_sort(candidates_.begin(), candidates_.end(), [](const Candidate& a, const Candidate& b) {
            return a.fit.edge_length_error < b.fit.edge_length_error;
        });
        if (candidates_.size() <= count) return;
        const double ratio = frame_.is_around ? exact_tuning.clear : 1 + exact_tuning.nearly;
        const double limit = ratio * candidates_.front().fit.edge_length_error + geometry_.tolerance();
        const auto by_lengths = candidates_.begin() + static_cast<std::ptrdiff_t>(count / 2);
        const auto alike = std::find_if(by_lengths, candidates_.end(), [&](const Candidate& candidate) {
            return candidate.fit.edge_length_error > limit;
        });
        std::for_each(by_lengths, alike, [&](Candidate& candidate) {
            std::vector<PointPair> points;
            for (std::size_t s = 0; s < sample_.size(); ++s)
                geometry_.add_points(pair_.on_source(sample_[s]),
                                     on_target(images_[candidate.element * sample_.size() + s]), points);
            measure(points, candidate.fit);
        });
        std::stable_sort(by_lengths, alike, [](const Candidate& a, const Candidate& b) {
            return a.fit.rigid_error < b.fit.rigid_error;
        });
        candidates_.resize(count);
    }

    // Sorts; returns the end of those that tie with the best.
    Candidates leaders(Candidates end, double Fit::*figure, double ratio = 1 + exact_tuning.tie) {
        std::stable_sort(candidates_.begin(), end, [&](const Candidate& a, const Candidate& b) {
            return a.fit.*figure < b.fit.*figure;
        });
        const double limit = ratio * (candidates_.front().fit.*figure) + geometry_.tolerance();
        return std::find_if(candidates_.begin(), end,
                            [&](const Candidate& c) { return c.fit.*figure > limit; });
    }

    // Place is measured only where lengths do not decide: they always do on a mesh of irregular shape. What a
    // bend does to lengths may favor a turn of a part that is nearly alike in itself.
    template <class MeasurePlace>
    void rank(const MeasurePlace& measure_place) {
        const Candidates alike = leaders(candidates_.end(), &Fit::edge_length_error,
                                         frame_.is_around ? exact_tuning.clear : 1 + exact_tuning.tie);
        if (alike - candidates_.begin() < 2) return;
        std::for_each(candidates_.begin(), alike, measure_place);
        leaders(leaders(alike, &Fit::rigid_error), &Fit::offset);
    }

    const AutomorphismGroup& group_;
    const PairGeometry& geometry_;
    ComponentPair pair_;
    bool reversed_;
    Frame frame_;
    std::vector<std::size_t> sample_;
    std::vector<Dart> images_;  // of the sampled triangles, one row for each element
    std::vector<Candidate> candidates_;
};

}  // namespace

std::vector<Images> best_automorphisms(const MatchedMaps& maps, const PairGeometry& geometry,
                                       isomorphism::SimultaneousTraversal& traversal,
                                       const ComponentPair& pair, bool reversed, const Frame& frame,
                                       std::size_t count) {
    return Ranking(maps, geometry, pair, reversed, frame).run(traversal, count);
}

}  // namespace counterpart::symmetry
