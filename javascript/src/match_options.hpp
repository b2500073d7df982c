// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/match/match.hpp>

#include <string>

namespace counterpart::javascript {

/// The options of JavaScript's `match`, as JSON. Throws InvalidInput naming an option that is not known or
/// has another kind of value.
MatchOptions match_options_of(const std::string& json);

}  // namespace counterpart::javascript
