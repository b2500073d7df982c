// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// What the tests of match() share.
#pragma once

#include <counterpart/match/match.hpp>

#include <string>

#include <gtest/gtest.h>

namespace counterpart::test {

/// Options with which the spectral method is quick.
inline MatchOptions quick(MatchMethod method = MatchMethod::automatic) {
    MatchOptions options;
    options.method = method;
    options.spectral_shape = {.basis_size = 60, .n_samples = 200};
    return options;
}

inline void expect_part(const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << text << "\n  does not contain: " << part;
}

inline Index count_unmatched(const VertexMap& map) { return map.source_size() - count_matched(map); }

}  // namespace counterpart::test
