// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/refinement.hpp"

#include "base/parallel.hpp"
#include "match/spectral/bent_surface.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>

namespace counterpart::spectral_match {
namespace {

MatrixF side_by_side(std::initializer_list<MatrixF> parts) {
    Eigen::Index n = 0;
    for (const MatrixF& part : parts) n += part.cols();
    MatrixF all(parts.begin()->rows(), n);
    n = 0;
    for (const MatrixF& part : parts) {
        all.middleCols(n, part.cols()) = part;
        n += part.cols();
    }
    return all;
}

// How near each vertex is to each landmark: what surrounds one is to go to what surrounds its image.
MatrixF nearness(const PreparedShape& shape, std::span<const PriorPair> landmarks,
                 VectorF PriorPair::*distances, float weight, float reach) {
    MatrixF all(shape.mesh.n_vertices(), static_cast<Eigen::Index>(landmarks.size()));
    for (std::size_t i = 0; i < landmarks.size(); ++i) {
        const auto relative = (landmarks[i].*distances).array() / reach;
        all.col(static_cast<Eigen::Index>(i)) = weight * (-relative).exp();
    }
    return all;
}

// A vertex's shares of nearness to the guides: halfway down a short leg is halfway down a long one.
MatrixF shares_of_nearness(const MatrixF& distances, const RefinementTuning& tuning) {
    const MatrixF all = (distances.array() + tuning.guide_offset).square().inverse();
    const VectorF sums = all.rowwise().sum();
    return tuning.guide_weight * sums.cwiseInverse().asDiagonal() * all;
}

// V x guides: distances from extremities and from landmarks.
MatrixF distances_from(const PreparedShape& shape, const std::vector<int>& extremities,
                       std::span<const PriorPair> landmarks, VectorF PriorPair::*distances) {
    MatrixF all(shape.mesh.n_vertices(), static_cast<Eigen::Index>(extremities.size() + landmarks.size()));
    Eigen::Index column = 0;
    for (const int e : extremities) all.col(column++) = shape.extremity_distances.row(e).transpose();
    for (const PriorPair& landmark : landmarks) all.col(column++) = landmark.*distances;
    return all;
}

// How far up, to the front or to the left, between the two ends of the shape; of one that is flat there,
// nothing.
MatrixF heights(const PreparedShape& shape, const Eigen::Matrix3Xd& directions,
                const RefinementTuning& tuning) {
    Eigen::MatrixXd all = shape.mesh.vertices * directions;
    for (Eigen::Index d = 0; d < all.cols(); ++d) {
        all.col(d).array() -= all.col(d).minCoeff();
        const double height = all.col(d).maxCoeff();
        all.col(d) *= height > tuning.least_height ? 1 / height : 0;
    }
    return tuning.height_weight * all.cast<float>();
}

// What is compared in all rounds, of A and of B.
ExtraCoordinates features(const Level& level, const Schedule& schedule, const Guides& guides) {
    const RefinementTuning& tuning = level.tuning.refinement;
    const std::span<const PriorPair> landmarks(level.pair.priors.landmarks),
        followed = schedule.landmark_weight > 0 ? landmarks : std::span<const PriorPair>();
    std::vector<int> guides_a, guides_b;
    for (const auto& [i, j] : guides.extremities) {
        guides_a.push_back(i);
        guides_b.push_back(j);
    }
    const auto of = [&](const LevelShape& shape, const std::vector<int>& extremities,
                        VectorF PriorPair::*distances, const Eigen::Matrix3Xd& directions) {
        const bool by_relief = schedule.relief_weight > 0;
        return side_by_side(
            {shape.intrinsic * tuning.feature_weight,
             by_relief ? MatrixF(shape.relief * schedule.relief_weight) : MatrixF(shape.relief.rows(), 0),
             nearness(shape.shape, followed, distances, schedule.landmark_weight, tuning.landmark_reach),
             shares_of_nearness(distances_from(shape.shape, extremities, guides.landmarks, distances),
                                tuning),
             heights(shape.shape, directions, tuning)});
    };
    return {of(level.a, guides_a, &PriorPair::from_a, guides.directions_a),
            of(level.b, guides_b, &PriorPair::from_b, guides.directions_b)};
}

// Nearest by spectral coordinates and the given ones, within `rings` (1 or 2) rings of cells around the
// guess; 0: anywhere.
PairedMaps partners(const Level& level, const PairedFunctionalMaps& functional, const PairedMaps& guess,
                    int rings, const ExtraCoordinates& extra, const ProgressRange& progress) {
    const LevelShape &a = level.a, &b = level.b;
    const PairCoordinates at_points = pair_coordinates(a.shape.all, b.shape.all, functional, extra);
    if (rings == 0) {
        BestPartners all = best_partners(at_points.a, at_points.b, at_points.half_a, at_points.half_b);
        return pinned({std::move(all.of_row), std::move(all.of_column)}, level.pair.priors.pins());
    }
    const Cells::Lists &near_a = rings == 2 ? a.two_rings : a.one_ring,
                       &near_b = rings == 2 ? b.two_rings : b.one_ring;
    PairedMaps found;
    found.b_from_a = nearest_nearby(a.cells, b.cells, near_b, at_points.a, at_points.b, at_points.half_b,
                                    guess.b_from_a, progress);
    found.a_from_b = nearest_nearby(b.cells, a.cells, near_a, at_points.b, at_points.a, at_points.half_a,
                                    guess.a_from_b, progress);
    return pinned(std::move(found), level.pair.priors.pins());
}

align::ElasticFitOptions fit_options(const RefinementTuning& tuning, Eigen::Index n_vertices) {
    const bool is_coarse = n_vertices <= tuning.most_kept_vertices;
    return {.scales = {tuning.min_scale, tuning.max_scale},
            .settled = tuning.settled,
            .n_kept_factors = is_coarse ? tuning.n_kept_factors : 1};
}

}  // namespace

Refiner::Refiner(const Level& level)
    : level_(level),
      fit_a_(level.a.shape.mesh.vertices, level.a.shape.laplacian.stiffness,
             fit_options(level.tuning.refinement, level.a.shape.mesh.n_vertices())),
      fit_b_(level.b.shape.mesh.vertices, level.b.shape.laplacian.stiffness,
             fit_options(level.tuning.refinement, level.b.shape.mesh.n_vertices())) {
    for (const auto& [va, vb] : level.pair.priors.pins()) {
        pinned_a_.push_back(va);
        pinned_b_.push_back(vb);
    }
}

Map Refiner::operator()(const Map& start, const Schedule& schedule, const Guides& guides,
                        const ProgressRange& progress) {
    const PreparedShape &a = level_.a.shape, &b = level_.b.shape;
    const RefinementTuning& tuning = level_.tuning.refinement;
    const ExtraCoordinates compared = features(level_, schedule, guides);
    PairedMaps maps = start.on_vertices;
    if (schedule.start_size > 0)
        maps = partners(level_,
                        fit_functional_maps(level_.pair.points_a, level_.pair.points_b, start.maps,
                                            schedule.start_size, true),
                        spread(a, b, start.maps), schedule.start_rings, compared, progress);
    BentSurface bent_a(level_.a, level_.b, pinned_a_, fit_a_, tuning),
        bent_b(level_.b, level_.a, pinned_b_, fit_b_, tuning);
    for (int round = 0; round < schedule.n_rounds; ++round) {
        const double t = schedule.n_rounds > 1 ? static_cast<double>(round) / (schedule.n_rounds - 1) : 1;
        const double length =
            schedule.first_length * std::pow(schedule.last_length / schedule.first_length, t);
        const int k = schedule.first_size + static_cast<int>(t * (schedule.last_size - schedule.first_size));
        if (round >= schedule.islands_from)
            parallel_invoke(
                [&] { maps.b_from_a = bent_a.without_islands(std::move(maps.b_from_a), length, progress); },
                [&] { maps.a_from_b = bent_b.without_islands(std::move(maps.a_from_b), length, progress); });
        parallel_invoke(
            [&] { bent_a.bend(maps, schedule.back_pull, length, schedule.n_iterations, progress); },
            [&] {
                bent_b.bend(reversed(maps), schedule.back_pull, length, schedule.n_iterations, progress);
            });
        maps = partners(
            level_, fit_functional_maps(a.all, b.all, maps, k, true, progress.unheard().callback()), maps, 1,
            {side_by_side({compared.a, bent_a.placement(), level_.a.placement}),
             side_by_side({compared.b, level_.b.placement, bent_b.placement()})},
            progress);
        progress.reach((round + 1.0) / schedule.n_rounds);
    }
    return scored(level_, std::move(maps));
}

}  // namespace counterpart::spectral_match
