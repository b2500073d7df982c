// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include <counterpart/align/tps_rpm.hpp>
#include <counterpart/base/errors.hpp>
#include <counterpart/match/volume.hpp>
#include <counterpart/mesh/shapes.hpp>

#include <cmath>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

// Bent about z: x is the angle along an arc.
TetrahedralMesh bent(TetrahedralMesh solid, double per_length) {
    for (auto row : solid.vertices.rowwise()) {
        const double angle = per_length * row[0], radius = 1 / per_length + row[1];
        row << radius * std::sin(angle), radius * std::cos(angle), row[2];
    }
    return solid;
}

TetrahedralMesh figure() { return fill_with_tetrahedra(make_body({.subdivisions = 1}), 28); }

double share_right(const std::vector<Index>& truth, const VertexMap& map) {
    Index right = 0;
    for (std::size_t v = 0; v < truth.size(); ++v) right += truth[v] == map[static_cast<Index>(v)];
    return static_cast<double>(right) / static_cast<double>(truth.size());
}

VolumeResult exact(const TetrahedralMesh& source, const TetrahedralMesh& target, bool allow_mirror = false) {
    return match_volume(source, target, {.method = MatchMethod::exact, .allow_mirror = allow_mirror});
}

TetrahedralMesh mirrored(TetrahedralMesh solid) {
    solid.vertices.col(0) *= -1;
    solid.tetrahedra.col(0).swap(solid.tetrahedra.col(1));
    return solid;
}

TEST(MatchVolume, RefusesWhatIsInvalid) {
    EXPECT_THROW(match_volume({}, figure()), InvalidInput);
    EXPECT_THROW(match_volume(figure(), figure(), {.method = MatchMethod::nearest}), InvalidInput);
    VolumeOptions excluding;
    excluding.spectral.excluded = {{0, 0}};
    EXPECT_THROW(match_volume(figure(), figure(), excluding), InvalidInput);  // exact would not follow it
}

TEST(MatchVolume, ExactWhateverTheOrderAndThePose) {
    const TetrahedralMesh source = figure();
    const TetrahedralShuffleResult target = shuffle(bent(source, 0.8), 2);
    const VolumeResult result = exact(source, target.mesh);
    ASSERT_TRUE(result.identical) << result.difference;
    EXPECT_EQ(share_right(target.shuffled_from_original, result.target_from_source), 1);
    EXPECT_EQ(result.automorphisms.number, 1U);
    EXPECT_FALSE(result.mirrored);
}

TEST(MatchVolume, ABallIsMatchedAsItLies) {
    const TetrahedralMesh ball = fill_with_tetrahedra(make_icosphere(3), 6);
    const TetrahedralShuffleResult target = shuffle(ball, 2);
    const VolumeResult result = exact(ball, target.mesh);
    ASSERT_TRUE(result.identical) << result.difference;
    EXPECT_EQ(share_right(target.shuffled_from_original, result.target_from_source), 1);
    EXPECT_GT(*result.automorphisms.number, 1U);
}

TEST(MatchVolume, MirrorImagesAreToldApart) {
    const TetrahedralMesh source = figure();
    const TetrahedralShuffleResult target = shuffle(mirrored(source), 2);
    const VolumeResult refused = exact(source, target.mesh);
    EXPECT_FALSE(refused.identical);
    EXPECT_NE(refused.difference.find("mirror image"), std::string::npos) << refused.difference;
    const VolumeResult result = exact(source, target.mesh, true);
    ASSERT_TRUE(result.identical);
    EXPECT_TRUE(result.mirrored);
    EXPECT_EQ(share_right(target.shuffled_from_original, result.target_from_source), 1);
}

TEST(MatchVolume, DifferencesAreNamed) {
    const TetrahedralMesh source = figure();
    TetrahedralMesh target = source;
    target.tetrahedra.conservativeResize(target.n_tetrahedra() - 1, 4);
    EXPECT_NE(exact(source, target).difference.find("tetrahedra"), std::string::npos);
}

