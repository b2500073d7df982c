// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/exact/island_pairing.hpp"

namespace counterpart {

/// Other pairings of the same islands and orientation: equal islands exchanged, symmetric ones turned, in all
/// combinations until there are `most`; each measured, best first. Single islands are turned first, so that
/// what is left out, where there are more, are combinations that exchange many.
std::vector<Pairing> other_pairings(const MatchedMaps& maps, const Pairing& pairing, bool turned,
                                    std::size_t most);

}  // namespace counterpart
