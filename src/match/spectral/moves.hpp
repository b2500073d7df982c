// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/spectral/contenders.hpp"

namespace counterpart::spectral_match {

/// Stage 4. Limbs that the leader or a map close to it exchanges or leaves halfway: the matching of prominent
/// extremities that it means, and those one exchange away, guide a refinement each; a free one follows, and
/// the best of all go through two more heats. What fits well is left as it is, unless a person has said
/// something, which then guides as well.
Contenders move_extremities(Contenders contenders, const Level& level, const ProgressRange& progress);

}  // namespace counterpart::spectral_match
