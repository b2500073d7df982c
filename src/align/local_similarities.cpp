// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "align/local_similarities.hpp"

#include "base/parallel.hpp"
#include "numerics/moments.hpp"
#include "numerics/rotation.hpp"

#include <algorithm>
#include <utility>

#include <Eigen/Geometry>

namespace counterpart::align {

std::vector<LocalSimilarity> local_similarities(const SparseMatrix& stiffness, PointsView rest,
                                                PointsView now, const ScaleBounds& bounds,
                                                std::vector<LocalSimilarity> before) {
    const bool is_first = before.empty();
    std::vector<LocalSimilarity> similarities = std::move(before);
    similarities.resize(static_cast<std::size_t>(rest.rows()));
    parallel_for(similarities.size(), 256, [&](std::size_t i) {
        const auto v = static_cast<Eigen::Index>(i);
        Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
        double squares = 0;
        for (SparseMatrix::InnerIterator it(stiffness, v); it; ++it) {
            if (it.row() == v) continue;
            const Eigen::RowVector3d at_rest = rest.row(it.row()) - rest.row(v);
            numerics::add_outer(covariance, -it.value(), (now.row(it.row()) - now.row(v)).transpose(),
                                at_rest.transpose());
            squares -= it.value() * at_rest.squaredNorm();
        }
        LocalSimilarity& similarity = similarities[i];
        if (!is_first)
            similarity.rotation =
                numerics::follow_rotation(covariance, Eigen::Quaterniond(similarity.rotation))
                    .toRotationMatrix();
        if (is_first || !similarity.rotation.allFinite())
            similarity.rotation = numerics::fit_rotation(covariance).rotation;
        if (squares > 0)
            similarity.scale = std::clamp(similarity.rotation.cwiseProduct(covariance).sum() / squares,
                                          bounds.least, bounds.largest);
    });
    return similarities;
}

void continue_inward(const SparseMatrix& stiffness, const std::vector<char>& spoiled,
                     std::vector<LocalSimilarity>& similarities) {
    std::vector<char> known = spoiled;
    for (char& k : known) k = k == 0;
    std::vector<Eigen::Index> left;
    for (std::size_t i = 0; i < spoiled.size(); ++i)
        if (spoiled[i] != 0) left.push_back(static_cast<Eigen::Index>(i));
    while (!left.empty()) {
        std::vector<std::pair<Eigen::Index, LocalSimilarity>> found;
        std::vector<Eigen::Index> later;
        for (const Eigen::Index v : left) {
            Eigen::Matrix3d rotations = Eigen::Matrix3d::Zero();
            double scales = 0, count = 0;
            for (SparseMatrix::InnerIterator it(stiffness, v); it; ++it) {
                const auto neighbor = static_cast<std::size_t>(it.row());
                if (it.row() == v || known[neighbor] == 0) continue;
                rotations += similarities[neighbor].rotation;
                scales += similarities[neighbor].scale;
                ++count;
            }
            if (count > 0)
                found.push_back({v, {numerics::fit_rotation(rotations).rotation, scales / count}});
            else
                later.push_back(v);
        }
        if (found.empty()) return;
        for (const auto& [v, similarity] : found) {
            similarities[static_cast<std::size_t>(v)] = similarity;
            known[static_cast<std::size_t>(v)] = 1;
        }
        left = std::move(later);
    }
}

Points moved_differences(const SparseMatrix& stiffness, PointsView rest,
                         const std::vector<LocalSimilarity>& similarities) {
    Points result = Points::Zero(rest.rows(), 3);
    parallel_for(similarities.size(), 256, [&](std::size_t i) {
        const auto v = static_cast<Eigen::Index>(i);
        for (SparseMatrix::InnerIterator it(stiffness, v); it; ++it) {
            if (it.row() == v) continue;
            const Eigen::Matrix3d mean =
                (similarities[i].linear() + similarities[static_cast<std::size_t>(it.row())].linear()) / 2;
            result.row(v) -= it.value() * (rest.row(v) - rest.row(it.row())) * mean.transpose();
        }
    });
    return result;
}

}  // namespace counterpart::align
