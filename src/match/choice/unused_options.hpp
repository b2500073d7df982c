// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/match/match.hpp>

#include <vector>

namespace counterpart::choice {

/// What is said of the map: the mirrored one is wanted, or one is given to be refined, or pairs are known.
/// Connectivity is not asked then.
bool is_mirror_wanted(const MatchOptions& options);
bool is_map_given(const MatchOptions& options);
bool has_landmarks(const MatchOptions& options);

/// A notice for each option that differs from its default and that the method, as asked for or as chosen,
/// does not use. Throws InvalidInput for what is known of the map where the method cannot follow it.
std::vector<Message> unused_options(const MatchOptions& options, MatchMethod method);

}  // namespace counterpart::choice
