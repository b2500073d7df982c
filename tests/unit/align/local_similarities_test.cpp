// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "align/local_similarities.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace counterpart::align {
namespace {

// Vertices in a row, each joined to the next.
SparseMatrix chain(Index n) {
    std::vector<Eigen::Triplet<double>> entries;
    for (Index v = 0; v + 1 < n; ++v) {
        entries.emplace_back(v, v + 1, -1);
        entries.emplace_back(v + 1, v, -1);
        entries.emplace_back(v, v, 1);
        entries.emplace_back(v + 1, v + 1, 1);
    }
    SparseMatrix matrix(n, n);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

LocalSimilarity turned(double angle, double scale) {
    return {Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()).toRotationMatrix(), scale};
}

TEST(ContinueInward, SpoiledVerticesTakeWhatIsAroundThem) {
    // The ends turn by 0.2 and 0.6; what is between them is upside down.
    std::vector<LocalSimilarity> similarities(5, turned(3, 0.5));
    similarities.front() = turned(0.2, 1);
    similarities.back() = turned(0.6, 2);
    continue_inward(chain(5), {0, 1, 1, 1, 0}, similarities);
    EXPECT_TRUE(similarities[1].rotation.isApprox(turned(0.2, 1).rotation));
    EXPECT_TRUE(similarities[3].rotation.isApprox(turned(0.6, 1).rotation));
    EXPECT_TRUE(similarities[2].rotation.isApprox(turned(0.4, 1).rotation));
    EXPECT_DOUBLE_EQ(similarities[2].scale, 1.5);
}

TEST(ContinueInward, WithoutARimTheyStay) {
    std::vector<LocalSimilarity> similarities(3, turned(1, 0.7));
    continue_inward(chain(3), {1, 1, 1}, similarities);
    for (const LocalSimilarity& similarity : similarities)
        EXPECT_EQ(similarity.rotation, turned(1, 0.7).rotation);
}

}  // namespace
}  // namespace counterpart::align
