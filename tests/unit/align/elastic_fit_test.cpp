// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "align/elastic_fit.hpp"

#include "numerics/rotation.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/mesh/shapes.hpp>
#include <counterpart/spectral/eigen_basis.hpp>

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace counterpart::align {
namespace {

double largest_distance(const Points& x, const Points& y) { return (x - y).rowwise().norm().maxCoeff(); }

// An ellipsoid, bent upwards at its ends by `bend`.
TriangleMesh banana(double bend, int n_subdivisions = 3) {
    TriangleMesh mesh = make_icosphere(n_subdivisions);
    for (Index v = 0; v < mesh.n_vertices(); ++v) {
        auto row = mesh.vertices.row(v);
        row = Eigen::RowVector3d(3 * row[0], row[1], 0.8 * row[2] + bend * row[0] * row[0]);
    }
    return mesh;
}

// A surface with what a fit of it needs.
struct Surface {
    TriangleMesh mesh;
    LaplaceBeltrami laplacian;

    explicit Surface(const TriangleMesh& of) : mesh(of), laplacian(laplace_beltrami(of)) {}

    ElasticFit fit(const ElasticFitOptions& options = {}) const {
        return {mesh.vertices, laplacian.stiffness, options};
    }
    // What is longer than `length` is followed.
    Vector pull(double length) const { return laplacian.mass / (length * length); }
};

Eigen::Matrix3d turn_by(double angle) {
    return Eigen::AngleAxisd(angle, Eigen::Vector3d(1, 2, 2).normalized()).toRotationMatrix();
}

TEST(ElasticFit, TurnsMovesAndScalesAsAWhole) {
    const Surface surface(banana(0.4));
    const Points turned = 1.3 * surface.mesh.vertices * turn_by(0.7).transpose();
    const Points target = turned.rowwise() + Eigen::RowVector3d(5, -2, 1);
    Points start = target;
    for (Index v = 0; v < surface.mesh.n_vertices(); v += 3) start.row(v) += Eigen::RowVector3d(0.1, 0, 0.1);
    ElasticFit fit = surface.fit();
    for (const double length : {0.1, 1.0}) {
        fit.forget_rotations();
        EXPECT_EQ(fit(target, surface.pull(length), start, 0), start);
        EXPECT_LT(largest_distance(fit(target, surface.pull(length), start, 60), target), 1e-3) << length;
    }
}

TEST(ElasticFit, FollowsLongFeaturesAndSmoothsShortOnes) {
    const Surface surface(banana(0));
    const TriangleMesh bent = banana(0.6);
    Points rough = bent.vertices;
    for (Index v = 0; v < bent.n_vertices(); ++v) rough.row(v) *= v % 2 == 0 ? 1.04 : 0.96;
    const double noise = largest_distance(rough, bent.vertices);
    ElasticFit fit = surface.fit();
    EXPECT_LT(largest_distance(fit(rough, surface.pull(0.01), rough, 10), rough), 0.05 * noise);
    EXPECT_LT(largest_distance(fit(rough, surface.pull(0.5), rough, 10), bent.vertices), 0.6 * noise);
    EXPECT_GT(largest_distance(fit(rough, surface.pull(50), rough, 10), bent.vertices), 1.5 * noise);
}

TEST(ElasticFit, EndsWhenItHasSettled) {
    const Surface surface(banana(0));
    const Points target = banana(0.6).vertices;
    const auto fitted = [&](double settled, int n_iterations) {
        return surface.fit({.settled = settled})(target, surface.pull(0.5), target, n_iterations);
    };
    EXPECT_EQ(fitted(1e9, 20), fitted(0, 1));
    EXPECT_NE(fitted(1e-3, 20), fitted(0, 1));
    EXPECT_NE(fitted(1e-3, 50), fitted(0, 50));
    EXPECT_LT(largest_distance(fitted(1e-3, 20), fitted(0, 20)), 0.02);
}

TEST(ElasticFit, StrainSeesWhatIsNoSimilarity) {
    const Surface surface(banana(0.4));
    const ElasticFit fit = surface.fit();
    EXPECT_LT(fit.strain(Points(2 * surface.mesh.vertices)), 1e-9);
    const Points half_turned = surface.mesh.vertices * Eigen::Vector3d(-1, -1, 1).asDiagonal();
    EXPECT_LT(fit.strain(half_turned), 1e-9);
    Points flat = surface.mesh.vertices;
    flat.col(2) *= 0.2;
    EXPECT_GT(fit.strain(flat), 0.05);
    EXPECT_LT(fit.strain(banana(0.5).vertices), fit.strain(banana(1.0).vertices));
}

TEST(ElasticFit, AFlatSurfaceMayTurnHalfRound) {
    const Surface grid(make_grid(8, 8));
    ElasticFit fit = grid.fit();
    const Points turned = grid.mesh.vertices * Eigen::Vector3d(-1, -1, 1).asDiagonal();
    EXPECT_LT(fit.strain(turned), 1e-9);
    EXPECT_LT(largest_distance(fit(turned, grid.pull(1), turned, 5), turned), 1e-5);
    EXPECT_EQ(fit.strain(Points(Points::Zero(grid.mesh.n_vertices(), 3))), 1);
}

// The images of a patch are elsewhere; its rim is spoiled as well. Where it does not pull, and turns as its
// surroundings do, it comes to lie where they have gone.
TEST(ElasticFit, IslandsAreCarriedByWhatIsAroundThem) {
    const Surface surface(banana(0.4));
    const Points turned = surface.mesh.vertices * turn_by(2).transpose();
    Eigen::Index tip = 0;
    surface.mesh.vertices.col(0).maxCoeff(&tip);
    Points images = turned;
    Vector pull = surface.pull(0.5);
    std::vector<char> spoiled(static_cast<std::size_t>(surface.mesh.n_vertices()), 0);
    for (Index v = 0; v < surface.mesh.n_vertices(); ++v) {
        const double distance = (surface.mesh.vertices.row(v) - surface.mesh.vertices.row(tip)).norm();
        if (distance < 0.7) images.row(v) *= -1;
        if (distance >= 1) continue;
        spoiled[static_cast<std::size_t>(v)] = 1;
        pull[v] = 0;
    }
    EXPECT_LT(largest_distance(surface.fit()(images, pull, images, 1, {}, spoiled), turned), 1e-5);
    EXPECT_GT(largest_distance(surface.fit()(images, pull, images, 1), turned), 0.1);
}

TEST(ElasticFit, KeptFactorsGiveTheSameBytesAsFreshOnes) {
    const Surface surface(banana(0));
    const Points target = banana(0.6).vertices;
    ElasticFit keeping = surface.fit({.n_kept_factors = 2});
    for (const double length : {0.5, 0.3, 0.5, 0.3, 0.1, 0.3, 0.1, 0.5, 0.5}) {
        keeping.forget_rotations();
        const Points fresh = surface.fit()(target, surface.pull(length), target, 3);
        EXPECT_TRUE(keeping(target, surface.pull(length), target, 3) == fresh) << length;
    }
}

TEST(ElasticFit, GoesOnWithTheRotationsOfTheLastCall) {
    const Surface surface(banana(0));
    const Points target = banana(0.6).vertices;
    const Vector pull = surface.pull(0.5);
    ElasticFit at_once = surface.fit(), step_by_step = surface.fit();
    Points now = target;
    for (int i = 0; i < 4; ++i) now = step_by_step(target, pull, now, 1);
    EXPECT_EQ(now, at_once(target, pull, target, 4));
    step_by_step.forget_rotations();
    EXPECT_EQ(step_by_step(target, pull, target, 4), now);
}

// The same by dense matrices and singular values, in double precision.
class PlainFit {
  public:
    PlainFit(const Points& rest, const SparseMatrix& stiffness, const ScaleBounds& bounds)
        : rest_(rest), stiffness_(stiffness), bounds_(bounds) {}

    Points step(const Points& towards, const Vector& pull, const Points& now) const {
        const std::vector<Eigen::Matrix3d> linear = similarities(now);
        Eigen::MatrixXd matrix = stiffness_, right = pull.asDiagonal() * towards;
        matrix.diagonal() += pull;
        each_edge([&](Index v, Index w, double weight) {
            right.row(v) +=
                weight / 2 * (rest_.row(v) - rest_.row(w)) *
                (linear[static_cast<std::size_t>(v)] + linear[static_cast<std::size_t>(w)]).transpose();
        });
        return Points(matrix.ldlt().solve(right));
    }

    // With the best similarities: each edge seen from both ends, by half.
    double energy(const Points& towards, const Vector& pull, const Points& now) const {
        const std::vector<Eigen::Matrix3d> linear = similarities(now);
        double sum = pull.dot((now - towards).rowwise().squaredNorm());
        each_edge([&](Index v, Index w, double weight) {
            const Eigen::RowVector3d moved =
                (rest_.row(v) - rest_.row(w)) * linear[static_cast<std::size_t>(v)].transpose();
            sum += weight / 2 * (now.row(v) - now.row(w) - moved).squaredNorm();
        });
        return sum;
    }

  private:
    template <class Visit>
    void each_edge(const Visit& visit) const {
        for (Index v = 0; v < rest_.rows(); ++v)
            for (SparseMatrix::InnerIterator it(stiffness_, v); it; ++it)
                if (it.row() != v) visit(v, static_cast<Index>(it.row()), -it.value());
    }

    std::vector<Eigen::Matrix3d> similarities(const Points& now) const {
        std::vector<Eigen::Matrix3d> linear(static_cast<std::size_t>(rest_.rows()), Eigen::Matrix3d::Zero());
        Vector size = Vector::Zero(rest_.rows());
        each_edge([&](Index v, Index w, double weight) {
            const Eigen::RowVector3d before = rest_.row(v) - rest_.row(w);
            linear[static_cast<std::size_t>(v)] += weight * (now.row(v) - now.row(w)).transpose() * before;
            size[v] += weight * before.squaredNorm();
        });
        for (Index v = 0; v < rest_.rows(); ++v) {
            Eigen::Matrix3d& m = linear[static_cast<std::size_t>(v)];
            const Eigen::Matrix3d rotation = numerics::fit_rotation(m).rotation;
            const double scale = (rotation.transpose() * m).trace() / size[v];
            m = std::clamp(scale, bounds_.least, bounds_.largest) * rotation;
        }
        return linear;
    }

    const Points rest_;
    const SparseMatrix stiffness_;
    const ScaleBounds bounds_;
};

struct ElasticFitAndPlainOne : testing::Test {
    const Surface surface{banana(0, 2)};
    const ScaleBounds bounds{0.8, 1.1};  // some neighborhoods are at either end
    const PlainFit plain{surface.mesh.vertices, surface.laplacian.stiffness, bounds};
    const Points towards = 1.05 * banana(0.9, 2).vertices * turn_by(1.5).transpose();
    const Vector pull = surface.pull(0.7);
};

TEST_F(ElasticFitAndPlainOne, ComeToLieInTheSamePlace) {
    for (const int n_iterations : {1, 3, 40}) {
        Points now = towards;
        for (int i = 0; i < n_iterations; ++i) now = plain.step(towards, pull, now);
        const Points found = surface.fit({.scales = bounds})(towards, pull, towards, n_iterations);
        EXPECT_LT(largest_distance(found, now), 1e-4) << n_iterations;
        EXPECT_GT(largest_distance(found, towards), 0.05) << "or this proves nothing";
    }
}

TEST_F(ElasticFitAndPlainOne, LowerTheEnergyEachTime) {
    ElasticFit fit = surface.fit({.scales = bounds});
    Points now = towards;
    double before = plain.energy(towards, pull, now);
    const double first = before;
    for (int i = 0; i < 30; ++i) {
        now = fit(towards, pull, now, 1);
        const double energy = plain.energy(towards, pull, now);
        EXPECT_LE(energy, before + 1e-6 * first) << i;
        before = energy;
    }
    EXPECT_LT(before, 0.8 * first);
}

TEST(ElasticFit, WhatNothingHoldsIsRefusedAndHarmsNothing) {
    const Surface surface(banana(0));
    const Points target = banana(0.6).vertices;
    ElasticFit fit = surface.fit();
    EXPECT_THROW(fit(target, Vector::Zero(target.rows()), target, 1), NumericalError);
    const Points after = fit(target, surface.pull(0.5), target, 3);
    EXPECT_TRUE(after == surface.fit()(target, surface.pull(0.5), target, 3));
}

TEST(ElasticFit, CanBeCanceled) {
    const Surface surface(banana(0, 1));
    WorkState state;
    state.canceled = true;
    EXPECT_THROW(
        surface.fit()(surface.mesh.vertices, surface.pull(1), surface.mesh.vertices, 1, ProgressRange(state)),
        Canceled);
}

}  // namespace
}  // namespace counterpart::align
