// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/refinement.hpp"

#include "base/parallel.hpp"
#include "match/spectral/elastic_fit.hpp"
#include "match/spectral/islands.hpp"
#include "match/spectral/restricted_nearest.hpp"
#include "numerics/oriented_neighbors.hpp"

#include <counterpart/mesh/measure.hpp>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <span>
#include <utility>
#include <vector>

namespace counterpart::spectral_match {
namespace {

// Curvature at all scales and some wave kernel columns, each of mean 0 and variance 1.
MatrixF intrinsic_features(const PreparedShape& shape, const RefinementTuning& tuning) {
    const Eigen::Index n_scales = shape.curvature.cols(), n = n_scales + tuning.n_wave_kernel;
    const Eigen::Index stride = shape.wave_kernel.cols() / tuning.n_wave_kernel;
    Eigen::MatrixXd all(shape.mesh.n_vertices(), n);
    all.leftCols(n_scales) = shape.curvature;
    for (Eigen::Index j = 0; j < tuning.n_wave_kernel; ++j)
        all.col(n_scales + j) = shape.wave_kernel.col(j * stride + stride / 2);
    const Vector mass = shape.basis.mass / shape.basis.mass.sum();
    for (Eigen::Index j = 0; j < n; ++j) {
        all.col(j).array() -= mass.dot(all.col(j));
        all.col(j) /= std::sqrt(std::max(mass.dot(all.col(j).cwiseAbs2()), 1e-20));
    }
    // The embedding's squared length is about its number of functions.
    return all.cast<float>() * tuning.feature_weight;
}

// How near each vertex is to each landmark: what surrounds one is to go to what surrounds its image.
MatrixF nearness(const PreparedShape& shape, std::span<const PriorPair> landmarks,
                 VectorF PriorPair::*distances, const RefinementTuning& tuning) {
    MatrixF all(shape.mesh.n_vertices(), static_cast<Eigen::Index>(landmarks.size()));
    for (std::size_t i = 0; i < landmarks.size(); ++i) {
        const auto relative = (landmarks[i].*distances).array() / tuning.landmark_reach;
        all.col(static_cast<Eigen::Index>(i)) = tuning.landmark_weight * (-relative).exp();
    }
    return all;
}

// Distances from the guides, one in a row: extremities, and landmarks likewise.
MatrixF distances_from_guides(const PreparedShape& shape, const std::vector<int>& extremities,
                              std::span<const PriorPair> landmarks, VectorF PriorPair::*distances) {
    MatrixF all(static_cast<Eigen::Index>(extremities.size() + landmarks.size()), shape.mesh.n_vertices());
    Eigen::Index row = 0;
    for (const int extremity : extremities) all.row(row++) = shape.extremity_distances.row(extremity);
    for (const PriorPair& landmark : landmarks) all.row(row++) = (landmark.*distances).transpose();
    return all;
}

// A vertex's shares of nearness to the guides: halfway down a short leg is halfway down a long one.
MatrixF shares_of_nearness(const MatrixF& distances, const RefinementTuning& tuning) {
    const MatrixF all = (distances.transpose().array() + tuning.guide_offset).square().inverse();
    const VectorF sums = all.rowwise().sum();
    return tuning.guide_weight * sums.cwiseInverse().asDiagonal() * all;
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

// What is compared in all rounds, of A and of B.
std::pair<MatrixF, MatrixF> features(const SampledPair& all, const Candidate& start,
                                     const RefinementTuning& tuning) {
    const PreparedShape &a = all.a, &b = all.b;
    const Priors& priors = all.priors;
    const std::span<const PriorPair> landmarks(priors.landmarks), none;
    const auto followed = start.follows_landmarks ? landmarks : none,
               guiding = start.guided_by_priors ? landmarks : none;
    const Eigen::Index n_directions = start.guided_by_priors ? priors.directions_a.cols() : 0;
    std::vector<int> guides_a, guides_b;
    for (const auto& [i, j] : start.guides) {
        guides_a.push_back(i);
        guides_b.push_back(j);
    }
    return {side_by_side(
                {intrinsic_features(a, tuning), nearness(a, followed, &PriorPair::from_a, tuning),
                 shares_of_nearness(distances_from_guides(a, guides_a, guiding, &PriorPair::from_a), tuning),
                 heights(a, priors.directions_a.leftCols(n_directions), tuning)}),
            side_by_side(
                {intrinsic_features(b, tuning), nearness(b, followed, &PriorPair::from_b, tuning),
                 shares_of_nearness(distances_from_guides(b, guides_b, guiding, &PriorPair::from_b), tuning),
                 heights(b, priors.directions_b.leftCols(n_directions), tuning)})};
}

// Positions and normals, weighted.
MatrixF placement(PointsView positions, PointsView normals, const RefinementTuning& tuning) {
    MatrixF all(positions.rows(), 6);
    all << positions.cast<float>() * tuning.position_weight, normals.cast<float>() * tuning.normal_weight;
    return all;
}

// Pinned vertices pull like a part of the surface of that area.
LaplaceBeltrami with_pins(LaplaceBeltrami laplacian, const std::vector<Index>& pinned, double pin_mass) {
    for (const Index v : pinned) laplacian.mass[v] = std::max(laplacian.mass[v], pin_mass);
    return laplacian;
}

// Where a surface is pulled to, and how hard, relative to its area.
struct Pull {
    Points towards;
    Vector strength;
};

// Each vertex is pulled to its image, and to all that the other map takes to it: what no image covers pulls
// the surface over itself. Pinned vertices are pulled to where they are pinned alone.
Pull pull_of_both(const PreparedShape& shape, const PreparedShape& other, const PairedMaps& maps,
                  double back_pull, const std::vector<Index>& pinned) {
    const Points images = other.mesh.vertices(maps.b_from_a, Eigen::all);
    const Vector& area = shape.basis.mass;
    Points offsets = Points::Zero(images.rows(), 3);
    Vector pulling = area;
    for (Index w = 0; w < other.mesh.n_vertices(); ++w) {
        const Index v = maps.a_from_b[at(w)];
        const double pull = back_pull * other.basis.mass[w];
        offsets.row(v) += pull * (other.mesh.vertices.row(w) - images.row(v));
        pulling[v] += pull;
    }
    for (const Index v : pinned) {
        offsets.row(v).setZero();
        pulling[v] = (1 + back_pull) * area[v];
    }
    return {images + pulling.cwiseInverse().asDiagonal() * offsets,
            pulling.cwiseQuotient((1 + back_pull) * area)};
}

// A surface on its way to where the other one is.
class BentSurface {
  public:
    BentSurface(const PreparedShape& shape, const PreparedShape& other, const std::vector<Index>& pinned,
                const RefinementTuning& tuning)
        : shape_(shape),
          other_(other),
          pinned_(pinned),
          tuning_(tuning),
          fit_(shape.mesh.vertices, with_pins(shape.laplacian, pinned, tuning.pin_mass), tuning) {}

    void bend(const PairedMaps& maps, double back_pull, double stiffness_length,
              const ProgressRange& progress) {
        const Pull pull = pull_of_both(shape_, other_, maps, back_pull, pinned_);
        const Points start =
            positions_.rows() > 0 ? positions_ : Points(other_.mesh.vertices(maps.b_from_a, Eigen::all));
        positions_ =
            fit_(pull.towards, start, stiffness_length, tuning_.n_iterations, progress, pull.strength);
    }

    // Islands go where the surface around them carries them.
    void put_back_islands(std::vector<Index>& image, double stiffness_length, const ProgressRange& progress) {
        const Islands islands = find_islands(shape_, other_, image, tuning_.islands);
        if (islands.empty) return;
        progress.check();
        const Points images = other_.mesh.vertices(image, Eigen::all);
        positions_ = fit_.carried(images, islands.spoiled, stiffness_length);
        const Points bent_normals = normals();
        const numerics::OrientedNeighbors on_other(other_.mesh.vertices, other_.normals,
                                                   tuning_.normal_weight / tuning_.position_weight);
        for (std::size_t v = 0; v < image.size(); ++v) {
            const auto row = static_cast<Eigen::Index>(v);
            if (islands.inside[v] != 0)
                image[v] = on_other.closest(positions_.row(row), bent_normals.row(row));
        }
    }

    MatrixF placement() const { return spectral_match::placement(positions_, normals(), tuning_); }

  private:
    Points normals() const { return vertex_normals({positions_, shape_.mesh.triangles}); }

    const PreparedShape& shape_;
    const PreparedShape& other_;
    const std::vector<Index>& pinned_;
    const RefinementTuning& tuning_;
    ElasticFit fit_;
    Points positions_;
};

PairedMaps pinned(PairedMaps maps, const VertexPairs& pins) {
    for (const auto& [va, vb] : pins) {
        maps.b_from_a[static_cast<std::size_t>(va)] = vb;
        maps.a_from_b[static_cast<std::size_t>(vb)] = va;
    }
    return maps;
}

}  // namespace

PairedMaps refine(const SampledPair& all, const Candidate& start, const RefinementTuning& tuning,
                  const ProgressRange& progress) {
    const PreparedShape &a = all.a, &b = all.b;
    const VertexPairs pins = all.priors.pins();
    const auto [features_a, features_b] = features(all, start, tuning);
    const auto partners = [&](const PairedFunctionalMaps& functional, const PairedMaps& guess, int rings,
                              const ExtraCoordinates& extra) {
        return pinned(match_points_nearby(a, b, functional, guess, rings, extra, progress), pins);
    };
    const bool goes_on = tuning.goes_on && !start.on_vertices.b_from_a.empty();
    // Not among all functions: their details would pin dissimilar bodies where isometry put them.
    PairedMaps maps = goes_on
                          ? pinned(start.on_vertices, pins)
                          : partners(fit_functional_maps(all.points_a, all.points_b, start.maps,
                                                         tuning.first_match_size, tuning.masked),
                                     spread(a, b, start.maps), tuning.first_rings, {features_a, features_b});
    const bool is_huge = std::max(a.mesh.n_vertices(), b.mesh.n_vertices()) > tuning.huge_mesh;
    const int n_rounds = is_huge ? tuning.n_rounds_if_huge : tuning.n_rounds;
    if (n_rounds == 0) return maps;
    const MatrixF own_a = placement(a.mesh.vertices, a.normals, tuning),
                  own_b = placement(b.mesh.vertices, b.normals, tuning);
    std::vector<Index> pinned_a, pinned_b;
    for (const auto& [va, vb] : pins) {
        pinned_a.push_back(va);
        pinned_b.push_back(vb);
    }
    const double back_pull = start.both_pull ? tuning.back_pull : 0;
    BentSurface bent_a(a, b, pinned_a, tuning), bent_b(b, a, pinned_b, tuning);
    const Progress checking = [&](double) {
        progress.check();
        return true;
    };
    for (int round = goes_on ? std::max(0, n_rounds - tuning.n_continued_rounds) : 0; round < n_rounds;
         ++round) {
        progress.reach((round + 1.0) / (n_rounds + 1.0));
        const double t = n_rounds > 1 ? static_cast<double>(round) / (n_rounds - 1) : 1;
        const double length = tuning.first_length * std::pow(tuning.last_length / tuning.first_length, t);
        const int k = tuning.first_size + static_cast<int>(t * (tuning.last_size - tuning.first_size));
        if (round >= tuning.islands.first_round)
            parallel_invoke([&] { bent_a.put_back_islands(maps.b_from_a, length, progress); },
                            [&] { bent_b.put_back_islands(maps.a_from_b, length, progress); });
        parallel_invoke([&] { bent_a.bend(maps, back_pull, length, progress); },
                        [&] { bent_b.bend(reversed(maps), back_pull, length, progress); });
        maps =
            partners(fit_functional_maps(a.all, b.all, maps, k, tuning.masked, checking), maps, tuning.rings,
                     {side_by_side({features_a, bent_a.placement(), own_a}),
                      side_by_side({features_b, own_b, bent_b.placement()})});
    }
    return maps;
}

}  // namespace counterpart::spectral_match
