// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "align/softassign.hpp"

#include "base/multiversion.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace counterpart::align {
namespace {

constexpr std::size_t lanes = 16;
constexpr float tiny = 1e-30F;

// exp(x) for x <= 0 to 2 units in the last place; 0 below -87, near the smallest normal number.
[[gnu::always_inline]] inline float exp_negative(float exact) {
    const float x = exact < -87.F ? -87.F : exact;
    constexpr float shift = 12582912.F;  // 1.5 * 2^23: adding it rounds to an integer
    const float rounded = x * 1.44269504F + shift;
    const float n = rounded - shift;
    const float r = (x - n * 0.693359375F) + n * 2.12194440e-4F;
    float p = 1.9875691500e-4F;
    p = p * r + 1.3981999507e-3F;
    p = p * r + 8.3334519073e-3F;
    p = p * r + 4.1665795894e-2F;
    p = p * r + 1.6666665459e-1F;
    p = p * r + 5.0000001201e-1F;
    const float e = p * r * r + r + 1.F;
    const auto bits = (std::bit_cast<std::int32_t>(rounded) - std::bit_cast<std::int32_t>(shift) + 127) << 23;
    return exact < -87.F ? 0.F : e * std::bit_cast<float>(bits);
}

// E for one source point; y: 3 rows of `stride` coordinates.
COUNTERPART_MULTIVERSION void gaussian_row(const float* y, std::size_t stride, const float* f, float exponent,
                                           float height, float* row) {
    const float fx = f[0], fy = f[1], fz = f[2];
    for (std::size_t j = 0; j < stride; ++j) {
        const float dx = fx - y[j], dy = fy - y[stride + j], dz = fz - y[2 * stride + j];
        row[j] = height * exp_negative(exponent * (dx * dx + dy * dy + dz * dz));
    }
}

// One round: u = 1 / (E v + outlier), column_sums = E' u. Returns how far the row sums were from 1.
COUNTERPART_MULTIVERSION float sinkhorn_round(const float* weights, std::size_t n, std::size_t stride,
                                              const float* row_outlier, const float* v, float* u,
                                              float* column_sums) {
    for (std::size_t j = 0; j < stride; ++j) column_sums[j] = 0;
    float worst = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const float* row = weights + i * stride;
        float lane[lanes] = {};
        for (std::size_t j = 0; j < stride; j += lanes)
            for (std::size_t k = 0; k < lanes; ++k) lane[k] += row[j + k] * v[j + k];
        float sum = row_outlier[i];
        for (std::size_t k = 0; k < lanes; ++k) sum += lane[k];
        const float scale = 1.F / std::max(sum, tiny);
        worst = std::max(worst, std::abs(u[i] * sum - 1.F));
        u[i] = scale;
        for (std::size_t j = 0; j < stride; ++j) column_sums[j] += scale * row[j];
    }
    return worst;
}

// Sums over j of w_j y_j and, last, of w_j, with w = row * v.
COUNTERPART_MULTIVERSION void weighted_sums(const float* row, const float* v, const float* y,
                                            std::size_t stride, float* sums) {
    float x_lane[lanes] = {}, y_lane[lanes] = {}, z_lane[lanes] = {}, w_lane[lanes] = {};
    for (std::size_t j = 0; j < stride; j += lanes) {
        for (std::size_t k = 0; k < lanes; ++k) {
            const float weight = row[j + k] * v[j + k];
            w_lane[k] += weight;
            x_lane[k] += weight * y[j + k];
            y_lane[k] += weight * y[stride + j + k];
            z_lane[k] += weight * y[2 * stride + j + k];
        }
    }
    for (std::size_t d = 0; d < 4; ++d) sums[d] = 0;
    for (std::size_t k = 0; k < lanes; ++k) {
        sums[0] += x_lane[k];
        sums[1] += y_lane[k];
        sums[2] += z_lane[k];
        sums[3] += w_lane[k];
    }
}

}  // namespace

