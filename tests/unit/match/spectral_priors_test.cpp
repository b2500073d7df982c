// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/priors.hpp"
#include "support/spikes.hpp"

#include <algorithm>
#include <numeric>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace counterpart::spectral_match {
namespace {

PreparedShape spikes_turned_by(double angle) {
    TriangleMesh mesh = test::three_spikes(3);
    mesh.vertices *= Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()).toRotationMatrix().transpose();
    return prepare(mesh, {.n_functions = 20, .n_samples = 200});
}

// What a person's "y is up" has against the map that takes each sample to itself.
double disagreement_on_up(const PreparedShape& a, const PreparedShape& b) {
    std::vector<Index> identity(a.samples.size());
    std::iota(identity.begin(), identity.end(), 0);
    Priors priors;
    priors.directions_a = priors.directions_b = Eigen::Vector3d::UnitY();
    return disagreement(a, b, priors, {identity, identity});
}

TEST(SpectralPriors, ALeaningBodyAgreesOnWhatIsUpAndOneUpsideDownDoesNot) {
    const PreparedShape upright = spikes_turned_by(0), leaning = spikes_turned_by(0.6),
                        upside_down = spikes_turned_by(3.0);
    EXPECT_EQ(disagreement_on_up(upright, upright), 0);
    EXPECT_EQ(disagreement_on_up(upright, leaning), 0);
    EXPECT_GT(disagreement_on_up(upright, upside_down), 1.5);
}

TEST(SpectralPriors, EachDirectionHasToAgree) {
    const PreparedShape upright = spikes_turned_by(0);
    PreparedShape mirrored_in_x = upright;
    mirrored_in_x.mesh.vertices.col(0) *= -1;
    std::vector<Index> identity(upright.samples.size());
    std::iota(identity.begin(), identity.end(), 0);
    Priors priors;
    priors.directions_a = priors.directions_b = Eigen::Matrix3d::Identity();
    const PairedMaps maps{identity, identity};
    EXPECT_EQ(disagreement(upright, upright, priors, maps), 0);
    EXPECT_NEAR(disagreement(upright, mirrored_in_x, priors, maps),
                priors.tuning.direction_weight * (1 + priors.tuning.enough_correlation) / 3, 1e-9)
        << "the other two do not make up for it";
}

TEST(SpectralPriors, WhatIsUpInBIsSoInItsMirrorImage) {
    const PreparedShape shape = spikes_turned_by(0), image = mirrored(shape);
    std::vector<Index> identity(shape.samples.size());
    std::iota(identity.begin(), identity.end(), 0);
    Priors priors;
    priors.directions_a = priors.directions_b = Eigen::Vector3d::UnitX();
    EXPECT_GT(disagreement(shape, image, priors, {identity, identity}), 1.5);
    EXPECT_EQ(disagreement(shape, image, with_mirrored_b(priors), {identity, identity}), 0);
}

TEST(SpectralPriors, SayTheSameFromBToA) {
    const PreparedShape a = spikes_turned_by(0), b = spikes_turned_by(2);
    const Index tip = a.samples.front(), end = b.samples.back();
    Priors priors = make_priors(a, b, VertexPairs{{tip, end}}, VertexPairs{{end, tip}});
    priors.directions_a = Eigen::Vector3d::UnitX();
    priors.directions_b = Eigen::Vector3d::UnitY();
    priors.tuning.excluded_radius = 2;
    EXPECT_EQ(reversed(priors).pins(), (VertexPairs{{end, tip}}));
    std::vector<Index> there(a.samples.size()), back(b.samples.size());
    std::iota(there.begin(), there.end(), 0);
    std::reverse_copy(there.begin(), there.end(), back.begin());
    const double stated = disagreement(a, b, priors, {there, back});
    EXPECT_GT(stated, 10) << "the excluded pair counts";
    EXPECT_NEAR(disagreement(b, a, reversed(priors), {back, there}), stated, 1e-12);
}

TEST(SpectralPriors, WhatSurroundsALandmarkMustAgreeNotTheLandmarkAlone) {
    const PreparedShape shape = spikes_turned_by(0);
    const Index tip = shape.samples.front();
    const Priors priors = make_priors(shape, shape, VertexPairs{{tip, tip}}, {});
    std::vector<Index> map(shape.samples.size());
    std::iota(map.begin(), map.end(), 0);
    EXPECT_EQ(disagreement(shape, shape, priors, {map, map}), 0);
    const VectorF& distances = priors.landmarks[0].from_a;
    const auto farthest = static_cast<Index>(std::max_element(map.begin(), map.end(),
                                                              [&](Index s, Index t) {
                                                                  return distances[shape.samples[at(s)]] <
                                                                         distances[shape.samples[at(t)]];
                                                              }) -
                                             map.begin());
    for (std::size_t s = 1; s < map.size(); ++s) map[s] = farthest;
    EXPECT_GT(disagreement(shape, shape, priors, {map, map}), 1) << "it stays, and all around it goes";
}

}  // namespace
}  // namespace counterpart::spectral_match
