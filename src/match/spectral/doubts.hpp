// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/spectral/shape.hpp"

#include <string>
#include <vector>

namespace counterpart::spectral_match {

/// Sentences about what the two shapes themselves make doubtful.
std::vector<std::string> doubts(const Shape& source, const Shape& target);

}  // namespace counterpart::spectral_match
