// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/types.hpp>

namespace counterpart {

/// Where the target's vertices got an attribute from. The three sum to the number of target vertices.
struct Coverage {
    Index carried = 0;  ///< from the source, through the map
    Index filled = 0;   ///< unmatched: from the vertices around them
    Index guessed = 0;  ///< in components without any match: from the nearest vertex that has a match
};

}  // namespace counterpart