// Two blocks that share an edge, a third apart, and a vertex of its own.
TEST(MatchVolume, ComponentsThatTouchAndLooseVertices) {
    const TetrahedralMesh cube{(Points(5, 3) << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0.4, -1, 0.3).finished(),
                               (Tetrahedra(2, 4) << 0, 1, 2, 3, 1, 0, 4, 3).finished()};
    TetrahedralMesh source{Points(13, 3), Tetrahedra(5, 4)};
    source.vertices << cube.vertices, (cube.vertices.rowwise() + Eigen::RowVector3d(5, 0, 0)), 0.3, -3, -1,
        1.2, -2, -1, 9, 9, 9;
    source.tetrahedra << cube.tetrahedra, (cube.tetrahedra.array() + 5).matrix(), 0, 10, 1, 11;
    if (tetrahedron_volumes(source)[4] < 0) source.tetrahedra.row(4) << 0, 1, 10, 11;
    const TetrahedralShuffleResult target = shuffle(source, 8);
    const VolumeResult result = exact(source, target.mesh);
    ASSERT_TRUE(result.identical) << result.difference;
    EXPECT_EQ(result.n_components, 3);
    EXPECT_EQ(share_right(target.shuffled_from_original, result.target_from_source), 1);
}

TEST(MatchVolume, FrontiersWithEdgesAsNeighbors) {
    const TetrahedralMesh source = fill_with_tetrahedra(make_body({.subdivisions = 1}), 20);
    const TetrahedralShuffleResult target = shuffle(bent(source, 0.8), 2);
    const VolumeResult result = match_volume(source, target.mesh, {.method = MatchMethod::frontiers});
    EXPECT_GE(share_right(target.shuffled_from_original, result.target_from_source), 0.995);
}

// Nodes inside are points like others.
TEST(MatchVolume, RobustPointMatchingMovesTheInside) {
    const TetrahedralMesh source = fill_with_tetrahedra(make_icosphere(2), 6), target = bent(source, 0.4);
    const TetrahedralShuffleResult shuffled = shuffle(target, 2);
    const TpsRpmResult result = tps_rpm(source.vertices, shuffled.mesh.vertices);
    const auto distance = [&](const Points& moved) {
        return (moved - target.vertices).rowwise().norm().mean();
    };
    EXPECT_LT(distance(result.transformed), 0.15 * distance(source.vertices));
}

// Cubes of two sizes: vertices do not correspond, so that what a cube's size leaves open is allowed for.
TEST(MatchVolume, OtherTetrahedraOfOneBentSolid) {
    const TriangleMesh surface = make_body({.subdivisions = 1});
    const TetrahedralMesh source = fill_with_tetrahedra(surface, 26);
    const TetrahedralMesh target = bent(fill_with_tetrahedra(surface, 30), 0.8);
    const VolumeResult result = match_volume(
        source, target,
        {.method = MatchMethod::spectral, .spectral_shape = {.basis_size = 60, .n_samples = 200}});
    const Points truth = bent(source, 0.8).vertices;
    const std::vector<Index> on_surface = boundary(source).vertices;
    const auto error = [&](Index v) {
        return (target.vertices.row(result.target_from_source[v]) - truth.row(v)).norm();
    };
    double all = 0, surface_only = 0;
    for (Index v = 0; v < source.n_vertices(); ++v) all += error(v) / source.n_vertices();
    for (const Index v : on_surface) surface_only += error(v) / static_cast<double>(on_surface.size());
    EXPECT_LT(all, 1.5 * surface_only);
    EXPECT_LT(all, 1.5 / 30);  // cubes of the target
}

TEST(MatchVolume, SameBytesForAnyNumberOfThreads) {
    const TetrahedralMesh source = figure();
    const TetrahedralShuffleResult target = shuffle(bent(source, 0.8), 2);
    EXPECT_EQ(match_volume(source, target.mesh, {.n_threads = 1}).target_from_source.image(),
              match_volume(source, target.mesh, {.n_threads = 2}).target_from_source.image());
}

}  // namespace
}  // namespace counterpart
