// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "base/random.hpp"
#include "match/spectral/stored_shape.hpp"
#include "support/disguise.hpp"
#include "support/expect_error.hpp"
#include "support/messages.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/match/spectral.hpp>
#include <counterpart/mesh/shapes.hpp>
#include <counterpart/mesh/variants.hpp>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

using spectral_match::PreparedShape;
using spectral_match::shape_from_bytes;
using spectral_match::to_bytes;

// A proxy already for a small mesh, so that every field is stored.
PreparedShape small_shape() {
    return spectral_match::prepare(make_icosphere(3), {.n_functions = 30, .n_samples = 200},
                                   {.large_mesh = 500, .proxy_size = 300});
}

TEST(SpectralStoredShape, MatchesAsTheShapeThatWasKept) {
    const TriangleMesh mesh = make_icosphere(2);
    const TriangleMesh bent = deform(mesh, {.bend = 1.0, .twist = 0.5});
    const SpectralShapeOptions options{.basis_size = 40, .n_samples = 200};
    const SpectralShape a(mesh, options), b(bent, options);
    const SpectralShape kept_a = SpectralShape::from_bytes(a.to_bytes()),
                        kept_b = SpectralShape::from_bytes(b.to_bytes());
    const SpectralResult expected = match_spectral(a, b), found = match_spectral(kept_a, kept_b);
    EXPECT_EQ(found.target_from_source, expected.target_from_source);
    EXPECT_EQ(found.source_from_target, expected.source_from_target);
    EXPECT_EQ(found.confidence, expected.confidence);
    EXPECT_EQ(test::lines_of(found.messages), test::lines_of(expected.messages));
}

TEST(SpectralStoredShape, TheSameBytesAgain) {
    const PreparedShape shape = small_shape();
    ASSERT_TRUE(shape.full);
    const std::string bytes = to_bytes(shape);
    const PreparedShape kept = shape_from_bytes(bytes);
    EXPECT_EQ(to_bytes(kept), bytes);
    EXPECT_EQ(kept.wave_kernel, shape.wave_kernel);
    EXPECT_EQ(kept.all.functions, shape.all.functions);
    EXPECT_EQ(kept.all.frequencies, shape.all.frequencies);
}

TEST(SpectralStoredShape, RefusesWhatIsNotWhole) {
    const std::string bytes = to_bytes(small_shape());
    const auto refused = [](const std::string& text, const std::string& words) {
        test::expect_error<InvalidInput>([&] { shape_from_bytes(text); }, words);
    };
    refused("", "begins with something else");
    refused("OFF\n0 0 0\n", "begins with something else");
    std::string older = bytes;
    older[bytes.find('\n') - 1] = '0';
    refused(older, "begins with something else");
    refused(bytes + 'x', "something follows it");
    for (std::size_t size = bytes.find('\n') + 1; size < bytes.size(); size += 1 + bytes.size() / 97)
        EXPECT_THROW(shape_from_bytes(std::string_view(bytes).substr(0, size)), InvalidInput) << size;
}

TEST(SpectralStoredShape, OfOtherConstantsIsRefused) {
    spectral_match::PreparationTuning other;
    other.curvature_times[3] *= 2;
    const std::string bytes = to_bytes(small_shape(), other);
    test::expect_error<InvalidInput>([&] { shape_from_bytes(bytes); }, "prepared with other constants");
    EXPECT_NO_THROW(shape_from_bytes(bytes, other));
}

TEST(SpectralStoredShape, EveryConstantCounts) {
    using Tuning = spectral_match::PreparationTuning;
    const std::string bytes = to_bytes(small_shape());
    const auto refused_with = [&](auto change) {
        Tuning other;
        change(other);
        test::expect_error<InvalidInput>([&] { shape_from_bytes(bytes, other); },
                                         "prepared with other constants");
    };
    refused_with([](Tuning& t) { t.min_component_share *= 2; });
    refused_with([](Tuning& t) { ++t.n_distance_samples; });
    refused_with([](Tuning& t) { t.extremity_radius *= 2; });
    refused_with([](Tuning& t) { t.prominent_apart *= 2; });
    refused_with([](Tuning& t) { ++t.max_extremities; });
    for (std::size_t i = 0; i < Tuning().curvature_times.size(); ++i)
        refused_with([&](Tuning& t) { t.curvature_times[i] *= 2; });
    refused_with([](Tuning& t) { ++t.curvature_percentile; });
    refused_with([](Tuning& t) { t.relief_time *= 2; });
    refused_with([](Tuning& t) { ++t.n_relief_steps; });
    refused_with([](Tuning& t) { ++t.large_mesh; });
    refused_with([](Tuning& t) { ++t.proxy_size; });
    refused_with([](Tuning& t) { t.min_proxy_area *= 0.5; });
    refused_with([](Tuning& t) { t.basis_tolerance *= 2; });
    refused_with([](Tuning& t) { ++t.min_local_functions; });
    refused_with([](Tuning& t) { ++t.local_functions_per_eigenfunction; });
    refused_with([](Tuning& t) { t.local_radius *= 2; });
}

// Whatever a byte is changed to: refused, or a shape whose numbers are in range, which can be matched.
TEST(SpectralStoredShape, DamageIsRefusedOrHarmless) {
    const std::string bytes = to_bytes(small_shape());
    Random random(5);
    int n_refused = 0;
    for (int round = 0; round < 300; ++round) {
        std::string damaged = bytes;
        // Half of them in front, where the sizes and the numbers of vertices are.
        const std::size_t end = round % 2 == 0 ? bytes.size() : bytes.size() / 20;
        damaged[random.below(end)] = static_cast<char>(random.below(256));
        try {
            EXPECT_EQ(to_bytes(shape_from_bytes(damaged)), damaged);
        } catch (const InvalidInput&) {
            ++n_refused;
        }
    }
    EXPECT_GT(n_refused, 20);
}

}  // namespace
}  // namespace counterpart
