// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/message.hpp>
#include <counterpart/match/match.hpp>

#include <string>
#include <vector>

namespace counterpart {

struct MethodChoice {
    MatchMethod method = MatchMethod::automatic;  ///< that match will take; never automatic
    std::string reason;                           ///< why, as a sentence; empty if it was asked for
    /// A notice (option_not_used) for each of the options that differs from its default and that this method
    /// does not use.
    std::vector<Message> messages;
};

/// Which method will match take? It does not match, so it is cheap: the connectivity is compared, the
/// boundaries are measured. O(V + F) unless the connectivity is nearly the same, then O(F log F).
///
/// What is known of the map (landmarks, excluded, aligned, up, facing) is followed by spectral and partial.
/// The connectivity's map is taken only where it agrees with excluded, aligned, up and facing, and not where
/// landmarks are given. Throws InvalidInput where the method that is asked for, or the only one that is left,
/// cannot follow it, and what match throws for meshes and options; Canceled.
MethodChoice choose_method(MeshView source, MeshView target, const MatchOptions& options = {});

}  // namespace counterpart
