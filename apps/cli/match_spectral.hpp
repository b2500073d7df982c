// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "known_pairs.hpp"
#include "match_methods.hpp"

#include <counterpart/match/match.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace counterpart::cli {

struct SpectralArguments {
    SpectralOptions options;
    SpectralShapeOptions shape;
    KnownPairsFiles landmarks;
    std::filesystem::path alternatives;  // file; empty: none
    std::filesystem::path cache;         // a folder of prepared shapes; empty: none
    std::vector<std::string> excluded;   // "a:b"
    std::string up, facing;              // "y", "-z", "0,0.7,0.7"; empty: unknown

    /// With the landmarks and the other words read.
    SpectralOptions options_for(const MatchInput& input) const;
    /// What is said here, for match().
    MatchOptions match_options_for(const MatchInput& input) const;
    /// The file of the runner-up of this number, from 1: out.txt is out_1.txt, ...
    std::filesystem::path alternative(std::size_t number) const;
};

/// Messages and report of a result; writes the files that were asked for.
MatchOutcome spectral_outcome(const SpectralArguments& arguments, const SpectralResult& result);

}  // namespace counterpart::cli
