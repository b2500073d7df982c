// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/refinement.hpp"

#include "match/spectral/elastic_fit.hpp"
#include "match/spectral/local_search.hpp"

#include <counterpart/mesh/measure.hpp>

#include <algorithm>
#include <cmath>

#include <tbb/parallel_invoke.h>

namespace counterpart::spectral_match {
namespace {

// Curvature at four scales and eight wave kernel columns, each of mean 0 and variance 1.
MatrixF features(const Shape& shape, float weight) {
    Eigen::MatrixXd all(shape.mesh.n_vertices(), 12);
    for (int j = 0; j < 4; ++j) all.col(j) = shape.curvature.col(j);
    for (int j = 0; j < 8; ++j) all.col(4 + j) = shape.wave_kernel.col(j * 5 + 2);
    const Vector mass = shape.basis.mass / shape.basis.mass.sum();
    for (int j = 0; j < 12; ++j) {
        all.col(j).array() -= mass.dot(all.col(j));
        all.col(j) /= std::sqrt(std::max(mass.dot(all.col(j).cwiseAbs2()), 1e-20));
    }
    // The embedding's squared length is about its number of functions.
    return all.cast<float>() * weight;
}

// Positions and normals, weighted.
MatrixF placement(const Points& positions, const Points& normals, const RefineOptions& options) {
    MatrixF all(positions.rows(), 6);
    all << positions.cast<float>() * options.position_weight, normals.cast<float>() * options.normal_weight;
    return all;
}

// A surface on its way to where the other one is.
class BentSurface {
  public:
    BentSurface(const Shape& shape, const Shape& other)
        : shape_(shape), other_(other), fit_(shape.mesh.vertices, shape.laplacian) {}

    void bend(const std::vector<Index>& image, double stiffness_length, int iterations) {
        Points images(shape_.mesh.vertices.rows(), 3);
        for (std::size_t v = 0; v < image.size(); ++v)
            images.row(static_cast<Eigen::Index>(v)) = other_.mesh.vertices.row(image[v]);
        const Points start = positions_.rows() > 0 ? positions_ : images;
        positions_ = fit_(images, start, stiffness_length, iterations);
    }

    MatrixF placement(const RefineOptions& options) const {
        const Points normals = vertex_normals({positions_, shape_.mesh.triangles});
        return spectral_match::placement(positions_, normals, options);
    }

    double strain() const { return fit_.strain(positions_); }

  private:
    const Shape& shape_;
    const Shape& other_;
    ElasticFit fit_;
    Points positions_;
};

MatrixF side_by_side(const MatrixF& x, const MatrixF& y, const MatrixF& z) {
    MatrixF all(x.rows(), x.cols() + y.cols() + z.cols());
    all << x, y, z;
    return all;
}

}  // namespace

Refined refine(const Shape& a, const Shape& b, const Candidate& start, const RefineOptions& options) {
    const SampledPair pair(a, b, std::max(a.samples.size(), b.samples.size()), 0);
    const MatrixF features_a = features(a, options.feature_weight),
                  features_b = features(b, options.feature_weight);
    // Not among all functions: their details would hold unlike bodies fast where isometry put them.
    PairedMaps maps = match_points_nearby(
        a, b, fit_functional_maps(pair.points_a, pair.points_b, start.maps, options.begin, true),
        spread(a, b, start.maps), 2, {features_a, features_b});
    const MatrixF own_a = placement(a.mesh.vertices, a.normals, options),
                  own_b = placement(b.mesh.vertices, b.normals, options);
    BentSurface bent_a(a, b), bent_b(b, a);
    const bool is_huge = std::max(a.mesh.n_vertices(), b.mesh.n_vertices()) > 3 * large_mesh;
    const int n_rounds = is_huge ? options.rounds_if_huge : options.rounds;
    for (int round = 0; round < n_rounds; ++round) {
        const double t = n_rounds > 1 ? static_cast<double>(round) / (n_rounds - 1) : 1;
        const double length = options.first_length * std::pow(options.last_length / options.first_length, t);
        const int k = options.first + static_cast<int>(t * (options.last - options.first));
        tbb::parallel_invoke([&] { bent_a.bend(maps.b_from_a, length, options.iterations); },
                             [&] { bent_b.bend(maps.a_from_b, length, options.iterations); });
        maps = match_points_nearby(a, b, fit_functional_maps(a.all, b.all, maps, k, true), maps, 1,
                                   {side_by_side(features_a, bent_a.placement(options), own_a),
                                    side_by_side(features_b, own_b, bent_b.placement(options))});
    }
    return {std::move(maps), (bent_a.strain() + bent_b.strain()) / 2};
}

}  // namespace counterpart::spectral_match
