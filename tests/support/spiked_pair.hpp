// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Two prepared shapes, made once for all tests of a suite.
#pragma once

#include "match/spectral/prepared_shape.hpp"
#include "support/spikes.hpp"

#include <memory>

#include <gtest/gtest.h>

namespace counterpart::test {

/// Two bodies with three spikes each, whose vertices have the same numbers; b is thicker.
class SpikedPair : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        const spectral_match::PreparationOptions options{.n_functions = 100, .n_samples = 300};
        TriangleMesh mesh = three_spikes(3);
        a = std::make_unique<spectral_match::PreparedShape>(spectral_match::prepare(mesh, options));
        mesh.vertices.col(2) *= 1.4;
        b = std::make_unique<spectral_match::PreparedShape>(spectral_match::prepare(mesh, options));
    }
    static void TearDownTestSuite() {
        a.reset();
        b.reset();
    }

    static inline std::unique_ptr<const spectral_match::PreparedShape> a, b;
};

}  // namespace counterpart::test
