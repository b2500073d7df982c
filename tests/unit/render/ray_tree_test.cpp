// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "render/ray_tree.hpp"

#include "base/random.hpp"

#include <counterpart/mesh/shapes.hpp>

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

namespace counterpart::render {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

Eigen::Vector3f random_point(Random& random, double size) {
    return {static_cast<float>(random.uniform(-size, size)), static_cast<float>(random.uniform(-size, size)),
            static_cast<float>(random.uniform(-size, size))};
}

Ray random_ray(Random& random) {
    const Eigen::Vector3f from = random_point(random, 3), to = random_point(random, 1);
    return {from, (to - from).normalized(), 0, infinity};
}

// Triangles, balls and tubes, some of them in one place.
std::vector<Shape> random_shapes(Random& random, int count) {
    std::vector<Shape> shapes;
    for (int i = 0; i < count; ++i) {
        const Eigen::Vector3f at = random_point(random, 1);
        Shape shape{at, at + random_point(random, 0.3), at + random_point(random, 0.3)};
        if (i % 3 != 0) shape.radius = static_cast<float>(random.uniform(0.01, 0.1));
        if (i % 3 == 1) shape.b = shape.a;
        shapes.push_back(shape);
        if (i % 10 == 0) shapes.push_back(shape);
    }
    return shapes;
}

float distance_to_segment(const Eigen::Vector3f& point, const Shape& shape) {
    const Eigen::Vector3f axis = shape.b - shape.a;
    const float square = axis.squaredNorm();
    const float along = square > 0 ? std::clamp((point - shape.a).dot(axis) / square, 0.0F, 1.0F) : 0.0F;
    return (point - shape.a - along * axis).norm();
}

TEST(RayTree, FindsWhatEachShapeByItselfSays) {
    Random random(1);
    const std::vector<Shape> shapes = random_shapes(random, 100);
    const RayTree tree(shapes);
    int n_met = 0;
    for (int i = 0; i < 500; ++i) {
        const Ray ray = random_ray(random);
        float nearest = infinity;
        for (const Shape& shape : shapes)
            if (const auto met = RayTree({shape}).first(ray)) nearest = std::min(nearest, met->t);
        const auto met = tree.first(ray);
        ASSERT_EQ(met.has_value(), nearest < infinity) << i;
        EXPECT_EQ(tree.meets_any(ray), met.has_value()) << i;
        if (!met) continue;
        ++n_met;
        EXPECT_EQ(met->t, nearest) << i;
        EXPECT_FALSE(tree.meets_any({ray.origin, ray.direction, 0, 0.999F * met->t})) << i;
        EXPECT_TRUE(tree.meets_any({ray.origin, ray.direction, 0.999F * met->t, 1.001F * met->t})) << i;
    }
    EXPECT_GT(n_met, 50);
    EXPECT_LT(n_met, 490);
}

TEST(RayTree, WhatIsMetLiesOnTheShape) {
    Random random(2);
    const std::vector<Shape> shapes = random_shapes(random, 200);
    const RayTree tree(shapes);
    for (int i = 0; i < 2000; ++i) {
        const Ray ray = random_ray(random);
        const auto met = tree.first(ray);
        if (!met) continue;
        const Eigen::Vector3f point = ray.origin + met->t * ray.direction;
        const Shape& shape = shapes[met->shape];
        if (shape.radius > 0) {
            EXPECT_NEAR(distance_to_segment(point, shape), shape.radius, 1e-5F) << i;
            if (distance_to_segment(ray.origin, shape) > shape.radius) {  // seen from outside
                EXPECT_LT(met->normal.dot(ray.direction), 1e-4F) << i;
            }
        } else {
            const Eigen::Vector3f same =
                (1 - met->u - met->v) * shape.a + met->u * shape.b + met->v * shape.c;
            EXPECT_LT((point - same).norm(), 1e-4F) << i;
            EXPECT_GE(std::min({met->u, met->v, 1 - met->u - met->v}), -1e-5F) << i;
            const Eigen::Vector3f normal = (shape.b - shape.a).cross(shape.c - shape.a);
            EXPECT_LT((met->normal - normal).norm(), 1e-4F) << i;
        }
    }
}

// Whether a ray that comes near a tube meets it.
TEST(RayTree, RoundedShapesHaveNoHolesAndNoExcess) {
    Random random(3);
    for (int i = 0; i < 400; ++i) {
        const Shape shape = random_shapes(random, 3).at(i % 2 == 0 ? 2 : 3);
        ASSERT_GT(shape.radius, 0);
        const Ray ray = random_ray(random);
        float least = infinity;  // between ray and axis
        for (int k = 0; k <= 400; ++k) {
            const Eigen::Vector3f at =
                shape.a + static_cast<float>(k) / 400 * (shape.b - shape.a) - ray.origin;
            least = std::min(least, (at - std::max(0.0F, at.dot(ray.direction)) * ray.direction).norm());
        }
        if (std::abs(least - shape.radius) < 1e-4F) continue;
        EXPECT_EQ(RayTree({shape}).meets_any(ray), least < shape.radius) << i;
    }
}

TEST(RayTree, NoRayPassesBetweenTrianglesOfAClosedSurface) {
    const TriangleMesh sphere = make_icosphere(3);
    std::vector<Shape> shapes;
    const auto corner = [&](Index t, int k) -> Eigen::Vector3f {
        return sphere.vertices.row(sphere.triangles(t, k)).transpose().cast<float>();
    };
    for (Index t = 0; t < sphere.n_triangles(); ++t)
        shapes.push_back({corner(t, 0), corner(t, 1), corner(t, 2)});
    const RayTree tree(shapes);
    for (Index t = 0; t < sphere.n_triangles(); ++t)
        for (int k = 0; k < 3; ++k)
            for (const float along : {0.0F, 0.25F, 0.5F}) {  // a vertex, points of an edge
                const Eigen::Vector3f to = (1 - along) * corner(t, k) + along * corner(t, (k + 1) % 3);
                const Eigen::Vector3f from(0.1F, -0.2F, 0.05F);  // inside
                EXPECT_TRUE(tree.first({from, (to - from).normalized(), 0, infinity})) << t;
            }
}

TEST(RayTree, NothingAndFlatThings) {
    const RayTree nothing({});
    EXPECT_FALSE(nothing.first({Eigen::Vector3f::Zero(), Eigen::Vector3f::UnitX(), 0, infinity}));
    EXPECT_TRUE(nothing.box().isEmpty());
    // A thousand triangles in one place, one without area: the first of them counts, and the tree is not
    // deep.
    std::vector<Shape> same(1000, Shape{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    same[500].c = same[500].b;
    const auto met = RayTree(same).first({{0.25F, 0.25F, 1}, -Eigen::Vector3f::UnitZ(), 0, infinity});
    ASSERT_TRUE(met);
    EXPECT_EQ(met->t, 1);
    EXPECT_FALSE(RayTree({same[500]}).first({{0.5F, 0, 1}, -Eigen::Vector3f::UnitZ(), 0, infinity}));
}

}  // namespace
}  // namespace counterpart::render
