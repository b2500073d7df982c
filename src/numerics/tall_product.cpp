// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "numerics/tall_product.hpp"

#include "base/parallel.hpp"
#include "numerics/simd.hpp"
#include "numerics/widest.hpp"

#include <algorithm>
#include <vector>

namespace counterpart::numerics {
namespace {

constexpr Eigen::Index group = 8;              // columns of b that are taken at once
constexpr Eigen::Index columns_per_task = 64;  // of a, in a^T * b
constexpr Eigen::Index rows_per_task = 256;    // of a, in a * b: they fit in the second-level cache
constexpr Eigen::Index rows_at_a_time = 2048;  // of b, in a^T * b: eight columns of them fit there too

// b cut into groups of columns, each stored row by row, the last one padded with zeros.
struct Groups {
    Eigen::Index rows, count;
    std::vector<double> data;

    explicit Groups(const Eigen::MatrixXd& b)
        : rows(b.rows()),
          count((b.cols() + group - 1) / group),
          data(static_cast<std::size_t>(rows * count * group), 0.0) {
        for (Eigen::Index j = 0; j < b.cols(); ++j)
            for (Eigen::Index k = 0; k < rows; ++k) at(j / group, k)[j % group] = b(k, j);
    }
    double* at(Eigen::Index g, Eigen::Index row) { return data.data() + (g * rows + row) * group; }
    const double* at(Eigen::Index g, Eigen::Index row) const {
        return data.data() + (g * rows + row) * group;
    }
};

// sums[c][j] += sum over n rows of column c of a times column j of a group.
template <int lanes, int columns>
[[gnu::always_inline]] inline void add_dot_products(const double* a, Eigen::Index stride, const double* b,
                                                    Eigen::Index n, double* sums) {
    using Doubles = typename Simd<lanes>::Doubles;
    constexpr int n_vectors = group * 2 / lanes;  // vectors of a row of the group
    Doubles sum[columns][n_vectors];
    __builtin_memcpy(sum, sums, sizeof sum);
    for (Eigen::Index k = 0; k < n; ++k) {
        Doubles row[n_vectors];
        for (int w = 0; w < n_vectors; ++w)
            row[w] = *reinterpret_cast<const typename Simd<lanes>::DoublesAnywhere*>(b + k * group +
                                                                                     w * (lanes / 2));
        for (int c = 0; c < columns; ++c)
            for (int w = 0; w < n_vectors; ++w) sum[c][w] += a[c * stride + k] * row[w];
    }
    __builtin_memcpy(sums, sum, sizeof sum);
}

// Columns [first, last) of a with a group of columns of b: rows of the result, row by row.
struct DotProducts {
    template <int lanes>
    [[gnu::always_inline]] static void run(const TallMatrix& a, const Groups& b, Eigen::Index g,
                                           Eigen::Index first, Eigen::Index last, double* result) {
        constexpr int tile = lanes / 2;  // columns whose sums fit in the registers
        const Eigen::Index stride = a.outerStride();
        for (Eigen::Index start = 0; start < a.rows(); start += rows_at_a_time) {
            const Eigen::Index n = std::min(rows_at_a_time, a.rows() - start);
            Eigen::Index c = first;
            for (; c + tile <= last; c += tile)
                add_dot_products<lanes, tile>(a.data() + c * stride + start, stride, b.at(g, start), n,
                                              result + (c - first) * group);
            for (; c < last; ++c)
                add_dot_products<lanes, 1>(a.data() + c * stride + start, stride, b.at(g, start), n,
                                           result + (c - first) * group);
        }
    }
};

// Rows of a * b: as many as `n_vectors` vectors hold, of one group of columns.
template <int lanes, int n_vectors>
[[gnu::always_inline]] inline void combine(const double* a, Eigen::Index stride, const double* b,
                                           Eigen::Index inner, double* result) {
    using Doubles = typename Simd<lanes>::Doubles;
    Doubles sum[group][n_vectors] = {};
    for (Eigen::Index k = 0; k < inner; ++k) {
        Doubles column[n_vectors];
        for (int w = 0; w < n_vectors; ++w)
            column[w] = *reinterpret_cast<const typename Simd<lanes>::DoublesAnywhere*>(a + k * stride +
                                                                                        w * (lanes / 2));
        for (Eigen::Index j = 0; j < group; ++j)
            for (int w = 0; w < n_vectors; ++w) sum[j][w] += column[w] * b[k * group + j];
    }
    __builtin_memcpy(result, sum, sizeof sum);
}

// `n` rows of a * b from `first` on, of one group of columns: column by column.
struct Combinations {
    template <int lanes>
    [[gnu::always_inline]] static void run(const TallMatrix& a, const Groups& b, Eigen::Index g,
                                           Eigen::Index first, Eigen::Index n, Eigen::MatrixXd& result) {
        constexpr int n_vectors = lanes == 16 ? 2 : 1;  // as many vectors as the registers hold sums of
        constexpr Eigen::Index tile = n_vectors * lanes / 2;
        const Eigen::Index stride = a.outerStride(), first_column = g * group,
                           n_columns = std::min(group, result.cols() - first_column);
        double sums[group * tile];
        Eigen::Index row = first;
        for (; row + tile <= first + n; row += tile) {
            combine<lanes, n_vectors>(a.data() + row, stride, b.at(g, 0), a.cols(), sums);
            for (Eigen::Index j = 0; j < n_columns; ++j)
                std::copy_n(sums + j * tile, tile, result.data() + (first_column + j) * result.rows() + row);
        }
        for (; row < first + n; ++row)
            for (Eigen::Index j = 0; j < n_columns; ++j) {
                double sum = 0;
                for (Eigen::Index k = 0; k < a.cols(); ++k) sum += a.data()[k * stride + row] * b.at(g, k)[j];
                result(row, first_column + j) = sum;
            }
    }
};

}  // namespace

Eigen::MatrixXd transposed_times(const TallMatrix& a, const Eigen::MatrixXd& b) {
    if (a.size() == 0 || b.size() == 0) return Eigen::MatrixXd::Zero(a.cols(), b.cols());
    const auto dot_products = widest<DotProducts>();
    const Groups groups(b);
    Eigen::MatrixXd result(a.cols(), b.cols());
    const Eigen::Index n_tasks = (a.cols() + columns_per_task - 1) / columns_per_task;
    parallel_for(static_cast<std::size_t>(n_tasks), 1, [&](std::size_t task) {
        const Eigen::Index first = static_cast<Eigen::Index>(task) * columns_per_task,
                           n = std::min(columns_per_task, a.cols() - first);
        for (Eigen::Index g = 0; g < groups.count; ++g) {
            double sums[columns_per_task * group] = {};
            dot_products(a, groups, g, first, first + n, sums);
            for (Eigen::Index j = g * group; j < std::min((g + 1) * group, b.cols()); ++j)
                for (Eigen::Index c = 0; c < n; ++c) result(first + c, j) = sums[c * group + j % group];
        }
    });
    return result;
}

Eigen::MatrixXd times(const TallMatrix& a, const Eigen::MatrixXd& b) {
    if (a.size() == 0 || b.size() == 0) return Eigen::MatrixXd::Zero(a.rows(), b.cols());
    const auto combinations = widest<Combinations>();
    const Groups groups(b);
    Eigen::MatrixXd result(a.rows(), b.cols());
    const Eigen::Index n_tasks = (a.rows() + rows_per_task - 1) / rows_per_task;
    parallel_for(static_cast<std::size_t>(n_tasks), 1, [&](std::size_t task) {
        const Eigen::Index first = static_cast<Eigen::Index>(task) * rows_per_task,
                           n = std::min(rows_per_task, a.rows() - first);
        for (Eigen::Index g = 0; g < groups.count; ++g) combinations(a, groups, g, first, n, result);
    });
    return result;
}

}  // namespace counterpart::numerics
