// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/score.hpp"

#include "match/surface/tears.hpp"
#include "numerics/rotation.hpp"

#include <algorithm>
#include <cmath>

namespace counterpart::spectral_match {
namespace {

// Of ranks, weighted by area, under a map of vertices.
double correlation(const Vector& x, const Vector& y, const std::vector<Index>& map, const Vector& mass) {
    const Vector weights = mass / mass.sum(), images = y(map);
    const Vector dx = x.array() - weights.dot(x), dy = images.array() - weights.dot(images);
    const double norm = std::sqrt(weights.dot(dx.cwiseAbs2()) * weights.dot(dy.cwiseAbs2()));
    return norm > 0 ? weights.dot(dx.cwiseProduct(dy)) / norm : 0;
}

// Mean over the kinds of relief, in one direction.
double relief(const PreparedShape& from, const PreparedShape& to, const std::vector<Index>& map) {
    double sum = 0;
    for (Eigen::Index i = 0; i < from.relief.cols(); ++i)
        sum += correlation(from.relief.col(i), to.relief.col(i), map, from.basis.mass);
    return sum / static_cast<double>(from.relief.cols());
}

// Of the places of `vertices` under the map, both about their centers: y x^T.
Eigen::Matrix3d covariance(const PreparedShape& from, const PreparedShape& to, const std::vector<Index>& map,
                           const std::vector<Index>& vertices) {
    const auto n = static_cast<double>(vertices.size());
    Eigen::RowVector3d center = Eigen::RowVector3d::Zero(), image_center = center;
    for (const Index v : vertices) {
        center += from.mesh.vertices.row(v) / n;
        image_center += to.mesh.vertices.row(map[at(v)]) / n;
    }
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (const Index v : vertices)
        sum += (to.mesh.vertices.row(map[at(v)]) - image_center).transpose() *
               (from.mesh.vertices.row(v) - center);
    return sum;
}

// Mean cosine between normals and those of their images, after the best rotation of each neighborhood, in one
// direction. A half-turned limb bends the wrong way.
double agreement_of_normals(const LevelShape& from, const PreparedShape& to, const std::vector<Index>& map) {
    double sum = 0;
    std::vector<Index> vertices;
    for (const std::vector<Index>& samples : from.neighborhoods) {
        if (samples.empty()) continue;
        vertices.clear();
        for (const Index s : samples) vertices.push_back(from.shape.samples[at(s)]);
        const Eigen::Matrix3d rotation =
            numerics::fit_rotation(covariance(from.shape, to, map, vertices)).rotation;
        double agreeing = 0;
        for (const Index v : vertices) {
            const Eigen::Vector3d turned = rotation * from.shape.normals.row(v).transpose();
            agreeing += turned.dot(to.normals.row(map[at(v)]).transpose());
        }
        sum += agreeing / static_cast<double>(vertices.size());
    }
    return sum / static_cast<double>(std::max<std::size_t>(from.neighborhoods.size(), 1));
}

}  // namespace

Vector round_trips_and_tears(const LevelShape& from, const LevelShape& to, const PairedMaps& maps) {
    const Points &before = from.shape.mesh.vertices, &after = to.shape.mesh.vertices;
    Vector result(before.rows());
    for (Index v = 0; v < from.shape.mesh.n_vertices(); ++v) {
        const Index image = maps.b_from_a[at(v)], back = maps.a_from_b[at(image)];
        double longest = 0;
        for (const Index w : from.neighbors.neighbors(v))
            longest = std::max(
                longest, surface_match::tear((before.row(v) - before.row(w)).norm(),
                                             (after.row(image) - after.row(maps.b_from_a[at(w)])).norm()));
        result[v] = (before.row(v) - before.row(back)).norm() + longest;
    }
    return result;
}

Score score(const Level& level, const PairedMaps& maps) {
    const ScoreTuning& tuning = level.tuning.score;
    const PairedMaps back = reversed(maps);
    const PreparedShape &a = level.a.shape, &b = level.b.shape;
    const auto damage = [&](const LevelShape& from, const LevelShape& to, const PairedMaps& there) {
        return round_trips_and_tears(from, to, there).cwiseMin(tuning.most_damage).mean();
    };
    Score result{.relief = (relief(a, b, maps.b_from_a) + relief(b, a, maps.a_from_b)) / 2,
                 .normals = (agreement_of_normals(level.a, b, maps.b_from_a) +
                             agreement_of_normals(level.b, a, maps.a_from_b)) /
                            2,
                 .damage = (damage(level.a, level.b, maps) + damage(level.b, level.a, back)) / 2,
                 .disagreement = level.pair.priors.empty() ? 0
                                                           : disagreement(a, b, level.pair.priors,
                                                                          between_samples(level.pair, maps))};
    result.total = result.relief + tuning.normal_weight * result.normals -
                   tuning.damage_weight * result.damage - result.disagreement;
    if (std::isnan(result.total)) result.total = -std::numeric_limits<double>::infinity();
    return result;
}

}  // namespace counterpart::spectral_match
