// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// What products in single precision are made of: panels of either factor, and the sums of a tile of them.
#pragma once

#include "base/parallel.hpp"
#include "numerics/simd.hpp"

#include <counterpart/base/types.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace counterpart::numerics {

constexpr Index tile_rows = 6;     ///< of the left factor in a panel
constexpr Index tile_vectors = 2;  ///< of columns of the right one

/// A factor cut into panels of `width` rows (the right one: columns). In a panel the entries of one term of
/// the inner sum lie together. Padded with zeros.
struct Panels {
    Index width, count, inner;
    std::vector<float> data;

    template <class Entry>
    Panels(Index size, Index inner_size, Index panel_width, const Entry& entry)
        : width(panel_width),
          count((size + panel_width - 1) / panel_width),
          inner(inner_size),
          data(static_cast<std::size_t>(count) * panel_size(), 0.0F) {
        parallel_for(static_cast<std::size_t>(count), 8, [&](std::size_t p) {
            const Index first = static_cast<Index>(p) * width;
            float* out = data.data() + p * panel_size();
            for (Index k = 0; k < inner; ++k, out += width)
                for (Index i = 0; i < std::min(width, size - first); ++i) out[i] = entry(first + i, k);
        });
    }
    const float* panel(Index p) const { return data.data() + static_cast<std::size_t>(p) * panel_size(); }

  private:
    std::size_t panel_size() const {
        return static_cast<std::size_t>(width) * static_cast<std::size_t>(inner);
    }
};

template <int lanes>
using Tile = typename Simd<lanes>::Floats[tile_rows][tile_vectors];

/// Adds `n` terms of a panel of either factor to the sums.
template <int lanes>
[[gnu::always_inline]] inline void add_products(const float* left, const float* right, Index n,
                                                Tile<lanes>& sum) {
    for (Index k = 0; k < n; ++k, left += tile_rows, right += tile_vectors * lanes) {
        typename Simd<lanes>::Floats term[tile_vectors];
        for (int w = 0; w < tile_vectors; ++w)
            term[w] = *reinterpret_cast<const typename Simd<lanes>::FloatsAnywhere*>(right + w * lanes);
        for (int r = 0; r < tile_rows; ++r)
            for (int w = 0; w < tile_vectors; ++w) sum[r][w] += left[r] * term[w];
    }
}

}  // namespace counterpart::numerics
