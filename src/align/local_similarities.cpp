// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "align/local_similarities.hpp"

#include "base/parallel.hpp"
#include "numerics/rotation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace counterpart::align {
namespace {

constexpr std::size_t grain = 256;  // vertices that are worth a task

using SmallMatrix = std::array<std::array<float, 3>, 3>;

Eigen::Matrix3d as_double(const SmallMatrix& m) {
    Eigen::Matrix3d result;
    for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c) result(r, c) = static_cast<double>(m[r][c]);
    return result;
}

SmallMatrix rotation_matrix(const Eigen::Quaternionf& q) {
    const float x = q.x(), y = q.y(), z = q.z(), w = q.w();
    return {{{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
             {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
             {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}}};
}

// sum_j w_ij (now_i - now_j) (rest_i - rest_j)^T.
SmallMatrix covariance(const Springs& springs, const double* now, std::size_t v) {
    SmallMatrix sum{};
    const double* here = now + 3 * v;
    for (Index i = springs.first[v]; i < springs.first[v + 1]; ++i) {
        const auto e = static_cast<std::size_t>(i);
        const double* there = now + 3 * static_cast<std::size_t>(springs.neighbor[e]);
        for (int r = 0; r < 3; ++r) {
            const float d = springs.weight[e] * static_cast<float>(here[r] - there[r]);
            for (int c = 0; c < 3; ++c) sum[r][c] += d * springs.edge[e][c];
        }
    }
    return sum;
}

// The iteration of numerics::follow_rotation, ended as soon as what is left is too little to matter.
Eigen::Quaternionf followed(const SmallMatrix& m, Eigen::Quaternionf guess) {
    constexpr int most_steps = 4;
    constexpr float close_enough = 0.02F;  // radians; the step leaves its square
    for (int step = 0; step < most_steps; ++step) {
        const SmallMatrix r = rotation_matrix(guess);
        SmallMatrix s;  // m r^T
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) s[i][j] = m[i][0] * r[j][0] + m[i][1] * r[j][1] + m[i][2] * r[j][2];
        const float tx = s[2][1] - s[1][2], ty = s[0][2] - s[2][0], tz = s[1][0] - s[0][1];
        const float trace = s[0][0] + s[1][1] + s[2][2];
        // trace I - (s + s^T) / 2
        const float a = trace - s[0][0], b = -0.5F * (s[0][1] + s[1][0]), c = -0.5F * (s[0][2] + s[2][0]),
                    d = trace - s[1][1], e = -0.5F * (s[1][2] + s[2][1]), f = trace - s[2][2];
        const float ca = d * f - e * e, cb = c * e - b * f, cc = b * e - c * d;
        const float determinant = a * ca + b * cb + c * cc;
        const bool is_concave =
            a > 0 && determinant > 1e-7F * std::abs(trace * trace * trace) && a * d > b * b;
        float x = 0, y = 0, z = 0;
        if (is_concave) {
            x = (ca * tx + cb * ty + cc * tz) / determinant;
            y = (cb * tx + (a * f - c * c) * ty + (b * c - a * e) * tz) / determinant;
            z = (cc * tx + (b * c - a * e) * ty + (a * d - b * b) * tz) / determinant;
        } else if (trace != 0) {
            const float size = std::abs(trace);
            x = tx / size, y = ty / size, z = tz / size;
        }
        const float angle = std::sqrt(x * x + y * y + z * z);
        const float half = angle > 1 ? 0.5F / angle : 0.5F;
        guess = (Eigen::Quaternionf(1, half * x, half * y, half * z) * guess).normalized();
        if (angle < close_enough) break;
    }
    return guess;
}

float attained(const SmallMatrix& m, const SmallMatrix& rotation) {
    float sum = 0;
    for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c) sum += m[r][c] * rotation[r][c];
    return sum;
}

}  // namespace

Springs::Springs(const SparseMatrix& stiffness, PointsView rest) : first{0} {
    for (Eigen::Index v = 0; v < stiffness.cols(); ++v) {
        square.push_back(0);
        for (SparseMatrix::InnerIterator it(stiffness, v); it; ++it) {
            if (it.row() == v) continue;
            std::array<float, 3> from_neighbor{};
            float length = 0;
            for (int c = 0; c < 3; ++c) {
                from_neighbor[c] = static_cast<float>(rest(v, c) - rest(it.row(), c));
                length += from_neighbor[c] * from_neighbor[c];
            }
            neighbor.push_back(static_cast<Index>(it.row()));
            weight.push_back(static_cast<float>(-it.value()));
            edge.push_back(from_neighbor);
            square.back() += weight.back() * length;
        }
        first.push_back(static_cast<Index>(neighbor.size()));
    }
}

