// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "base/parallel.hpp"
#include "mesh/edge_table.hpp"
#include "transfer/attributes.hpp"
#include "transfer/cut_surface.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/map/complete.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <Eigen/LU>
#include <fmt/format.h>

namespace counterpart::attributes {
namespace {

using CornerPoints = std::array<SurfacePoint, 3>;  // on one side of every seam
using Seams = CutSurface::Seams;

// A chord is shorter than the way along the surface: how much farther around it we look.
constexpr double slack = 1.25;
constexpr int widenings = 2;  // each doubles the radius

// A target edge whose ends lie on different sides of a seam.
struct Crossing {
    bool found = false;
    std::array<SurfacePoint, 2> on_seam;  // the place on it that is closest to each end
    std::array<double, 2> distance{};
};

Crossing find_crossing(const CutSurface& surface, const SurfacePoint& a, const SurfacePoint& b) {
    Crossing none;
    const std::vector<Index> around_a = surface.around(a), around_b = surface.around(b);
    if (intersect(around_a, around_b)) return none;
    const Eigen::Vector3d from = surface.position(a), to = surface.position(b), middle = (from + to) / 2;
    double radius = slack * (to - from).norm() / 2;
    for (int i = 0; i <= widenings; ++i, radius *= 2) {
        const std::vector<Index> side_a = surface.reach(around_a, middle, radius, Seams::block);
        if (intersect(side_a, around_b)) return none;
        if (!intersect(surface.reach(around_a, middle, radius, Seams::cross), around_b)) continue;
        const std::vector<Index> side_b = surface.reach(around_b, middle, radius, Seams::block);
        const numerics::ClosestPoint to_a = surface.closest_among(side_b, from);
        const numerics::ClosestPoint to_b = surface.closest_among(side_a, to);
        if (!std::isfinite(to_a.squared_distance) || !std::isfinite(to_b.squared_distance))
            return none;  // too far away to be measured
        return {true,
                {SurfacePoint{to_a.triangle, to_a.weights}, SurfacePoint{to_b.triangle, to_b.weights}},
                {std::sqrt(to_a.squared_distance), std::sqrt(to_b.squared_distance)}};
    }
    return none;  // the map is torn here: no seam's fault
}

struct Snapped {
    std::vector<SurfacePoint> image;
    std::vector<double> moved;  // per vertex; 0 = not
};

// Moves the nearer end of each crossing edge onto the seam, least moves first, until no edge crosses one.
Snapped snap_to_seams(const CutSurface& surface, MeshView target, std::vector<SurfacePoint> image) {
    Snapped result{std::move(image), std::vector<double>(static_cast<std::size_t>(target.n_vertices()), 0)};
    const mesh::EdgeTable table(target);
    std::vector<std::array<std::size_t, 2>> edges;
    for (Index e = 0; e < table.n_edges(); ++e)
        edges.push_back({static_cast<std::size_t>(table.low(e)), static_cast<std::size_t>(table.high(e))});
    constexpr int most_passes = 3;  // where three charts meet, an edge may cross two seams
    for (int pass = 0; pass < most_passes && !edges.empty(); ++pass) {
        std::vector<Crossing> crossings(edges.size());
        parallel_for(edges.size(), 64, [&](std::size_t e) {
            crossings[e] = find_crossing(surface, result.image[edges[e][0]], result.image[edges[e][1]]);
        });
        std::vector<std::size_t> order;
        for (std::size_t e = 0; e < edges.size(); ++e)
            if (crossings[e].found) order.push_back(e);
        std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
            return std::min(crossings[a].distance[0], crossings[a].distance[1]) <
                   std::min(crossings[b].distance[0], crossings[b].distance[1]);
        });
        std::vector<char> done(result.image.size(), 0);
        std::vector<std::array<std::size_t, 2>> remaining;
        for (const std::size_t e : order) {
            remaining.push_back(edges[e]);
            if (done[edges[e][0]] || done[edges[e][1]]) continue;
            const std::size_t end = crossings[e].distance[1] < crossings[e].distance[0] ? 1 : 0;
            const std::size_t v = edges[e][end];
            done[v] = 1;
            result.image[v] = crossings[e].on_seam[end];
            result.moved[v] += crossings[e].distance[end];
        }
        edges = std::move(remaining);
    }
    return result;
}

