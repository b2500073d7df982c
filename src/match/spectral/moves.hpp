// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/spectral/contenders.hpp"

namespace counterpart::spectral_match {

/// Stage 4. Limbs that the leader or a map close to it exchanges or leaves halfway: other matchings of its
/// extremities guide a refinement each, a free one follows, and those that come close to the leader by
/// equation 4 join the race. What fits well is left as it is, unless a person has said something, which then
/// guides as well.
Contenders move_extremities(Contenders contenders, const Level& level, const ProgressRange& progress);

}  // namespace counterpart::spectral_match
