// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/choice/requests.hpp"

#include "geodesic/dijkstra.hpp"
#include "match/spectral/tuning.hpp"

#include <counterpart/mesh/measure.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include <fmt/format.h>

namespace counterpart::choice {
namespace {

// Of the coordinates of the vertices and of their images along a direction; 1 where either are all the same.
double correlation(const VertexMap& map, MeshView source, MeshView target, const Eigen::Vector3d& direction) {
    std::vector<Index> from;
    for (Index v = 0; v < map.source_size(); ++v)
        if (map[v] != VertexMap::unmatched) from.push_back(v);
    if (from.empty()) return 1;
    Vector x(static_cast<Eigen::Index>(from.size())), y = x;
    for (Eigen::Index i = 0; i < x.size(); ++i) {
        const Index v = from[static_cast<std::size_t>(i)];
        x[i] = source.vertices.row(v).dot(direction);
        y[i] = target.vertices.row(map[v]).dot(direction);
    }
    const double size = std::max(x.cwiseAbs().maxCoeff(), y.cwiseAbs().maxCoeff());
    x.array() -= x.mean();
    y.array() -= y.mean();
    constexpr double rounding = 1e-9;
    const double least = rounding * size * std::sqrt(static_cast<double>(from.size()));
    return std::min(x.norm(), y.norm()) <= least ? 1 : x.dot(y) / (x.norm() * y.norm());
}

}  // namespace

std::string contradiction(const VertexMap& target_from_source, MeshView source, MeshView target,
                          const SpectralOptions& said) {
    const spectral_match::PriorTuning tuning;
    if (!said.excluded.empty()) {
        const double radius = tuning.excluded_radius * std::sqrt(surface_area(target));
        const DistanceGraph graph(target);
        geodesic::Dijkstra from_excluded(graph);
        for (const auto& [s, t] : said.excluded) {
            if (target_from_source[s] == VertexMap::unmatched) continue;
            from_excluded.search(std::span(&t, 1), {.radius = radius, .targets = {}});
            if (from_excluded.distance(target_from_source[s]) <= radius)
                return fmt::format("source vertex {} goes to target vertex {} or near it, which is excluded",
                                   s, t);
        }
    }
    const auto runs_against = [&](const Eigen::Vector3d& direction) {
        return !direction.isZero(0) &&
               correlation(target_from_source, source, target, direction) < tuning.enough_correlation;
    };
    if (said.aligned) {
        constexpr std::array<const char*, 3> names = {"x", "y", "z"};
        for (int axis = 0; axis < 3; ++axis)
            if (runs_against(Eigen::Vector3d::Unit(axis)))
                return fmt::format(
                    "{} of the source is not {} of the target, though they are said to be aligned",
                    names[static_cast<std::size_t>(axis)], names[static_cast<std::size_t>(axis)]);
    }
    if (runs_against(said.up)) return "what is up in the source is not up in the target";
    if (runs_against(said.facing)) return "what the source faces is not what the target faces";
    return "";
}

}  // namespace counterpart::choice
