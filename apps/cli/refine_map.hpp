// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "load_map.hpp"
#include "match_methods.hpp"

namespace counterpart::cli {

/// `match --initial`: a map that is given, refined by ZoomOut in both directions. Unmatched vertices are
/// completed first.
MatchOutcome refine_map(const MatchInput& input, const LoadedMap& initial);

}  // namespace counterpart::cli