LocalSimilarities local_similarities(const Springs& springs, PointsView now, const ScaleBounds& bounds,
                                     LocalSimilarities before) {
    const bool is_first = before.empty();
    LocalSimilarities similarities = std::move(before);
    similarities.resize(springs.n_vertices());
    const Points positions = now;
    const auto least = static_cast<float>(bounds.least), largest = static_cast<float>(bounds.largest);
    parallel_for(similarities.size(), grain, [&](std::size_t v) {
        const SmallMatrix m = covariance(springs, positions.data(), v);
        LocalSimilarity& similarity = similarities[v];
        if (!is_first) similarity.rotation = followed(m, similarity.rotation);
        if (is_first || !similarity.rotation.coeffs().allFinite())
            similarity.rotation =
                Eigen::Quaterniond(numerics::fit_rotation(as_double(m)).rotation).cast<float>();
        if (springs.square[v] > 0)
            similarity.scale = std::clamp(
                attained(m, rotation_matrix(similarity.rotation)) / springs.square[v], least, largest);
    });
    return similarities;
}

LocalSimilarities continued_inward(const Springs& springs, const std::vector<char>& spoiled,
                                   LocalSimilarities similarities) {
    std::vector<char> known = spoiled;
    for (char& k : known) k = k == 0;
    std::vector<std::size_t> left;
    for (std::size_t v = 0; v < spoiled.size(); ++v)
        if (spoiled[v] != 0) left.push_back(v);
    while (!left.empty()) {
        std::vector<std::pair<std::size_t, LocalSimilarity>> found;
        std::vector<std::size_t> later;
        for (const std::size_t v : left) {
            Eigen::Matrix3d rotations = Eigen::Matrix3d::Zero();
            float scales = 0, count = 0;
            for (Index i = springs.first[v]; i < springs.first[v + 1]; ++i) {
                const auto neighbor = static_cast<std::size_t>(springs.neighbor[static_cast<std::size_t>(i)]);
                if (known[neighbor] == 0) continue;
                rotations += similarities[neighbor].rotation.toRotationMatrix().cast<double>();
                scales += similarities[neighbor].scale;
                ++count;
            }
            if (count == 0) {
                later.push_back(v);
                continue;
            }
            const Eigen::Quaterniond mean(numerics::fit_rotation(rotations).rotation);
            found.push_back({v, {mean.cast<float>(), scales / count}});
        }
        if (found.empty()) break;
        for (const auto& [v, similarity] : found) {
            similarities[v] = similarity;
            known[v] = 1;
        }
        left = std::move(later);
    }
    return similarities;
}

Points moved_differences(const Springs& springs, const LocalSimilarities& similarities) {
    std::vector<SmallMatrix> half(similarities.size());
    for (std::size_t v = 0; v < half.size(); ++v) {
        half[v] = rotation_matrix(similarities[v].rotation);
        for (auto& row : half[v])
            for (float& x : row) x *= 0.5F * similarities[v].scale;
    }
    Points result(static_cast<Eigen::Index>(half.size()), 3);
    parallel_for(half.size(), grain, [&](std::size_t v) {
        std::array<float, 3> sum{};
        for (Index i = springs.first[v]; i < springs.first[v + 1]; ++i) {
            const auto e = static_cast<std::size_t>(i);
            const SmallMatrix &here = half[v], &there = half[static_cast<std::size_t>(springs.neighbor[e])];
            const std::array<float, 3>& edge = springs.edge[e];
            for (int r = 0; r < 3; ++r) {
                float moved = 0;
                for (int c = 0; c < 3; ++c) moved += (here[r][c] + there[r][c]) * edge[c];
                sum[r] += springs.weight[e] * moved;
            }
        }
        for (int r = 0; r < 3; ++r) result(static_cast<Eigen::Index>(v), r) = static_cast<double>(sum[r]);
    });
    return result;
}

double strain(const Springs& springs, PointsView now, const LocalSimilarities& similarities) {
    double left = 0, all = 0;
    for (std::size_t v = 0; v < similarities.size(); ++v) {
        const Eigen::Matrix3f linear = similarities[v].linear();
        for (Index i = springs.first[v]; i < springs.first[v + 1]; ++i) {
            const auto e = static_cast<std::size_t>(i);
            const Eigen::Vector3f after =
                (now.row(static_cast<Eigen::Index>(v)) - now.row(springs.neighbor[e]))
                    .transpose()
                    .cast<float>();
            const Eigen::Vector3f moved = linear * Eigen::Map<const Eigen::Vector3f>(springs.edge[e].data());
            left += static_cast<double>(springs.weight[e] * (after - moved).squaredNorm());
            all += static_cast<double>(springs.weight[e] * after.squaredNorm());
        }
    }
    return all > 0 && std::isfinite(left) ? std::clamp(left / all, 0.0, 1.0) : 1;
}

}  // namespace counterpart::align
