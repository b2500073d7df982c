// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/character.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace counterpart::test {
namespace {

using Point = Eigen::RowVector3d;

// A joint and the piece of the body, from it to `tip`, that follows it.
struct Bone {
    Joint joint;
    Point tip;
};

std::vector<Bone> bones() {
    return {{{"hips", -1, {0, .30, 0}}, {0, .42, 0}},       {{"chest", 0, {0, .48, 0}}, {0, .62, 0}},
            {{"head", 1, {0, .70, 0}}, {0, .90, 0}},        {{"arm_left", 1, {.2, .6, 0}}, {.5, .6, 0}},
            {{"arm_right", 1, {-.2, .6, 0}}, {-.5, .6, 0}}, {{"leg_left", 0, {.1, .24, 0}}, {.1, 0, 0}},
            {{"leg_right", 0, {-.1, .24, 0}}, {-.1, 0, 0}}, {{"tail", 0, {0, .3, -.1}}, {0, .35, -.3}}};
}

template <class Values>
Values as_floats(const Values& values) {
    return values.template cast<float>().template cast<double>();
}

double squared_distance(const Point& point, const Point& from, const Point& to) {
    const Point along = to - from;
    const double t = std::clamp((point - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
    return (point - from - t * along).squaredNorm();
}

// The closer the bone, the more weight.
SkinBinding bind(const Points& vertices, const std::vector<Bone>& skeleton) {
    constexpr Eigen::Index influences = 4;
    SkinBinding skin;
    skin.joints.setZero(vertices.rows(), influences);
    skin.weights.setZero(vertices.rows(), influences);
    for (Eigen::Index v = 0; v < vertices.rows(); ++v) {
        std::vector<std::pair<double, Index>> heaviest;
        for (const Bone& bone : skeleton) {
            const double d = squared_distance(vertices.row(v), bone.joint.position, bone.tip);
            heaviest.emplace_back(-1 / (d * d + 1e-7), static_cast<Index>(heaviest.size()));
        }
        std::sort(heaviest.begin(), heaviest.end());
        for (Eigen::Index k = 0; k < influences; ++k) {
            skin.weights(v, k) = -heaviest[static_cast<std::size_t>(k)].first;
            skin.joints(v, k) = heaviest[static_cast<std::size_t>(k)].second;
        }
        skin.weights.row(v) /= skin.weights.row(v).sum();
    }
    skin.weights = as_floats(skin.weights);
    return skin;
}

// Moves what lies around `center` by `move`, and away from there by `swell` times the distance.
MorphTarget blend_shape(const std::string& name, const Points& vertices, const Point& center, double radius,
                        const Point& move, double swell) {
    MorphTarget morph{name, Points::Zero(vertices.rows(), 3)};
    for (Eigen::Index v = 0; v < vertices.rows(); ++v) {
        const Point offset = vertices.row(v) - center;
        const double share = 1 - offset.squaredNorm() / (radius * radius);
        if (share > 0) morph.displacements.row(v) = share * share * (move + swell * offset);
    }
    morph.displacements = as_floats(morph.displacements);
    return morph;
}

// Front and back side by side, seen from in front and from behind. A triangle is on the side of its middle.
CornerAttribute unwrap(const TriangleMesh& mesh) {
    const Point low = mesh.vertices.colwise().minCoeff(), high = mesh.vertices.colwise().maxCoeff();
    const double scale = 0.96 / std::max(2 * (high[0] - low[0]), high[1] - low[1]);
    std::map<std::pair<Index, bool>, Index> row_of;
    std::vector<std::array<double, 2>> rows;
    CornerAttribute coordinates{{}, Triangles(mesh.n_triangles(), 3)};
    for (Index t = 0; t < mesh.n_triangles(); ++t) {
        const bool front = mesh.vertices(mesh.triangles.row(t), 2).sum() > 0;
        for (int c = 0; c < 3; ++c) {
            const Index v = mesh.triangles(t, c);
            const auto [row, is_new] = row_of.try_emplace({v, front}, static_cast<Index>(rows.size()));
            if (is_new) {
                const double across = front ? mesh.vertices(v, 0) - low[0] : high[0] - mesh.vertices(v, 0);
                rows.push_back(
                    {(front ? 0.01 : 0.51) + scale * across, 0.99 - scale * (mesh.vertices(v, 1) - low[1])});
            }
            coordinates.corners(t, c) = row->second;
        }
    }
    coordinates.values = Eigen::Map<const Matrix>(rows.front().data(), static_cast<Index>(rows.size()), 2);
    coordinates.values = as_floats(coordinates.values);
    return coordinates;
}

// Lighter the higher, one color for each vertex.
CornerAttribute shade(const TriangleMesh& mesh) {
    Matrix values = Matrix::Ones(mesh.n_vertices(), 4);
    values.leftCols<3>() = (0.75 + 0.2 * mesh.vertices.array()).cwiseMax(0.5).cwiseMin(1);
    return {as_floats(values), mesh.triangles};
}

}  // namespace

Character make_character(const BodyOptions& options) {
    Character character;
    AttributedMesh& content = character.content;
    content.mesh = make_body(options);
    content.mesh.vertices = as_floats(content.mesh.vertices);
    const Points& vertices = content.mesh.vertices;
    const std::vector<Bone> skeleton = bones();
    for (const Bone& bone : skeleton) character.joints.push_back(bone.joint);
    content.texture_coordinates = {unwrap(content.mesh)};
    content.colors = {shade(content.mesh)};
    content.skin = bind(vertices, skeleton);
    content.morphs = {blend_shape("smile", vertices, {0, .77, .05}, .1, {0, .02, 0}, .5),
                      blend_shape("belly", vertices, {0, .42, .02}, .2, {0, 0, .05}, .2),
                      blend_shape("wag", vertices, {0, .37, -.3}, .2, {.1, .03, 0}, 0)};
    return character;
}

}  // namespace counterpart::test
