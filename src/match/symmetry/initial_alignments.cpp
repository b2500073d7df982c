// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/symmetry/initial_alignments.hpp"

#include "match/symmetry/component_assignment.hpp"
#include "match/symmetry/tuning.hpp"
#include "numerics/moments.hpp"
#include "numerics/nearest_neighbors.hpp"
#include "numerics/symmetric_eigen.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

namespace counterpart::symmetry {

using namespace isomorphism;

namespace {

struct ClassCenters {
    std::vector<Eigen::RowVector3d> source;
    numerics::NearestNeighbors target;
};

std::vector<ClassCenters> class_centers(const MatchedMaps& maps, const PairGeometry& geometry) {
    std::vector<ClassCenters> classes;
    const auto center = [&](const ComponentPair& pair, Eigen::RowVector3d PointPair::*side) {
        return spread_of(geometry.points(pair, exact_tuning.anchor_triangles), side).center;
    };
    for (const ComponentClass& kind : maps.classes) {
        if (kind.source.empty() || kind.target.empty()) continue;
        Points targets(static_cast<Eigen::Index>(kind.target.size()), 3);
        for (std::size_t j = 0; j < kind.target.size(); ++j)
            targets.row(static_cast<Eigen::Index>(j)) =
                center({&kind, &kind.source[0], &kind.target[j], {}}, &PointPair::target);
        classes.push_back({{}, numerics::NearestNeighbors(targets)});
        for (const Member& member : kind.source)
            classes.back().source.push_back(
                center({&kind, &member, &kind.target[0], {}}, &PointPair::source));
    }
    return classes;
}

// Sum of the squared distances from some moved centers to the closest of their class.
double alignment_cost(const std::vector<ClassCenters>& classes, std::size_t step,
                      const Alignment& alignment) {
    double sum = 0;
    std::size_t i = 0;
    for (const ClassCenters& kind : classes)
        for (const Eigen::RowVector3d& center : kind.source)
            if (i++ % step == 0) sum += kind.target.closest(alignment(center)).squared_distance;
    return sum;
}

// Principal axes of the vertices onto principal axes.
std::vector<Alignment> by_principal_axes(const MatchedMaps& maps, bool reversed) {
    PointsView from = maps.source_mesh.vertices, to = maps.target_mesh.vertices;
    const Eigen::RowVector3d source_mean = from.colwise().mean(), target_mean = to.colwise().mean();
    const Points source = from.rowwise() - source_mean, target = to.rowwise() - target_mean;
    const auto axes = [](PointsView centered) {
        Eigen::Matrix3d vectors =
            numerics::symmetric_eigen(numerics::cross_moments(centered, centered)).vectors;
        if (vectors.determinant() < 0) vectors.col(0) *= -1;
        return vectors;
    };
    const Eigen::Matrix3d source_axes = axes(source), target_axes = axes(target);
    const double source_size = source.norm() / std::sqrt(double(source.rows())),
                 target_size = target.norm() / std::sqrt(double(target.rows()));
    std::vector<Alignment> alignments;
    for (const bool reflects : {false, true}) {
        if (reflects && !reversed) break;
        for (const Eigen::Vector3d& sign : {Eigen::Vector3d(1, 1, 1), Eigen::Vector3d(1, -1, -1),
                                            Eigen::Vector3d(-1, 1, -1), Eigen::Vector3d(-1, -1, 1)}) {
            Alignment alignment{{}, reflects};
            alignment.similarity.rotation = target_axes * sign.asDiagonal() * source_axes.transpose();
            alignment.similarity.scale = source_size > 0 && target_size > 0 ? target_size / source_size : 1;
            alignment.similarity.translation = (target_mean - alignment(source_mean)).transpose();
            alignments.push_back(alignment);
        }
    }
    return alignments;
}

// One component of the class with the fewest choices onto all of its images.
std::vector<Alignment> by_one_component(const MatchedMaps& maps, const PairGeometry& geometry,
                                        isomorphism::SimultaneousTraversal& traversal, bool reversed) {
    const ComponentClass* anchor = nullptr;
    std::size_t fewest = exact_tuning.max_initial;
    const auto group = [&](const ComponentClass& kind) -> const AutomorphismGroup& {
        return maps.groups[to_size(&kind - maps.classes.data())];
    };
    for (const ComponentClass& kind : maps.classes) {
        if (kind.source.empty() || kind.target.empty()) continue;
        const std::size_t choices = kind.target.size() * group(kind).order();
        if (choices > fewest || (anchor != nullptr && choices == fewest)) continue;
        anchor = &kind;
        fewest = choices;
    }
    std::vector<Alignment> alignments;
    if (anchor == nullptr) return alignments;
    const bool mirror = reversed && !group(*anchor).mirror.empty();
    const bool exchange = reversed && !mirror && !maps.source.is_one_sided(anchor->component);
    for (const Member& target : anchor->target) {
        ComponentPair pair{anchor, &anchor->source[0], &target, {}};
        if (((pair.source->parity ^ target.parity) != 0) != exchange) continue;
        for (Images& images : best_automorphisms(maps, geometry, traversal, pair, mirror, {}, fewest)) {
            pair.automorphism = std::move(images);
            alignments.push_back(
                fit_alignment(geometry.points(pair, exact_tuning.anchor_triangles), reversed));
        }
    }
    return alignments;
}

}  // namespace

std::vector<Alignment> initial_alignments(const MatchedMaps& maps, const PairGeometry& geometry,
                                          isomorphism::SimultaneousTraversal& traversal, bool reversed) {
    std::vector<Alignment> alignments = by_principal_axes(maps, reversed);
    for (const Alignment& alignment : by_one_component(maps, geometry, traversal, reversed))
        alignments.push_back(alignment);
    const std::vector<ClassCenters> classes = class_centers(maps, geometry);
    std::size_t n_components = 0;
    for (const ClassCenters& kind : classes) n_components += kind.source.size();
    const std::size_t step = 1 + n_components / exact_tuning.alignment_sample;
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t i = 0; i < alignments.size(); ++i)
        order.emplace_back(alignment_cost(classes, step, alignments[i]), i);
    std::sort(order.begin(), order.end());
    std::vector<Alignment> best;
    for (std::size_t i = 0; i < std::min(order.size(), exact_tuning.max_tried); ++i)
        best.push_back(alignments[order[i].second]);
    return best;
}

}  // namespace counterpart::symmetry
