// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/half_turn_cues.hpp"

#include "numerics/rotation.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace counterpart::spectral_match {
namespace {

// Of ranks, weighted by area, under a map of vertices.
double correlation(const Vector& x, const Vector& y, const std::vector<Index>& map, const Vector& mass) {
    const Vector weights = mass / mass.sum(), images = y(map);
    const Vector dx = x.array() - weights.dot(x), dy = images.array() - weights.dot(images);
    const double norm = std::sqrt(weights.dot(dx.cwiseAbs2()) * weights.dot(dy.cwiseAbs2()));
    return norm > 0 ? weights.dot(dx.cwiseProduct(dy)) / norm : 0;
}

// The best similarity of the neighborhood of each distance sample.
struct LocalFit {
    Eigen::Matrix3d rotation;
    double residual;  // of the image, relative to its size
};

LocalFit fit_similarity(const Points& from, const Points& to) {
    const Points x = from.rowwise() - from.colwise().mean(), y = to.rowwise() - to.colwise().mean();
    const Eigen::Matrix3d covariance = y.transpose() * x;
    const Eigen::Matrix3d rotation = numerics::fit_rotation(covariance).rotation;
    const double attained = rotation.cwiseProduct(covariance).sum(),
                 sizes = x.squaredNorm() * y.squaredNorm();
    return {rotation, sizes > 0 && attained > 0 ? 1 - attained * attained / sizes : 1};
}

std::vector<LocalFit> local_fits(const PreparedShape& from, const PreparedShape& to,
                                 const Neighborhoods& near, const std::vector<Index>& map) {
    std::vector<LocalFit> fits;
    for (std::size_t center = 0; center + 1 < near.first.size(); ++center) {
        const std::size_t first = near.first[center], n = near.first[center + 1] - first;
        Points x(static_cast<Eigen::Index>(n), 3), y = x;
        for (std::size_t i = 0; i < n; ++i) {
            const Index v = from.samples[static_cast<std::size_t>(near.samples[first + i])];
            x.row(static_cast<Eigen::Index>(i)) = from.mesh.vertices.row(v);
            y.row(static_cast<Eigen::Index>(i)) = to.mesh.vertices.row(map[static_cast<std::size_t>(v)]);
        }
        fits.push_back(fit_similarity(x, y));
    }
    return fits;
}

// In one direction.
double agreement_of_normals(const PreparedShape& from, const PreparedShape& to, const std::vector<Index>& map,
                            double radius) {
    const Neighborhoods near(from, all_samples, radius);
    const std::vector<LocalFit> fits = local_fits(from, to, near, map);
    double sum = 0;
    for (std::size_t center = 0; center < fits.size(); ++center) {
        const std::size_t first = near.first[center], last = near.first[center + 1];
        double agreeing = 0;
        for (std::size_t i = first; i < last; ++i) {
            const Index v = from.samples[static_cast<std::size_t>(near.samples[i])];
            agreeing += to.normals.row(map[static_cast<std::size_t>(v)])
                            .dot(from.normals.row(v) * fits[center].rotation.transpose());
        }
        sum += agreeing / static_cast<double>(std::max<std::size_t>(last - first, 1));
    }
    return sum / static_cast<double>(std::max<std::size_t>(fits.size(), 1));
}

double quantile(std::vector<double> values, double share) {
    if (values.empty()) return 0;
    const auto at =
        values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

double median_residual(const std::vector<LocalFit>& fits) {
    std::vector<double> residuals;
    for (const LocalFit& fit : fits) residuals.push_back(fit.residual);
    return quantile(std::move(residuals), 0.5);
}

double wring(const PreparedShape& shape, const std::vector<LocalFit>& fits, const CueTuning& tuning) {
    std::vector<double> changes;
    for (std::size_t i = 0; i < fits.size(); ++i) {
        double sum = 0;
        int count = 0;
        for (std::size_t j = 0; j < fits.size(); ++j) {
            const double apart = shape.sample_distances(static_cast<Eigen::Index>(i), shape.samples[j]);
            if (apart < tuning.wring_from || apart > tuning.wring_to) continue;
            sum += (fits[i].rotation - fits[j].rotation).squaredNorm();
            ++count;
        }
        if (count > 0) changes.push_back(sum / count);
    }
    return quantile(std::move(changes), tuning.wring_quantile);
}

}  // namespace

std::array<double, 4> relief_correlations(const PreparedShape& a, const PreparedShape& b,
                                          const PairedMaps& on_vertices) {
    std::array<double, 4> result{};
    for (std::size_t i = 0; i < result.size(); ++i) {
        const Vector on_a = a.relief.col(static_cast<Eigen::Index>(i)),
                     on_b = b.relief.col(static_cast<Eigen::Index>(i));
        result[i] = (correlation(on_a, on_b, on_vertices.b_from_a, a.basis.mass) +
                     correlation(on_b, on_a, on_vertices.a_from_b, b.basis.mass)) /
                    2;
    }
    return result;
}

double mean_relief(const std::array<double, 4>& correlations) {
    return std::accumulate(correlations.begin(), correlations.end(), 0.0) /
           static_cast<double>(correlations.size());
}

double agreement_of_normals(const PreparedShape& a, const PreparedShape& b, const PairedMaps& on_vertices,
                            double radius) {
    return (agreement_of_normals(a, b, on_vertices.b_from_a, radius) +
            agreement_of_normals(b, a, on_vertices.a_from_b, radius)) /
           2;
}

Cues measure_cues(const SampledPair& pair, const PairedMaps& on_vertices, const CueTuning& tuning) {
    Cues cues{.relief = relief_correlations(pair.a, pair.b, on_vertices)};
    const auto forward = local_fits(pair.a, pair.b, pair.near_a, on_vertices.b_from_a),
               backward = local_fits(pair.b, pair.a, pair.near_b, on_vertices.a_from_b);
    cues.residual = (median_residual(forward) + median_residual(backward)) / 2;
    cues.wring = (wring(pair.a, forward, tuning) + wring(pair.b, backward, tuning)) / 2;
    return cues;
}

}  // namespace counterpart::spectral_match
