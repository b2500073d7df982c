// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "numerics/product.hpp"

#include "base/parallel.hpp"
#include "numerics/simd.hpp"
#include "numerics/vector_lanes.hpp"

#include <algorithm>
#include <vector>

namespace counterpart::numerics {
namespace {

constexpr Index tile_rows = 6;
constexpr Index inner_block = 256;  // terms summed at a time: their panels fit in the first-level cache

// The left factor cut into panels of `tile_rows` rows, the right one into panels of 2 vectors of columns; in
// a panel the entries of one term of the inner sum lie together. Padded with zeros.
struct Panels {
    Index width, count, inner;
    std::vector<float> data;

    template <class Entry>
    Panels(Index size, Index inner_size, Index panel_width, const Entry& entry)
        : width(panel_width),
          count((size + panel_width - 1) / panel_width),
          inner(inner_size),
          data(static_cast<std::size_t>(count) * static_cast<std::size_t>(width) *
                   static_cast<std::size_t>(inner),
               0.0F) {
        parallel_for(static_cast<std::size_t>(count), 8, [&](std::size_t p) {
            const Index first = static_cast<Index>(p) * width;
            float* out = data.data() + p * static_cast<std::size_t>(width) * static_cast<std::size_t>(inner);
            for (Index k = 0; k < inner; ++k, out += width)
                for (Index i = 0; i < std::min(width, size - first); ++i) out[i] = entry(first + i, k);
        });
    }
    const float* panel(Index p) const {
        return data.data() + static_cast<std::size_t>(p) * static_cast<std::size_t>(width) *
                                 static_cast<std::size_t>(inner);
    }
};

// One panel of columns of the result.
template <int lanes>
[[gnu::always_inline]] inline void multiply_panel(const Panels& left, const Panels& right, Index q,
                                                  MatrixF& result) {
    using Floats = typename Simd<lanes>::Floats;
    constexpr int width = 2;
    const auto rows = static_cast<Index>(result.rows());
    const Index first_column = q * right.width;
    const Index n_columns = std::min(right.width, static_cast<Index>(result.cols()) - first_column);
    for (Index start = 0; start < left.inner; start += inner_block) {
        const Index n = std::min(inner_block, left.inner - start);
        for (Index p = 0; p < left.count; ++p) {
            Floats sum[tile_rows][width] = {};
            const float* a = left.panel(p) + start * tile_rows;
            const float* b = right.panel(q) + start * right.width;
            for (Index k = 0; k < n; ++k, a += tile_rows, b += width * lanes) {
                Floats term[width];
                for (int w = 0; w < width; ++w)
                    term[w] = *reinterpret_cast<const typename Simd<lanes>::FloatsAnywhere*>(b + w * lanes);
                for (int r = 0; r < tile_rows; ++r)
                    for (int w = 0; w < width; ++w) sum[r][w] += a[r] * term[w];
            }
            for (Index r = 0; r < std::min(tile_rows, rows - p * tile_rows); ++r) {
                float* out = &result(p * tile_rows + r, first_column);
                float row[width * lanes];
                __builtin_memcpy(row, sum[r], sizeof row);
                for (Index j = 0; j < n_columns; ++j) out[j] += row[j];
            }
        }
    }
}

using MultiplyPanel = void (*)(const Panels&, const Panels&, Index, MatrixF&);

void multiply_panel_4(const Panels& left, const Panels& right, Index q, MatrixF& result) {
    multiply_panel<4>(left, right, q, result);
}

struct Machine {
    int lanes;
    MultiplyPanel multiply;
};

#ifdef COUNTERPART_WIDE_VECTORS
[[gnu::target("avx2")]] void multiply_panel_8(const Panels& left, const Panels& right, Index q,
                                              MatrixF& result) {
    multiply_panel<8>(left, right, q, result);
}
[[gnu::target("avx512f")]] void multiply_panel_16(const Panels& left, const Panels& right, Index q,
                                                  MatrixF& result) {
    multiply_panel<16>(left, right, q, result);
}
Machine this_machine() {
    if (vector_lanes() == 16) return {16, multiply_panel_16};
    if (vector_lanes() == 8) return {8, multiply_panel_8};
    return {4, multiply_panel_4};
}
#else
Machine this_machine() { return {4, multiply_panel_4}; }
#endif

template <class LeftEntry>
MatrixF multiply(Index rows, Index inner, const LeftEntry& left_entry, const MatrixF& b) {
    const Machine machine = this_machine();
    const auto columns = static_cast<Index>(b.cols());
    const Panels left(rows, inner, tile_rows, left_entry);
    const Panels right(columns, inner, 2 * machine.lanes, [&](Index j, Index k) { return b.coeff(k, j); });
    MatrixF result = MatrixF::Zero(rows, columns);
    parallel_for(static_cast<std::size_t>(right.count), 1,
                 [&](std::size_t q) { machine.multiply(left, right, static_cast<Index>(q), result); });
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
