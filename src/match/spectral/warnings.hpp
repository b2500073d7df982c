// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/spectral/polish.hpp"

#include <string>
#include <vector>

namespace counterpart::spectral_match {

/// Sentences about what makes the match of these two shapes doubtful: defects of the inputs, symmetric
/// shapes, a poor score, a close runner-up.
std::vector<std::string> warnings(const Level& whole, const Polished& found);

}  // namespace counterpart::spectral_match
