// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "base/random.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/mesh/variants.hpp>

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Geometry>
#include <fmt/format.h>

namespace counterpart {
namespace {

using Corners = std::array<Index, 3>;

// What touches a vertex of more triangles than this stays as it is: each change there would look at all of
// them.
constexpr std::size_t most_triangles = 100;

// Triangles that lose and exchange corners.
class ChangingMesh {
  public:
    explicit ChangingMesh(MeshView mesh)
        : points_(mesh.vertices), around_(static_cast<std::size_t>(mesh.n_vertices())) {
        for (Index t = 0; t < mesh.n_triangles(); ++t) {
            const Corners corners{mesh.triangles(t, 0), mesh.triangles(t, 1), mesh.triangles(t, 2)};
            if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) continue;
            for (const Index v : corners) triangles_at(v).push_back(static_cast<Index>(triangles_.size()));
            triangles_.push_back(corners);
        }
    }

    // Into the nearest neighbor that allows it.
    bool collapse(Index v) {
        if (is_crowded(v)) return false;
        const std::vector<Index> around = neighbors(v);
        if (around.empty() || around.size() != triangles_at(v).size()) return false;  // a boundary, or torn
        if (std::any_of(around.begin(), around.end(), [&](Index w) { return is_crowded(w); })) return false;
        std::vector<Index> to = around;
        std::sort(to.begin(), to.end(), [&](Index a, Index b) {
            return std::pair(squared_distance(v, a), a) < std::pair(squared_distance(v, b), b);
        });
        const auto found =
            std::find_if(to.begin(), to.end(), [&](Index w) { return may_collapse(v, around, w); });
        if (found == to.end()) return false;
        for (const Index t : std::vector<Index>(triangles_at(v))) {
            if (!has(t, *found)) {
                triangles_at(*found).push_back(t);
                std::replace(corners(t).begin(), corners(t).end(), v, *found);
            } else {
                for (const Index corner : corners(t)) std::erase(triangles_at(corner), t);
                corners(t) = {-1, -1, -1};
            }
        }
        triangles_at(v).clear();
        return true;
    }

    // The edge after `corner`, to the other diagonal of its two triangles.
    void flip(Index t, std::size_t corner) {
        if (corners(t)[0] < 0) return;
        const Index a = corners(t)[corner], b = corners(t)[(corner + 1) % 3],
                    c = corners(t)[(corner + 2) % 3];
        if (is_crowded(a) || is_crowded(b) || is_crowded(c)) return;
        std::vector<Index> shared;
        for (const Index other : triangles_at(a))
            if (has(other, b)) shared.push_back(other);
        if (shared.size() != 2) return;
        const Index u = shared[0] == t ? shared[1] : shared[0];
        const auto place =
            static_cast<std::size_t>(std::find(corners(u).begin(), corners(u).end(), b) - corners(u).begin());
        const Index d = corners(u)[(place + 2) % 3];
        if (corners(u)[(place + 1) % 3] != a || c == d || is_crowded(d) || are_neighbors(c, d))
            return;  // wound otherwise
        const std::array<Corners, 2> before{{{a, b, c}, {b, a, d}}}, after{{{c, d, b}, {d, c, a}}};
        if (!replaces(after[0], before[0]) || !replaces(after[0], before[1]) ||
            !replaces(after[1], before[0]) || !replaces(after[1], before[1]))
            return;
        corners(t) = after[0];
        corners(u) = after[1];
        std::erase(triangles_at(a), t);
        std::erase(triangles_at(b), u);
        triangles_at(d).push_back(t);
        triangles_at(c).push_back(u);
    }

    RetriangulateResult result() const {
        std::vector<Index> number(around_.size(), -1);
        RetriangulateResult result;
        result.original_from_mesh = used_vertices();
        for (std::size_t i = 0; i < result.original_from_mesh.size(); ++i)
            number[static_cast<std::size_t>(result.original_from_mesh[i])] = static_cast<Index>(i);
        result.mesh.vertices = points_(result.original_from_mesh, Eigen::all);
        std::vector<Corners> left;
        for (const Corners& corners : triangles_)
            if (corners[0] >= 0) left.push_back(corners);
        result.mesh.triangles.resize(static_cast<Index>(left.size()), 3);
        for (std::size_t t = 0; t < left.size(); ++t)
            for (std::size_t c = 0; c < 3; ++c)
                result.mesh.triangles(static_cast<Eigen::Index>(t), static_cast<Eigen::Index>(c)) =
                    number[static_cast<std::size_t>(left[t][c])];
        return result;
    }
    Index n_triangles() const { return static_cast<Index>(triangles_.size()); }
    std::vector<Index> used_vertices() const {
        std::vector<Index> used;
        for (std::size_t v = 0; v < around_.size(); ++v)
            if (!around_[v].empty()) used.push_back(static_cast<Index>(v));
        return used;
    }

