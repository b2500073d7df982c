// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Umeyama, "Least-squares estimation of transformation parameters between two point patterns", PAMI 1991.
#include "match/exact/similarity.hpp"

#include <Eigen/LU>
#include <Eigen/SVD>

namespace counterpart {

Motion fit_similarity(const std::vector<PointPair>& pairs, bool reflection) {
    Motion fit;
    double total = 0;
    Eigen::RowVector3d source = Eigen::RowVector3d::Zero(), target = source;
    for (const PointPair& pair : pairs) {
        total += pair.weight;
        source += pair.weight * pair.source;
        target += pair.weight * pair.target;
    }
    if (!(total > 0)) return fit;
    source /= total;
    target /= total;
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    double variance = 0;
    for (const PointPair& pair : pairs) {
        covariance += pair.weight * (pair.target - target).transpose() * (pair.source - source);
        variance += pair.weight * (pair.source - source).squaredNorm();
    }
    if (variance > 0 && covariance.norm() > 0) {
        const Eigen::JacobiSVD<Eigen::Matrix3d> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
        Eigen::Vector3d sign = Eigen::Vector3d::Ones();
        if (!reflection && svd.matrixU().determinant() * svd.matrixV().determinant() < 0) sign[2] = -1;
        fit.linear = svd.singularValues().dot(sign) / variance * svd.matrixU() * sign.asDiagonal() *
                     svd.matrixV().transpose();
    }
    fit.offset = target - source * fit.linear.transpose();
    return fit;
}

double residual(const Motion& similarity, const std::vector<PointPair>& pairs) {
    double sum = 0, total = 0;
    for (const PointPair& pair : pairs) {
        sum += pair.weight * (similarity(pair.source) - pair.target).squaredNorm();
        total += pair.weight;
    }
    return total > 0 ? sum / total : 0;
}

}  // namespace counterpart
