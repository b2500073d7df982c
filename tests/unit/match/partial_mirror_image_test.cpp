// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/partial/mirror_image.hpp"

#include <counterpart/mesh/measure.hpp>
#include <counterpart/mesh/shapes.hpp>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

TEST(PartialMirrorImage, KeepsWhatIsUpAndInFront) {
    const TriangleMesh body = make_body({.subdivisions = 1});
    const Eigen::Vector3d up(1, 2, 0.5), facing(0, -1, 3);
    for (const Eigen::Vector3d& front : {facing, Eigen::Vector3d(0, 0, 0)}) {
        const TriangleMesh image = partial_match::mirror_image(body, up, front);
        EXPECT_LT((image.vertices * up - body.vertices * up).cwiseAbs().maxCoeff(), 1e-12);
        EXPECT_LT((image.vertices * front - body.vertices * front).cwiseAbs().maxCoeff(), 1e-12);
        EXPECT_NEAR(signed_volume(image), signed_volume(body), 1e-12);  // the outside stays outside
        EXPECT_GT((image.vertices - body.vertices).norm(), 1);
        const TriangleMesh again = partial_match::mirror_image(image, up, front);
        EXPECT_LT((again.vertices - body.vertices).norm(), 1e-12);
        EXPECT_EQ(again.triangles, body.triangles);
    }
}

}  // namespace
}  // namespace counterpart
