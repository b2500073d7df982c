// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/types.hpp>

#include <cstddef>
#include <numeric>
#include <vector>

namespace counterpart::mesh {

/// Union-find with path halving; the root of a set is its smallest member. Members may carry a parity
/// relative to their root, to tell whether a set can be two-colored.
class DisjointSets {
  public:
    explicit DisjointSets(Index count)
        : parent_(static_cast<std::size_t>(count)), odd_(static_cast<std::size_t>(count), 0) {
        std::iota(parent_.begin(), parent_.end(), 0);
    }

    Index root(Index x) {
        for (; parent(x) != x; x = parent(x)) {  // each member on the way is hung one higher
            const Index up = parent(x);
            odd(x) = static_cast<char>(odd(x) ^ odd(up));
            parent(x) = parent(up);
        }
        return x;
    }

    /// Joins the sets of a and b, which get different colors if `differ`, else equal ones. False if they are
    /// already in one set with colors that contradict this.
    bool join(Index a, Index b, bool differ = false) {
        const Index ra = root(a), rb = root(b);
        const bool parity = (parity_to_root(a) ^ parity_to_root(b) ^ differ) != 0;
        if (ra == rb) return !parity;
        const Index low = ra < rb ? ra : rb, high = ra < rb ? rb : ra;
        parent(high) = low;
        odd(high) = static_cast<char>(parity);
        return true;
    }

    /// Whether x has another color than its root.
    bool is_odd(Index x) { return parity_to_root(x); }

  private:
    Index& parent(Index x) { return parent_[static_cast<std::size_t>(x)]; }
    char& odd(Index x) { return odd_[static_cast<std::size_t>(x)]; }
    bool parity_to_root(Index x) {
        bool parity = false;
        for (; parent(x) != x; x = parent(x)) parity ^= odd(x) != 0;
        return parity;
    }

    std::vector<Index> parent_;
    std::vector<char> odd_;  // color differs from the parent's; 0 for roots
};

}  // namespace counterpart::mesh
