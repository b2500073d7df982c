// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "numerics/product_search.hpp"

#include "numerics/panels.hpp"
#include "numerics/widest.hpp"

#include <counterpart/base/errors.hpp>

#include <algorithm>
#include <limits>

namespace counterpart::numerics {
namespace {

constexpr Index panels_per_task = 40;                           // of x: they fit in the second-level cache
constexpr float never = std::numeric_limits<float>::max() / 4;  // bias of padding

struct Best {
    std::vector<float> value;
    std::vector<std::int32_t> index;
    explicit Best(std::size_t size) : value(size, -2 * never), index(size, 0) {}
};

// x or y: panels of `width` rows, and the bias of each.
struct Rows {
    Panels panels;
    std::vector<float> bias;

    Rows(const MatrixF& points, const VectorF& biases, Index width)
        : panels(static_cast<Index>(points.rows()), static_cast<Index>(points.cols()), width,
                 [&](Index i, Index d) { return points.coeff(i, d); }),
          bias(static_cast<std::size_t>(panels.count * width), never) {
        std::copy_n(biases.data(), points.rows(), bias.begin());
    }
};

// One task: panels [first, last) of x against all of y.
struct SearchBlock {
    template <int lanes>
    [[gnu::always_inline]] static void run(const Rows& x, const Rows& y, Index first, Index last, Best& rows,
                                           Best& columns) {
        using Floats = typename Simd<lanes>::Floats;
        using Ints = typename Simd<lanes>::Ints;
        using FloatsAnywhere = typename Simd<lanes>::FloatsAnywhere;
        using IntsAnywhere = typename Simd<lanes>::IntsAnywhere;
        constexpr std::size_t stride = tile_vectors * lanes;
        const auto n_rows = static_cast<std::size_t>(last - first) * tile_rows;
        std::vector<float> row_value(n_rows * stride, -2 * never);
        std::vector<std::int32_t> row_index(n_rows * stride, 0);
        Ints lane{};
        for (int i = 0; i < lanes; ++i) lane[i] = i;

        for (Index q = 0; q < y.panels.count; ++q) {
            Floats column_bias[tile_vectors], column_best[tile_vectors];
            Ints column_index[tile_vectors], here[tile_vectors];
            const auto offset = static_cast<std::size_t>(q) * stride;
            for (int w = 0; w < tile_vectors; ++w) {
                __builtin_memcpy(&column_bias[w],
                                 y.bias.data() + offset + static_cast<std::size_t>(w * lanes),
                                 sizeof(Floats));
                column_best[w] = Floats{} - 2 * never;
                column_index[w] = Ints{};
                here[w] = lane + (q * y.panels.width + w * lanes);
            }
            for (Index p = first; p < last; ++p) {
                Tile<lanes> sum = {};
                add_products<lanes>(x.panels.panel(p), y.panels.panel(q), x.panels.inner, sum);
                for (int r = 0; r < tile_rows; ++r) {
                    const Index row = p * tile_rows + r;
                    const float row_bias = x.bias[static_cast<std::size_t>(row)];
                    const auto slot = static_cast<std::size_t>((p - first) * tile_rows + r) * stride;
                    for (int w = 0; w < tile_vectors; ++w) {
                        const Floats for_row = sum[r][w] - column_bias[w], for_column = sum[r][w] - row_bias;
                        const auto at = slot + static_cast<std::size_t>(w * lanes);
                        FloatsAnywhere& best = *reinterpret_cast<FloatsAnywhere*>(row_value.data() + at);
                        IntsAnywhere& partner = *reinterpret_cast<IntsAnywhere*>(row_index.data() + at);
                        const Ints row_wins = for_row > best;
                        best = row_wins ? for_row : best;
                        partner = row_wins ? here[w] : partner;
                        const Ints column_wins = for_column > column_best[w];
                        column_best[w] = column_wins ? for_column : column_best[w];
                        column_index[w] = column_wins ? Ints{} + row : column_index[w];
                    }
                }
            }
            for (int w = 0; w < tile_vectors; ++w) {
                for (int i = 0; i < lanes; ++i) {
                    columns.value[offset + static_cast<std::size_t>(w * lanes + i)] = column_best[w][i];
                    columns.index[offset + static_cast<std::size_t>(w * lanes + i)] = column_index[w][i];
                }
            }
        }
        for (std::size_t r = 0; r < n_rows; ++r) {
            const std::size_t row = static_cast<std::size_t>(first * tile_rows) + r;
            for (std::size_t i = r * stride; i < (r + 1) * stride; ++i) {
                if (row_value[i] > rows.value[row] ||
                    (row_value[i] == rows.value[row] && row_index[i] < rows.index[row])) {
                    rows.value[row] = row_value[i];
                    rows.index[row] = row_index[i];
                }
            }
        }
    }
};

// Nothing is larger than NaN: where all sums are, the padding may win.
void require_below(Eigen::Index size, const std::vector<Index>& partners) {
    if (size > 0 && std::any_of(partners.begin(), partners.end(), [size](Index i) { return i >= size; }))
        throw NumericalError("nearest neighbors: the numbers to compare are not finite");
}

}  // namespace

BestPartners best_partners(const MatrixF& x, const MatrixF& y, const VectorF& row_bias,
                           const VectorF& column_bias) {
    const Rows left(x, row_bias, tile_rows), right(y, column_bias, tile_vectors * vector_lanes());
    const auto n_blocks =
        static_cast<std::size_t>((left.panels.count + panels_per_task - 1) / panels_per_task);
    const auto search_block = widest<SearchBlock>();
    Best rows(left.bias.size());
    std::vector<Best> columns(n_blocks, Best(right.bias.size()));
    parallel_for(n_blocks, 1, [&](std::size_t block) {
        const Index first = static_cast<Index>(block) * panels_per_task,
                    last = std::min(first + panels_per_task, left.panels.count);
        search_block(left, right, first, last, rows, columns[block]);
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
