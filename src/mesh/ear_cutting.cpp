// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Ear cutting (Meisters 1975), our own because what is at hand (mapbox earcut) drops corners on straight
// edges and so does not always make size - 2 triangles, which everything that counts polygon corners relies
// on.
#include "mesh/ear_cutting.hpp"

#include <counterpart/mesh/triangle_mesh.hpp>

#include <algorithm>

#include <Eigen/Geometry>

namespace counterpart::mesh {
namespace {

using Cut = std::vector<std::array<Index, 3>>;
using Flat = std::vector<Eigen::Vector2d>;

// Twice the signed area: positive if a, b, c turn left.
double turn(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
    const Eigen::Vector2d u = b - a, v = c - a;
    return u[0] * v[1] - u[1] * v[0];
}

// The polygon seen along its normal, counter-clockwise, scaled to about 1; empty where it has no area.
Flat flattened(PointsView vertices, std::span<const Index> polygon) {
    const Eigen::RowVector3d origin = vertices.row(polygon[0]);
    double size = 0;
    for (const Index v : polygon) size = std::max(size, (vertices.row(v) - origin).cwiseAbs().maxCoeff());
    if (!(size > 0) || !std::isfinite(size)) return {};
    const auto at = [&](std::size_t i) -> Eigen::Vector3d {
        return ((vertices.row(polygon[i % polygon.size()]) - origin) / size).transpose();
    };
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < polygon.size(); ++i) normal += at(i).cross(at(i + 1));
    constexpr double no_area = 1e-12;
    if (!(normal.norm() > no_area)) return {};
    normal.normalize();
    const Eigen::Vector3d x = normal.unitOrthogonal(), y = normal.cross(x);
    Flat flat;
    for (std::size_t i = 0; i < polygon.size(); ++i) flat.emplace_back(at(i).dot(x), at(i).dot(y));
    return flat;
}

Cut fan(std::size_t size) {
    Cut cut;
    for (std::size_t i = 2; i < size; ++i)
        cut.push_back({0, static_cast<Index>(i - 1), static_cast<Index>(i)});
    return cut;
}

// Whether every triangle of the fan turns left; slivers do not count, as an ear may do better.
bool is_fan(const Flat& flat) {
    constexpr double sliver = 1e-9;
    for (std::size_t i = 2; i < flat.size(); ++i)
        if (!(turn(flat[0], flat[i - 1], flat[i]) > sliver)) return false;
    return true;
}

class EarCutter {
  public:
    explicit EarCutter(const Flat& flat) : flat_(flat), next_(flat.size()), previous_(flat.size()) {
        for (std::size_t i = 0; i < flat.size(); ++i) {
            next_[i] = (i + 1) % flat.size();
            previous_[i] = (i + flat.size() - 1) % flat.size();
        }
        quality_.resize(flat.size());
        for (std::size_t i = 0; i < flat.size(); ++i) quality_[i] = quality(i);
    }

    Cut run() {
        Cut cut;
        std::size_t any = 0;
        for (std::size_t left = flat_.size(); left > 2; --left) {
            const std::size_t ear = best(any);
            const std::size_t before = previous_[ear], after = next_[ear];
            cut.push_back({static_cast<Index>(before), static_cast<Index>(ear), static_cast<Index>(after)});
            next_[before] = after;
            previous_[after] = before;
            quality_[before] = quality(before);
            quality_[after] = quality(after);
            any = before;
        }
        return cut;
    }

  private:
    static constexpr double none = -1;  // not an ear

    // A corner that became convex may have freed others, so all are looked at again before one is cut that is
    // no ear: the most convex one, of a polygon that intersects itself.
    std::size_t best(std::size_t any) {
        for (const bool again : {false, true}) {
            std::size_t found = any, i = any;
            do {
                if (again) quality_[i] = quality(i);
                if (quality_[i] > quality_[found]) found = i;
                i = next_[i];
            } while (i != any);
            if (quality_[found] > none) return found;
        }
        std::size_t found = any;
        for (std::size_t i = next_[any]; i != any; i = next_[i])
            if (corner_turn(i) > corner_turn(found)) found = i;
        return found;
    }

    double corner_turn(std::size_t i) const { return turn(flat_[previous_[i]], flat_[i], flat_[next_[i]]); }

    // Of the triangle at the corner: its area over the square of its longest side; `none` if it is no ear.
    double quality(std::size_t i) const {
        const Eigen::Vector2d &a = flat_[previous_[i]], &b = flat_[i], &c = flat_[next_[i]];
        const double area = turn(a, b, c);
        if (!(area > 0)) return none;
        for (std::size_t p = next_[next_[i]]; p != previous_[i]; p = next_[p])
            if (blocks(p, a, b, c)) return none;
        return area / std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    }

    // Whether the polygon enters triangle a, b, c at corner p. Corners at one place, as at the ends of a
    // bridge to a hole, enter only if one of their edges does.
    bool blocks(std::size_t p, const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                const Eigen::Vector2d& c) const {
        const Eigen::Vector2d& q = flat_[p];
        if (q == a || q == c) return false;
        if (q == b) return is_within(flat_[next_[p]], a, b, c) || is_within(flat_[previous_[p]], a, b, c);
        if (turn(a, b, q) < 0 || turn(b, c, q) < 0 || turn(c, a, q) < 0) return false;
        return corner_turn(p) <= 0;
    }
    // Whether direction b to q lies strictly between those to c and a.
    static bool is_within(const Eigen::Vector2d& q, const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                          const Eigen::Vector2d& c) {
        return turn(b, c, q) > 0 && turn(b, q, a) > 0;
    }

    const Flat& flat_;
    std::vector<std::size_t> next_, previous_;
    std::vector<double> quality_;
};

}  // namespace

Cut cut_polygon(PointsView vertices, std::span<const Index> polygon) {
    if (polygon.size() == 3 || polygon.size() > static_cast<std::size_t>(max_ear_corners))
        return fan(polygon.size());
    const Flat flat = flattened(vertices, polygon);
    if (flat.empty() || is_fan(flat)) return fan(polygon.size());
    return EarCutter(flat).run();
}

}  // namespace counterpart::mesh
