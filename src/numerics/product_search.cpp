// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "numerics/product_search.hpp"

#include "base/parallel.hpp"
#include "numerics/simd.hpp"
#include "numerics/vector_lanes.hpp"

#include <counterpart/base/errors.hpp>

#include <algorithm>
#include <limits>

namespace counterpart::numerics {
namespace {

constexpr Index tile_rows = 6;
constexpr Index block_rows =
    40 * tile_rows;  // rows of x that one task takes: they fit in the second-level cache
constexpr float never = std::numeric_limits<float>::max() / 4;  // bias of padding

struct Best {
    std::vector<float> value;
    std::vector<std::int32_t> index;
    explicit Best(std::size_t size) : value(size, -2 * never), index(size, 0) {}
};

// x or y cut into panels of `width` rows, each stored dimension by dimension, padded with zeros.
struct Panels {
    Index width, count, dimension;
    std::vector<float> data;
    std::vector<float> bias;

    Panels(const MatrixF& points, const VectorF& biases, Index panel_width)
        : width(panel_width),
          count((static_cast<Index>(points.rows()) + panel_width - 1) / panel_width),
          dimension(static_cast<Index>(points.cols())),
          data(static_cast<std::size_t>(count) * static_cast<std::size_t>(width) *
                   static_cast<std::size_t>(dimension),
               0.0F),
          bias(static_cast<std::size_t>(count * width), never) {
        for (Index i = 0; i < static_cast<Index>(points.rows()); ++i) {
            float* panel = data.data() + static_cast<std::size_t>(i / width) *
                                             static_cast<std::size_t>(width) *
                                             static_cast<std::size_t>(dimension);
            for (Index d = 0; d < dimension; ++d) panel[d * width + i % width] = points(i, d);
            bias[static_cast<std::size_t>(i)] = biases[i];
        }
    }
    const float* panel(Index p) const {
        return data.data() + static_cast<std::size_t>(p) * static_cast<std::size_t>(width) *
                                 static_cast<std::size_t>(dimension);
    }
};

// One task: rows [first_panel, last_panel) of x against all of y. `lanes` is the width of the machine's
// vectors; the result does not depend on it.
template <int lanes>
[[gnu::always_inline]] inline void search_block(const Panels& x, const Panels& y, Index first_panel,
                                                Index last_panel, Best& rows, Best& columns) {
    using Floats = typename Simd<lanes>::Floats;
    using Ints = typename Simd<lanes>::Ints;
    constexpr int width = 2;  // vectors per tile
    const auto n_rows = static_cast<std::size_t>(last_panel - first_panel) * tile_rows;
    constexpr std::size_t stride = width * lanes;
    std::vector<float> row_value(n_rows * stride, -2 * never);
    std::vector<std::int32_t> row_index(n_rows * stride, 0);
    Ints lane{};
    for (int i = 0; i < lanes; ++i) lane[i] = i;

    for (Index q = 0; q < y.count; ++q) {
        Floats column_bias[width], column_best[width];
        Ints column_index[width], here[width];
        const auto offset = static_cast<std::size_t>(q) * static_cast<std::size_t>(y.width);
        for (int w = 0; w < width; ++w) {
            __builtin_memcpy(&column_bias[w], y.bias.data() + offset + static_cast<std::size_t>(w * lanes),
                             sizeof(Floats));
            column_best[w] = Floats{} - 2 * never;
            column_index[w] = Ints{};
            here[w] = lane + (q * y.width + w * lanes);
        }
        for (Index p = first_panel; p < last_panel; ++p) {
            Floats sum[tile_rows][width] = {};
            const float* a = x.panel(p);
            const float* b = y.panel(q);
            for (Index d = 0; d < x.dimension; ++d, a += tile_rows, b += width * lanes) {
                Floats right[width];
                for (int w = 0; w < width; ++w)
                    right[w] = *reinterpret_cast<const typename Simd<lanes>::FloatsAnywhere*>(b + w * lanes);
                for (int r = 0; r < tile_rows; ++r)
                    for (int w = 0; w < width; ++w) sum[r][w] += a[r] * right[w];
            }
            for (int r = 0; r < tile_rows; ++r) {
                const Index row = p * tile_rows + r;
                const float row_bias = x.bias[static_cast<std::size_t>(row)];
                const auto slot = static_cast<std::size_t>((p - first_panel) * tile_rows + r) * stride;
                for (int w = 0; w < width; ++w) {
                    const Floats for_row = sum[r][w] - column_bias[w], for_column = sum[r][w] - row_bias;
                    typename Simd<lanes>::FloatsAnywhere& best =
                        *reinterpret_cast<typename Simd<lanes>::FloatsAnywhere*>(
                            row_value.data() + slot + static_cast<std::size_t>(w * lanes));
                    typename Simd<lanes>::IntsAnywhere& partner =
                        *reinterpret_cast<typename Simd<lanes>::IntsAnywhere*>(
                            row_index.data() + slot + static_cast<std::size_t>(w * lanes));
                    const Ints row_wins = for_row > best;
                    best = row_wins ? for_row : best;
                    partner = row_wins ? here[w] : partner;
                    const Ints column_wins = for_column > column_best[w];
                    column_best[w] = column_wins ? for_column : column_best[w];
                    column_index[w] = column_wins ? Ints{} + row : column_index[w];
                }
            }
        }
        for (int w = 0; w < width; ++w) {
            for (int i = 0; i < lanes; ++i) {
                columns.value[offset + static_cast<std::size_t>(w * lanes + i)] = column_best[w][i];
                columns.index[offset + static_cast<std::size_t>(w * lanes + i)] = column_index[w][i];
            }
        }
    }
    for (std::size_t r = 0; r < n_rows; ++r) {
        const std::size_t row = static_cast<std::size_t>(first_panel * tile_rows) + r;
        for (std::size_t i = r * stride; i < (r + 1) * stride; ++i) {
            if (row_value[i] > rows.value[row] ||
                (row_value[i] == rows.value[row] && row_index[i] < rows.index[row])) {
                rows.value[row] = row_value[i];
                rows.index[row] = row_index[i];
            }
        }
    }
}

using SearchBlock = void (*)(const Panels&, const Panels&, Index, Index, Best&, Best&);

void search_block_4(const Panels& x, const Panels& y, Index first, Index last, Best& rows, Best& columns) {
    search_block<4>(x, y, first, last, rows, columns);
}

struct Machine {
    int lanes;
    SearchBlock search;
};

#ifdef COUNTERPART_WIDE_VECTORS
[[gnu::target("avx2")]] void search_block_8(const Panels& x, const Panels& y, Index first, Index last,
                                            Best& rows, Best& columns) {
    search_block<8>(x, y, first, last, rows, columns);
}
[[gnu::target("avx512f")]] void search_block_16(const Panels& x, const Panels& y, Index first, Index last,
                                                Best& rows, Best& columns) {
    search_block<16>(x, y, first, last, rows, columns);
}
Machine this_machine() {
    if (vector_lanes() == 16) return {16, search_block_16};
    if (vector_lanes() == 8) return {8, search_block_8};
    return {4, search_block_4};
}
#else
Machine this_machine() { return {4, search_block_4}; }
#endif

// Nothing is larger than NaN: where all sums are, the padding may win.
void require_below(Eigen::Index size, const std::vector<Index>& partners) {
    if (size > 0 && std::any_of(partners.begin(), partners.end(), [size](Index i) { return i >= size; }))
        throw NumericalError("nearest neighbors: the numbers to compare are not finite");
}

}  // namespace

BestPartners best_partners(const MatrixF& x, const MatrixF& y, const VectorF& row_bias,
                           const VectorF& column_bias) {
    const Machine machine = this_machine();
    const Panels left(x, row_bias, tile_rows), right(y, column_bias, 2 * machine.lanes);
    const Index panels_per_block = block_rows / tile_rows;
    const auto n_blocks = static_cast<std::size_t>((left.count + panels_per_block - 1) / panels_per_block);
    Best rows(left.bias.size());
    std::vector<Best> columns(n_blocks, Best(right.bias.size()));
    parallel_for(n_blocks, 1, [&](std::size_t block) {
        const auto first = static_cast<Index>(block) * panels_per_block;
        machine.search(left, right, first, std::min(first + panels_per_block, left.count), rows,
                       columns[block]);
    });
    for (std::size_t block = 1; block < n_blocks; ++block) {
        for (std::size_t j = 0; j < right.bias.size(); ++j) {
            if (columns[block].value[j] <= columns[0].value[j]) continue;
            columns[0].value[j] = columns[block].value[j];
            columns[0].index[j] = columns[block].index[j];
        }
    }
    rows.index.resize(static_cast<std::size_t>(x.rows()));
    if (n_blocks == 0) columns.emplace_back(right.bias.size());
    columns[0].index.resize(static_cast<std::size_t>(y.rows()));
    require_below(y.rows(), rows.index);
    require_below(x.rows(), columns[0].index);
    return {std::move(rows.index), std::move(columns[0].index)};
}

}  // namespace counterpart::numerics
