// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "align/local_similarities.hpp"

#include "base/random.hpp"
#include "numerics/rotation.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace counterpart::align {
namespace {

using Triplets = std::vector<Eigen::Triplet<double>>;

void join(Triplets& entries, Index v, Index w, double weight) {
    entries.emplace_back(v, w, -weight);
    entries.emplace_back(w, v, -weight);
    entries.emplace_back(v, v, weight);
    entries.emplace_back(w, w, weight);
}

SparseMatrix square(Index n, const Triplets& entries) {
    SparseMatrix matrix(n, n);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

// Vertices in a row, each joined to the next.
SparseMatrix chain(Index n) {
    Triplets entries;
    for (Index v = 0; v + 1 < n; ++v) join(entries, v, v + 1, 1);
    return square(n, entries);
}

// Every vertex joined to every other one, each pair by another weight.
SparseMatrix all_joined(Index n, Random& random) {
    Triplets entries;
    for (Index v = 0; v < n; ++v)
        for (Index w = v + 1; w < n; ++w) join(entries, v, w, random.uniform(0.2, 2));
    return square(n, entries);
}

Points random_points(Index n, Random& random) {
    return Points(Points::NullaryExpr(n, 3, [&] { return random.uniform(-1, 1); }));
}

Eigen::Quaterniond random_rotation(Random& random) {
    return Eigen::Quaterniond(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1),
                              random.uniform(-1, 1))
        .normalized();
}

Points turned_and_shaken(const Points& rest, Random& random) {
    const Eigen::Matrix3d turn = random_rotation(random).toRotationMatrix();
    return Points(1.3 * rest * turn.transpose() +
                  0.2 * random_points(static_cast<Index>(rest.rows()), random));
}

// In double precision, by singular values.
struct ExactSimilarity {
    Eigen::Matrix3d rotation;
    double scale;
};

ExactSimilarity exact_similarity(const SparseMatrix& stiffness, const Points& rest, const Points& now,
                                 Index v, const ScaleBounds& bounds) {
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    double size = 0;
    for (SparseMatrix::InnerIterator it(stiffness, v); it; ++it) {
        const Eigen::RowVector3d before = rest.row(v) - rest.row(it.row());
        covariance -= it.value() * (now.row(v) - now.row(it.row())).transpose() * before;
        size -= it.value() * before.squaredNorm();
    }
    const Eigen::Matrix3d rotation = numerics::fit_rotation(covariance).rotation;
    const double scale = (rotation.transpose() * covariance).trace() / size;
    return {rotation, std::clamp(scale, bounds.least, bounds.largest)};
}

LocalSimilarity turned(double angle, double scale) {
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()));
    return {turn.cast<float>(), static_cast<float>(scale)};
}

constexpr ScaleBounds wide{0.01, 100};

TEST(LocalSimilarities, AreThoseThatFitBest) {
    Random random(1);
    for (int trial = 0; trial < 20; ++trial) {
        const SparseMatrix stiffness = all_joined(8, random);
        const Points rest = random_points(8, random), now = turned_and_shaken(rest, random);
        const LocalSimilarities found = local_similarities({stiffness, rest}, now, wide);
        for (Index v = 0; v < 8; ++v) {
            const ExactSimilarity exact = exact_similarity(stiffness, rest, now, v, wide);
            const LocalSimilarity& similarity = found[static_cast<std::size_t>(v)];
            EXPECT_LT((similarity.rotation.toRotationMatrix().cast<double>() - exact.rotation).norm(), 1e-5);
            EXPECT_NEAR(similarity.scale, exact.scale, 1e-5);
        }
    }
}

TEST(LocalSimilarities, AreFollowedFromTheOnesBefore) {
    Random random(2);
    for (int trial = 0; trial < 20; ++trial) {
        const SparseMatrix stiffness = all_joined(8, random);
        const Points rest = random_points(8, random), now = turned_and_shaken(rest, random);
        const Springs springs(stiffness, rest);
        LocalSimilarities near = local_similarities(springs, now, wide), far = near;
        for (LocalSimilarity& similarity : near)
            similarity.rotation =
                similarity.rotation * Eigen::AngleAxisf(0.3F, Eigen::Vector3f(1, 2, -2).normalized());
        near = local_similarities(springs, now, wide, near);
        for (LocalSimilarity& similarity : far)
            similarity.rotation =
                similarity.rotation * Eigen::AngleAxisf(2, Eigen::Vector3f(1, 2, -2).normalized());
        for (int call = 0; call < 10; ++call) far = local_similarities(springs, now, wide, far);
        for (Index v = 0; v < 8; ++v) {
            const ExactSimilarity exact = exact_similarity(stiffness, rest, now, v, wide);
            for (const LocalSimilarities* found : {&near, &far}) {
                const LocalSimilarity& similarity = (*found)[static_cast<std::size_t>(v)];
                EXPECT_LT((similarity.rotation.toRotationMatrix().cast<double>() - exact.rotation).norm(),
                          2e-3);
                EXPECT_NEAR(similarity.scale, exact.scale, 1e-4);
            }
        }
    }
}