Softassign::Softassign(const Matrix& target, Eigen::Index n_source, const SoftassignOptions& options)
    : options_(options),
      n_(static_cast<std::size_t>(n_source)),
      m_(static_cast<std::size_t>(target.rows())),
      stride_((m_ + lanes - 1) / lanes * lanes),
      dimension_(target.cols()),
      target_(3 * stride_, 0.F),
      target_center_(target.colwise().mean()),
      weights_(n_ * stride_),
      row_outlier_(n_),
      col_outlier_(stride_),
      u_(n_),
      v_(stride_),
      column_sums_(stride_) {
    std::fill_n(v_.begin(), m_, 1.F);
    for (Eigen::Index d = 0; d < dimension_; ++d)
        for (std::size_t j = 0; j < m_; ++j)
            target_[static_cast<std::size_t>(d) * stride_ + j] =
                static_cast<float>(target(static_cast<Eigen::Index>(j), d));
}

void Softassign::update(const Matrix& transformed, double temperature) {
    const double t0 = options_.outlier_temperature;
    const auto exponent = static_cast<float>(-0.5 / temperature);
    const auto height = static_cast<float>(1 / temperature);
    const Eigen::RowVectorXd source_center = transformed.colwise().mean();
    const auto outlier = [&](double squared_distance) {
        return static_cast<float>(std::exp(-0.5 * squared_distance / t0) / t0);
    };
    for (std::size_t i = 0; i < n_; ++i) {
        const auto row = transformed.row(static_cast<Eigen::Index>(i));
        float point[3] = {};
        for (Eigen::Index d = 0; d < dimension_; ++d) point[d] = static_cast<float>(row[d]);
        float* weights = weights_.data() + i * stride_;
        gaussian_row(target_.data(), stride_, point, exponent, height, weights);
        std::fill(weights + m_, weights + stride_, 0.F);
        row_outlier_[i] = outlier((row - target_center_).squaredNorm());
    }
    for (std::size_t j = 0; j < m_; ++j) {
        double squared = 0;
        for (Eigen::Index d = 0; d < dimension_; ++d) {
            const double difference = target_[static_cast<std::size_t>(d) * stride_ + j] - source_center[d];
            squared += difference * difference;
        }
        col_outlier_[j] = outlier(squared);
    }
    for (int round = 0; round < options_.max_sinkhorn; ++round) {
        const float worst = sinkhorn_round(weights_.data(), n_, stride_, row_outlier_.data(), v_.data(),
                                           u_.data(), column_sums_.data());
        if (round > 0 && worst < static_cast<float>(options_.tolerance)) break;
        for (std::size_t j = 0; j < m_; ++j) v_[j] = 1.F / std::max(column_sums_[j] + col_outlier_[j], tiny);
    }
}

Matrix Softassign::means(const Matrix& fallback) const {
    Matrix result = fallback;
    for (std::size_t i = 0; i < n_; ++i) {
        float sums[4];
        weighted_sums(weights_.data() + i * stride_, v_.data(), target_.data(), stride_, sums);
        // Less than this is rounding: the point is an outlier and stays where it is.
        if (sums[3] * u_[i] < 1e-6F) continue;
        for (Eigen::Index d = 0; d < dimension_; ++d)
            result(static_cast<Eigen::Index>(i), d) = double{sums[d]} / double{sums[3]};
    }
    return result;
}

Matrix Softassign::matrix() const {
    Matrix result(static_cast<Eigen::Index>(n_), static_cast<Eigen::Index>(m_));
    for (std::size_t i = 0; i < n_; ++i)
        for (std::size_t j = 0; j < m_; ++j)
            result(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
                double{u_[i]} * double{weights_[i * stride_ + j]} * double{v_[j]};
    return result;
}

double Softassign::hardness() const {
    double sum = 0;
    for (std::size_t i = 0; i < n_; ++i) {
        const float* row = weights_.data() + i * stride_;
        float total = tiny, largest = 0;
        for (std::size_t j = 0; j < m_; ++j) {
            const float weight = row[j] * v_[j];
            total += weight;
            largest = std::max(largest, weight);
        }
        sum += double{largest / total};
    }
    return n_ > 0 ? sum / static_cast<double>(n_) : 1;
}

}  // namespace counterpart::align
