// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "numerics/product.hpp"

#include "numerics/panels.hpp"
#include "numerics/widest.hpp"

namespace counterpart::numerics {
namespace {

constexpr Index inner_block = 256;  // terms summed at a time: their panels fit in the first-level cache

// One panel of columns of the result.
struct MultiplyPanel {
    template <int lanes>
    [[gnu::always_inline]] static void run(const Panels& left, const Panels& right, Index q,
                                           MatrixF& result) {
        const auto rows = static_cast<Index>(result.rows());
        const Index first_column = q * right.width;
        const Index n_columns = std::min(right.width, static_cast<Index>(result.cols()) - first_column);
        for (Index start = 0; start < left.inner; start += inner_block) {
            const Index n = std::min(inner_block, left.inner - start);
            for (Index p = 0; p < left.count; ++p) {
                Tile<lanes> sum = {};
                add_products<lanes>(left.panel(p) + start * tile_rows, right.panel(q) + start * right.width,
                                    n, sum);
                for (Index r = 0; r < std::min(tile_rows, rows - p * tile_rows); ++r) {
                    float* out = &result(p * tile_rows + r, first_column);
                    float row[tile_vectors * lanes];
                    __builtin_memcpy(row, sum[r], sizeof row);
                    for (Index j = 0; j < n_columns; ++j) out[j] += row[j];
                }
            }
        }
    }
};

template <class LeftEntry>
MatrixF multiply(Index rows, Index inner, const LeftEntry& left_entry, const MatrixF& b) {
    const auto columns = static_cast<Index>(b.cols());
    const Panels left(rows, inner, tile_rows, left_entry);
    const Panels right(columns, inner, tile_vectors * vector_lanes(),
                       [&](Index j, Index k) { return b.coeff(k, j); });
    MatrixF result = MatrixF::Zero(rows, columns);
    const auto multiply_panel = widest<MultiplyPanel>();
    parallel_for(static_cast<std::size_t>(right.count), 1,
                 [&](std::size_t q) { multiply_panel(left, right, static_cast<Index>(q), result); });
    return result;
}

}  // namespace

MatrixF product(const MatrixF& a, const MatrixF& b) {
    return multiply(
        static_cast<Index>(a.rows()), static_cast<Index>(a.cols()),
        [&](Index i, Index k) { return a.coeff(i, k); }, b);
}

MatrixF transposed_product(const MatrixF& a, const MatrixF& b) {
    return multiply(
        static_cast<Index>(a.cols()), static_cast<Index>(a.rows()),
        [&](Index i, Index k) { return a.coeff(k, i); }, b);
}

}  // namespace counterpart::numerics