// A choice of the side a target triangle lies on: the part of the source around it that no seam divides.
struct SideChoice {
    int missed = 4;       // corners that do not lie in it
    bool turned = false;  // a triangle that runs the other way, like the back of a leaf
    double squared_distance = std::numeric_limits<double>::infinity();  // from the triangle's center
    Index triangle = -1;                                                // closest to the center
    std::vector<Index> triangles;

    bool better_than(const SideChoice& other) const {
        if (missed != other.missed) return missed < other.missed;
        return turned != other.turned ? !turned : squared_distance < other.squared_distance;
    }
};

CornerPoints place_corners(const CutSurface& surface, const CornerPoints& images, Index& triangle) {
    std::array<std::vector<Index>, 3> around;
    std::array<Eigen::Vector3d, 3> positions;
    std::size_t narrowest = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        around[c] = surface.around(images[c]);
        positions[c] = surface.position(images[c]);
        if (around[c].size() < around[narrowest].size()) narrowest = c;
    }
    const auto holds = [&](const std::vector<Index>& triangles, std::size_t c) {
        return intersect(triangles, around[c]);
    };
    const Eigen::Vector3d center = (positions[0] + positions[1] + positions[2]) / 3;
    SideChoice best;
    const auto consider = [&](std::vector<Index> triangles, bool turned) {
        SideChoice side{0, turned, 0, -1, std::move(triangles)};
        for (std::size_t c = 0; c < 3; ++c) side.missed += !holds(side.triangles, c);
        const numerics::ClosestPoint point = surface.closest_among(side.triangles, center);
        side.squared_distance = point.squared_distance;
        side.triangle = point.triangle;
        if (side.better_than(best)) best = std::move(side);
    };
    for (const Index t : around[narrowest]) {
        if (!holds({t}, 0) || !holds({t}, 1) || !holds({t}, 2)) continue;
        Eigen::Matrix3d weights;
        for (int c = 0; c < 3; ++c)
            weights.col(c) = surface.seen_from(t, images[static_cast<std::size_t>(c)]).weights;
        consider({t}, weights.determinant() < 0);
    }
    double radius = 0;
    for (const Eigen::Vector3d& p : positions) radius = std::max(radius, slack * (p - center).norm());
    for (int i = 0; i <= widenings && best.missed > 0; ++i, radius *= 2) {
        for (const Index t : around[narrowest])
            consider(surface.reach(std::array{t}, center, radius, Seams::block), false);
    }
    triangle = best.triangle;
    CornerPoints corners;
    for (std::size_t c = 0; c < 3; ++c) {
        const auto shared = std::find_if(around[c].begin(), around[c].end(), [&](Index t) {
            return std::binary_search(best.triangles.begin(), best.triangles.end(), t);
        });
        if (shared != around[c].end()) {
            corners[c] = surface.seen_from(*shared, images[c]);
        } else {
            const numerics::ClosestPoint point = surface.closest_among(best.triangles, positions[c]);
            corners[c] = {point.triangle, point.weights};
        }
    }
    return corners;
}

// Rounding must not keep a point off an edge or a vertex: what lies on a seam belongs to both its sides.
void settle(std::vector<SurfacePoint>& image) {
    constexpr double negligible = 1e-9;
    for (SurfacePoint& point : image) {
        if (!(point.weights.array() != 0 && point.weights.array() < negligible).any()) continue;
        point.weights = (point.weights.array() < negligible).select(0, point.weights);
        point.weights /= point.weights.sum();
    }
}

// Values of all corners; those that agree at a vertex share a row.
CornerAttribute evaluate(const std::vector<CornerPoints>& points, MeshView target,
                         const CornerAttribute& attribute, double tolerance) {
    std::vector<Eigen::RowVectorXd> rows;
    std::vector<std::vector<Index>> rows_of(static_cast<std::size_t>(target.n_vertices()));
    CornerAttribute result{{}, Triangles::Constant(target.n_triangles(), 3, -1)};
    for (Index t = 0; t < target.n_triangles(); ++t) {
        for (int c = 0; c < 3; ++c) {
            const SurfacePoint& point = points[static_cast<std::size_t>(t)][static_cast<std::size_t>(c)];
            if (point.triangle < 0) continue;  // too far away to be measured
            const auto corners = attribute.corners.row(point.triangle);
            if (corners.minCoeff() < 0) continue;
            Eigen::RowVectorXd value = Eigen::RowVectorXd::Zero(attribute.values.cols());
            for (int k = 0; k < 3; ++k)
                if (point.weights[k] != 0) value += point.weights[k] * attribute.values.row(corners[k]);
            std::vector<Index>& here = rows_of[static_cast<std::size_t>(target.triangles(t, c))];
            const auto same = std::find_if(here.begin(), here.end(), [&](Index row) {
                return (rows[static_cast<std::size_t>(row)] - value).cwiseAbs().maxCoeff() <= tolerance;
            });
            if (same != here.end()) {
                result.corners(t, c) = *same;
            } else {
                result.corners(t, c) = static_cast<Index>(rows.size());
                here.push_back(static_cast<Index>(rows.size()));
                rows.push_back(std::move(value));
            }
        }
    }
    result.values.resize(static_cast<Eigen::Index>(rows.size()), attribute.values.cols());
    for (std::size_t i = 0; i < rows.size(); ++i) result.values.row(static_cast<Eigen::Index>(i)) = rows[i];
    return result;
}

