// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/level.hpp"

#include <algorithm>
#include <cmath>

namespace counterpart::spectral_match {
namespace {

// Each column of mean 0 and variance 1 over the surface.
MatrixF standardized(Eigen::MatrixXd columns, const Vector& area) {
    const Vector mass = area / area.sum();
    for (Eigen::Index j = 0; j < columns.cols(); ++j) {
        columns.col(j).array() -= mass.dot(columns.col(j));
        columns.col(j) /= std::sqrt(std::max(mass.dot(columns.col(j).cwiseAbs2()), 1e-20));
    }
    return columns.cast<float>();
}

Eigen::MatrixXd curvature_and_wave_kernel(const PreparedShape& shape, int n_wave_kernel) {
    const Eigen::Index n_scales = shape.curvature.cols(), stride = shape.wave_kernel.cols() / n_wave_kernel;
    Eigen::MatrixXd all(shape.mesh.n_vertices(), n_scales + n_wave_kernel);
    all.leftCols(n_scales) = shape.curvature;
    for (Eigen::Index j = 0; j < n_wave_kernel; ++j)
        all.col(n_scales + j) = shape.wave_kernel.col(j * stride + stride / 2);
    return all;
}

}  // namespace

MatrixF placement(PointsView positions, PointsView normals, const RefinementTuning& tuning) {
    MatrixF all(positions.rows(), 6);
    all.leftCols(3) = positions.cast<float>() * tuning.position_weight;
    all.rightCols(3) = normals.cast<float>() * tuning.normal_weight;
    return all;
}

LevelShape::LevelShape(const PreparedShape& of, const SpectralTuning& tuning)
    : shape(of),
      intrinsic(standardized(curvature_and_wave_kernel(of, tuning.refinement.n_wave_kernel), of.basis.mass)),
      relief(standardized(of.relief, of.basis.mass)),
      placement(spectral_match::placement(of.mesh.vertices, of.normals, tuning.refinement)),
      cells(of),
      one_ring(cells.near(1)),
      two_rings(cells.near(2)),
      neighbors(of.mesh),
      along(of),
      neighborhoods(spectral_match::neighborhoods(of, all_samples, tuning.score.normal_radius)) {}

Level::Level(const PreparedShape& shape_a, const PreparedShape& shape_b, const Priors& priors,
             const SpectralTuning& with)
    : tuning(with), pair(shape_a, shape_b, all_samples, priors), a(shape_a, with), b(shape_b, with) {}

}  // namespace counterpart::spectral_match
