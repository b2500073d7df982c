// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/surface/preprocess.hpp"

#include <counterpart/base/message.hpp>

#include <string>
#include <vector>

namespace counterpart::surface_match {

/// How a mesh was taken: what was merged, turned, cut, left out.
std::vector<Message> notices_on(const Preprocessed& mesh, Subject subject);

/// "1 vertex", "2 vertices".
std::string counted(Index n, const std::string& noun, const std::string& plural);

}  // namespace counterpart::surface_match
