// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/partial/placements.hpp"
#include "match/partial/race.hpp"
#include "support/cuts.hpp"
#include "support/disguise.hpp"

#include <counterpart/mesh/measure.hpp>
#include <counterpart/mesh/shapes.hpp>
#include <counterpart/mesh/variants.hpp>

#include <gtest/gtest.h>

namespace counterpart::partial_match {
namespace {

// Two parts of one body, of which the first was turned and moved.
class PartialPlacements : public testing::Test {
  protected:
    const PartialTuning tuning;
    const TriangleMesh body = make_body({.subdivisions = 1});
    const double height = body.vertices.col(1).mean(), unit = std::sqrt(surface_area(body));
    const Eigen::Matrix3d rotation =
        Eigen::AngleAxisd(2.5, Eigen::Vector3d(1, 2, -1).normalized()).toRotationMatrix();
    const test::PartOfMesh top = test::cut_by_plane(body, {0.2, 1, 0.1}, height - 0.3 * unit),
                           bottom = test::cut_by_plane(body, {0, -1, 0.2}, -height - 0.2 * unit);

    Surface surface_of(TriangleMesh mesh, int n_samples) const {
        mesh.vertices /= unit;
        return {std::move(mesh), n_samples, {}, tuning.surface, {}};
    }
    Surface moved_top(double scale) const {
        TriangleMesh mesh = top.mesh;
        mesh.vertices = ((scale / unit) * mesh.vertices * rotation.transpose()).rowwise() +
                        Eigen::RowVector3d(0.3, -2, 1);
        return {std::move(mesh), 75, {}, tuning.surface, {}};
    }
    Surface fixed_bottom() const { return surface_of(bottom.mesh, 300); }
    // Mean distance of the placed vertices from where they were.
    double error(const Placement& placement, const Surface& part) const {
        double sum = 0;
        for (Index v = 0; v < part.mesh.n_vertices(); ++v) {
            const Eigen::Vector3f x = placement(part.mesh.vertices.row(v).transpose().cast<float>());
            sum += (x.cast<double>() - top.mesh.vertices.row(v).transpose() / unit).norm();
        }
        return sum / part.mesh.n_vertices();
    }
};

TEST_F(PartialPlacements, ThePartComesBackToItsPlace) {
    const Surface part = moved_top(1), whole = fixed_bottom();
    const std::vector<Placement> found = placements(part, whole, 0, {1}, tuning.placement);
    ASSERT_FALSE(found.empty());
    EXPECT_LT(error(found.front(), part), 0.02);
    EXPECT_FLOAT_EQ(found.front().scale, 1);
    for (std::size_t i = 1; i < found.size(); ++i) EXPECT_LE(found[i].score, found[i - 1].score);
}

TEST_F(PartialPlacements, APartOfTheMirrorImageGainsWhatTheOtherReadingLoses) {
    const TriangleMesh chiral = deform(body, {.bend = 0.4, .twist = 0.8});
    const Surface part = surface_of(test::cut_by_plane(chiral, {0.2, 1, 0.1}, height - 0.3 * unit).mesh, 75);
    const TriangleMesh other = test::cut_by_plane(chiral, {0, -1, 0.2}, -height - 0.2 * unit).mesh;
    const Surface whole = surface_of(other, 300), image = surface_of(test::mirrored(other), 300);
    const Placement on_whole = placements(part, whole, 0, {1}, tuning.placement).front(),
                    on_image = placements(part, image, 0, {1}, tuning.placement).front();
    const double gain = gain_in_mirror(part, whole, 0, on_whole, tuning.placement);
    EXPECT_LT(gain, -0.05);
    EXPECT_NEAR(gain_in_mirror(part, image, 0, on_image, tuning.placement), -gain, 0.01);
}

TEST_F(PartialPlacements, OfUnknownScale) {
    EXPECT_NEAR(scale_of_parts(moved_top(0.7), fixed_bottom(), 0, 0.5, 2, tuning) * 0.7, 1, 0.05);
}

}  // namespace
}  // namespace counterpart::partial_match
