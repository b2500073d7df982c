// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "numerics/nearest_neighbors.hpp"
#include "support/edited_map.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/map/invert.hpp>
#include <counterpart/map/project.hpp>
#include <counterpart/mesh/shapes.hpp>
#include <counterpart/mesh/variants.hpp>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace counterpart {
namespace {

// Two triangulations of one sphere, and for each vertex of the first the closest one of the second.
struct Spheres {
    TriangleMesh source = make_icosphere(3), target = make_icosphere(3);
    VertexMap map;
    Spheres() {
        const Eigen::Matrix3d turn =
            Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
        target.vertices = (target.vertices * turn.transpose()).eval();
        const numerics::NearestNeighbors neighbors(target.vertices);
        std::vector<Index> image;
        for (Index v = 0; v < source.n_vertices(); ++v)
            image.push_back(neighbors.closest(source.vertices.row(v)).index);
        map = VertexMap(std::move(image), target.n_vertices());
    }
};

double mean_distance(const Points& a, const Points& b) { return (a - b).rowwise().norm().mean(); }

TEST(ProjectMap, IsCloserThanTheVertices) {
    const Spheres s;
    const SurfaceMap points = project_map(s.source, s.target, s.map);
    require_valid(points, s.source.n_vertices(), s.target.n_triangles());
    const double by_vertices =
        mean_distance(image_positions(surface_map_of(s.map, s.target), s.target), s.source.vertices);
    EXPECT_LT(mean_distance(image_positions(points, s.target), s.source.vertices), by_vertices / 2);
}

TEST(ProjectMap, OneConnectivityStaysOnTheVertices) {
    const TriangleMesh source = make_body({.subdivisions = 1});
    const ShuffleResult copy = shuffle(source, 4);
    const VertexMap map{copy.shuffled_from_original, source.n_vertices()};
    const SurfaceMap points = project_map(source, copy.mesh, map);
    EXPECT_EQ(nearest_corners(points, copy.mesh), map);
    EXPECT_EQ(image_positions(points, copy.mesh), source.vertices);
    const SurfaceMap back = invert(points, source, copy.mesh);
    EXPECT_EQ(nearest_corners(back, source), invert(map));
}

TEST(ProjectMap, UnmatchedStaysUnmatched) {
    Spheres s;
    s.map = test::with_image(s.map, 7, VertexMap::unmatched);
    const SurfaceMap points = project_map(s.source, s.target, s.map);
    EXPECT_FALSE(points[7].matched());
    EXPECT_EQ(count_matched(points), s.source.n_vertices() - 1);
}

TEST(Invert, ThereAndBackIsNear) {
    const Spheres s;
    const SurfaceMap there = project_map(s.source, s.target, s.map);
    const SurfaceMap back = invert(there, s.source, s.target);
    require_valid(back, s.target.n_vertices(), s.source.n_triangles());
    EXPECT_EQ(count_matched(back), s.target.n_vertices());
    // A smooth function carried to the target and back comes back nearly unchanged.
    const Matrix carried = transfer_values(back, s.source, s.source.vertices);
    const Matrix returned = transfer_values(there, s.target, carried);
    EXPECT_LT((returned - s.source.vertices).norm() / s.source.vertices.norm(), 0.01);
}

TEST(Invert, WhatTheMapLeavesOutIsUnmatched) {
    Spheres s;
    s.map = test::edited(s.map, [&](std::vector<Index>& image) {
        for (Index v = 0; v < s.source.n_vertices(); ++v)
            if (s.source.vertices(v, 2) < 0) image[static_cast<std::size_t>(v)] = VertexMap::unmatched;
    });
    const SurfaceMap back = invert(project_map(s.source, s.target, s.map), s.source, s.target);
    for (Index w = 0; w < s.target.n_vertices(); ++w) {
        const double height = s.target.vertices(w, 2);
        if (std::abs(height + 0.15) > 0.35) {
            EXPECT_EQ(back[w].matched(), height > 0) << w;
        }
    }
}

TEST(ProjectMap, ExtendGivesHolesTheirPlace) {
    Spheres s;
    s.map = test::edited(s.map, [](std::vector<Index>& image) {
        for (std::size_t v = 0; v < image.size(); v += 3) image[v] = VertexMap::unmatched;
    });
    const SurfaceMap points = project_map(s.source, s.target, s.map, {.extend = 2});
    EXPECT_EQ(count_matched(points), s.source.n_vertices());
    EXPECT_LT(mean_distance(image_positions(points, s.target), s.source.vertices), 0.02);
}

TEST(ProjectMap, SameBytesForAnyNumberOfThreads) {
    const Spheres s;
    EXPECT_EQ(project_map(s.source, s.target, s.map, {.n_threads = 1}),
              project_map(s.source, s.target, s.map, {.n_threads = 3}));
}

TEST(ProjectMap, RefusesBadMapsAndOptions) {
    const Spheres s;
    EXPECT_THROW(project_map(s.source, s.target, s.map, {.rings = 0}), InvalidInput);
    EXPECT_THROW(project_map(s.source, s.target, identity_map(3)), InvalidInput);
    // A map onto a mesh of one vertex more, even where it takes no vertex there.
    const Index more = s.target.n_vertices() + 1;
    EXPECT_THROW(project_map(s.source, s.target, {s.map.image(), more}), InvalidInput);
    EXPECT_THROW(project_map(s.source, s.target, test::with_image({s.map.image(), more}, 0, more - 1)),
                 InvalidInput);
}

}  // namespace
}  // namespace counterpart