TEST(LocalSimilarities, KeepTheirScaleWithinBounds) {
    Random random(3);
    const SparseMatrix stiffness = all_joined(5, random);
    const Points rest = random_points(5, random);
    for (const auto& [factor, expected] : {std::pair(0.1, 0.5F), std::pair(1.5, 1.5F), std::pair(10.0, 2.0F)})
        for (const LocalSimilarity& similarity :
             local_similarities({stiffness, rest}, Points(factor * rest), {.least = 0.5, .largest = 2}))
            EXPECT_NEAR(similarity.scale, expected, 1e-5);
}

TEST(LocalSimilarities, AreFiniteWhateverHappens) {
    const SparseMatrix stiffness = chain(4);
    const Points rest = Points::Random(4, 3), on_one_place = Points::Zero(4, 3);
    Points far = 1e30 * rest;
    for (const Points& now : {on_one_place, far}) {
        LocalSimilarities before;
        for (int call = 0; call < 2; ++call) {
            before = local_similarities({stiffness, rest}, now, {0.5, 2}, before);
            for (const LocalSimilarity& similarity : before) {
                EXPECT_TRUE(similarity.linear().allFinite());
                EXPECT_NEAR(similarity.rotation.norm(), 1, 1e-5);
            }
        }
    }
}

TEST(LocalSimilarities, MoveDifferencesByTheMeanOfBothEnds) {
    Random random(4);
    const SparseMatrix stiffness = all_joined(6, random);
    const Points rest = random_points(6, random);
    LocalSimilarities similarities(6);
    for (LocalSimilarity& similarity : similarities)
        similarity = {random_rotation(random).cast<float>(), static_cast<float>(random.uniform(0.5, 2))};
    const Points moved = moved_differences({stiffness, rest}, similarities);
    for (Index v = 0; v < 6; ++v) {
        Eigen::Vector3d expected = Eigen::Vector3d::Zero();
        for (Index w = 0; w < 6; ++w)
            if (w != v)
                expected -= stiffness.coeff(v, w) / 2 *
                            (similarities[static_cast<std::size_t>(v)].linear() +
                             similarities[static_cast<std::size_t>(w)].linear())
                                .cast<double>() *
                            (rest.row(v) - rest.row(w)).transpose();
        EXPECT_LT((moved.row(v).transpose() - expected).norm(), 1e-5);
    }
}

TEST(ContinuedInward, SpoiledVerticesTakeWhatIsAroundThem) {
    // The ends turn by 0.2 and 0.6; what is between them is upside down.
    LocalSimilarities similarities(5, turned(3, 0.5));
    similarities.front() = turned(0.2, 1);
    similarities.back() = turned(0.6, 2);
    const LocalSimilarities continued =
        continued_inward(Springs(chain(5), Points(Points::Random(5, 3))), {0, 1, 1, 1, 0}, similarities);
    const auto expect_turned = [&](std::size_t v, double angle) {
        EXPECT_TRUE(continued[v].rotation.toRotationMatrix().isApprox(
            turned(angle, 1).rotation.toRotationMatrix(), 1e-5F));
    };
    expect_turned(0, 0.2);
    expect_turned(1, 0.2);
    expect_turned(2, 0.4);
    expect_turned(3, 0.6);
    expect_turned(4, 0.6);
    EXPECT_NEAR(continued[2].scale, 1.5, 1e-6);
}

TEST(ContinuedInward, WithoutARimTheyStay) {
    const LocalSimilarities similarities(3, turned(1, 0.7));
    for (const LocalSimilarity& similarity :
         continued_inward(Springs(chain(3), Points(Points::Random(3, 3))), {1, 1, 1}, similarities)) {
        EXPECT_EQ(similarity.rotation.coeffs(), turned(1, 0.7).rotation.coeffs());
        EXPECT_EQ(similarity.scale, 0.7F);
    }
}

}  // namespace
}  // namespace counterpart::align
