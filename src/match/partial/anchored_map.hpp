// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/partial/consensus.hpp"

#include <vector>

namespace counterpart::partial_match {

/// Step 4. The target vertex of every source vertex: near the image of its nearest anchor (a source sample
/// with a vote), the one whose distances to the images of the anchors around are most like its own to those
/// anchors. -1 for vertices that no anchor reaches.
std::vector<Index> anchored_map(const Surface& source, const Surface& target, const SampleMap& anchors,
                                const AnchoringTuning& tuning, const ProgressRange& progress = {});

}  // namespace counterpart::partial_match
