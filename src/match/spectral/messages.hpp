// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/spectral/polish.hpp"

#include <counterpart/base/message.hpp>

#include <string>
#include <vector>

namespace counterpart::spectral_match {

/// How a mesh was taken: what was merged, turned, cut, left out. From `fragments` components on it is too
/// fragmented to be treated as one mesh.
std::vector<Message> messages_on(const Preprocessed& mesh, Subject subject, Index fragments);

/// What was noticed in these two shapes, and what makes the match of them doubtful: defects of the inputs,
/// symmetric shapes, a poor score, a close runner-up.
std::vector<Message> messages_on(const Level& whole, const Polished& found);

}  // namespace counterpart::spectral_match