  private:
    bool is_crowded(Index v) { return triangles_at(v).size() > most_triangles; }
    std::vector<Index>& triangles_at(Index v) { return around_[static_cast<std::size_t>(v)]; }
    Corners& corners(Index t) { return triangles_[static_cast<std::size_t>(t)]; }
    bool has(Index t, Index v) {
        return std::find(corners(t).begin(), corners(t).end(), v) != corners(t).end();
    }
    double squared_distance(Index v, Index w) const {
        return (points_.row(v) - points_.row(w)).squaredNorm();
    }
    std::vector<Index> neighbors(Index v) {
        std::vector<Index> found;
        for (const Index t : triangles_at(v))
            for (const Index w : corners(t))
                if (w != v) found.push_back(w);
        std::sort(found.begin(), found.end());
        found.erase(std::unique(found.begin(), found.end()), found.end());
        return found;
    }
    bool are_neighbors(Index v, Index w) {
        return std::any_of(triangles_at(v).begin(), triangles_at(v).end(),
                           [&](Index t) { return has(t, w); });
    }

    bool may_collapse(Index v, const std::vector<Index>& around_v, Index w) {
        const std::vector<Index> around_w = neighbors(w);
        std::vector<Index> common;
        std::set_intersection(around_v.begin(), around_v.end(), around_w.begin(), around_w.end(),
                              std::back_inserter(common));
        if (common.size() != 2) return false;  // the link condition
        return std::all_of(triangles_at(v).begin(), triangles_at(v).end(), [&](Index t) {
            if (has(t, w)) return true;
            Corners after = corners(t);
            std::replace(after.begin(), after.end(), v, w);
            return replaces(after, corners(t));
        });
    }

    // Whether the triangle faces the same way as the one before and is not much thinner.
    bool replaces(const Corners& after, const Corners& before) const {
        constexpr double min_cosine = 0.7, min_roundness = 0.25, min_of_before = 0.5;
        return normal(after).dot(normal(before)) >
                   min_cosine * normal(after).norm() * normal(before).norm() &&
               roundness(after) > std::min(min_roundness, min_of_before * roundness(before));
    }
    Eigen::RowVector3d side(const Corners& corners, std::size_t c) const {
        return points_.row(corners[(c + 1) % 3]) - points_.row(corners[c]);
    }
    Eigen::RowVector3d normal(const Corners& corners) const {
        return side(corners, 0).cross(side(corners, 1));
    }
    // Of the height over the longest side, in those of an equilateral triangle.
    double roundness(const Corners& corners) const {
        double longest = 0;
        for (std::size_t c = 0; c < 3; ++c) longest = std::max(longest, side(corners, c).squaredNorm());
        return longest > 0 ? normal(corners).norm() / (std::sqrt(0.75) * longest) : 0;
    }

    Points points_;
    std::vector<Corners> triangles_;
    std::vector<std::vector<Index>> around_;
};

void require_share(double share, double least, const char* name) {
    if (!(share >= least && share <= 1))
        throw InvalidInput(fmt::format("the share of {} must be from {} to 1, not {}", name, least, share));
}

}  // namespace

RetriangulateResult retriangulate(MeshView mesh, const RetriangulateOptions& options) {
    require_valid(mesh);
    require_share(options.kept_share, 0.05, "vertices that are kept");
    require_share(options.flip_share, 0, "edges that are flipped");
    Random random(options.seed);
    ChangingMesh changing(mesh);
    std::vector<Index> order = changing.used_vertices();
    random.shuffle(order);
    const double least = options.kept_share * static_cast<double>(order.size());
    auto n_left = static_cast<double>(order.size());
    for (const Index v : order) {
        if (n_left - 1 < least) break;
        if (changing.collapse(v)) --n_left;
    }
    for (Index t = 0; t < changing.n_triangles(); ++t)
        if (random.uniform() < options.flip_share)
            changing.flip(t, static_cast<std::size_t>(random.below(3)));
    return changing.result();
}

}  // namespace counterpart