Index count_seam_triangles(MeshView target, const CornerAttribute& attribute) {
    std::vector<char> at_seam(static_cast<std::size_t>(target.n_triangles()), 0);
    const mesh::EdgeTable edges(target);
    for (Index e = 0; e < edges.n_edges(); ++e) {
        const auto row = [&](const mesh::EdgeTable::HalfEdge& side, bool low) {
            return attribute.corners(side.triangle, (side.corner + (side.forward == low ? 0 : 1)) % 3);
        };
        const auto sides = edges.half_edges(e);
        for (const mesh::EdgeTable::HalfEdge& side : sides) {
            if (row(side, true) == row(sides[0], true) && row(side, false) == row(sides[0], false)) continue;
            for (const mesh::EdgeTable::HalfEdge& any : sides)
                at_seam[static_cast<std::size_t>(any.triangle)] = 1;
        }
    }
    return static_cast<Index>(std::count(at_seam.begin(), at_seam.end(), 1));
}

void require_fitting(const CornerAttribute& attribute, const std::vector<Index>& labels, MeshView source) {
    if (attribute.corners.rows() != source.n_triangles()) {
        throw InvalidInput(fmt::format("the attribute has corners for {} triangles, but the source has {}",
                                       attribute.corners.rows(), source.n_triangles()));
    }
    if (!labels.empty() && static_cast<Index>(labels.size()) != source.n_triangles()) {
        throw InvalidInput(fmt::format("there are {} labels for the source's {} triangles", labels.size(),
                                       source.n_triangles()));
    }
    for (const Index row : attribute.corners.reshaped()) {
        if (row < -1 || row >= attribute.values.rows()) {
            throw InvalidInput(fmt::format("a corner names value {}, but values run from 0 to {}", row,
                                           attribute.values.rows() - 1));
        }
    }
    if (!attribute.values.allFinite()) throw InvalidInput("the attribute holds a number that is not finite");
}

}  // namespace

TransferredCorners transfer_corners(const SurfaceMap& source_from_target, MeshView source, MeshView target,
                                    const CornerAttribute& attribute, const std::vector<Index>& labels,
                                    const TransferCornersOptions& options) {
    require_fitting(attribute, labels, source);
    CompletedMap completed = complete_map(source_from_target, target, source);
    settle(completed.target_from_source.image);
    const CutSurface surface(source, attribute, labels);
    TransferredCorners result;
    result.coverage = completed.coverage;
    result.source_from_target.resize(static_cast<std::size_t>(target.n_triangles()));
    std::vector<CornerPoints> points(result.source_from_target.size());
    const Snapped snapped = with_threads(options.n_threads, [&] {
        Snapped moved = snap_to_seams(surface, target, completed.target_from_source.image);
        parallel_for(points.size(), 64, [&](std::size_t t) {
            const auto corners = target.triangles.row(static_cast<Eigen::Index>(t));
            const auto image = [&](int c) { return moved.image[static_cast<std::size_t>(corners[c])]; };
            points[t] = place_corners(surface, {image(0), image(1), image(2)}, result.source_from_target[t]);
        });
        return moved;
    });
    for (const double distance : snapped.moved) {
        if (!(distance > 0)) continue;
        ++result.moved_vertices;
        result.largest_move = std::max(result.largest_move, distance);
    }
    const double range = attribute.values.size() == 0 ? 0 : attribute.values.cwiseAbs().maxCoeff();
    result.attribute = evaluate(points, target, attribute, 1e-12 * range);
    result.seam_triangles = count_seam_triangles(target, result.attribute);
    for (Index t = 0; t < target.n_triangles(); ++t)
        result.without_triangles += result.attribute.corners.row(t).minCoeff() < 0;
    return result;
}

}  // namespace counterpart::attributes
