// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match_methods.hpp"

#include <string>

namespace counterpart::cli {

/// "about 17 s and 1.3 GB of memory are to be expected from 'spectral'" for meshes of so many vertices each;
/// nothing below ten seconds and for methods that take no time. On two threads of a laptop-class machine:
/// docs/results.md.
std::string expected_cost(const std::string& method, double n_vertices);

/// Says that before a method runs. `condition`: what it depends on, as the beginning of the sentence.
void say_expected_cost(const MatchInput& input, const std::string& method, const std::string& condition = "");

}  // namespace counterpart::cli
