// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/place/coincidence.hpp"

#include "base/parallel.hpp"
#include "match/place/surface.hpp"
#include "mesh/edge_table.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/match/place.hpp>
#include <counterpart/mesh/measure.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace counterpart::place {
namespace {

struct Sample {
    Eigen::Vector3d position, normal;
};

// Each stands for as much area; where in its triangle it lies follows the golden ratio.
std::vector<Sample> spread_samples(const Surface& surface, std::size_t count) {
    constexpr double golden = 0.6180339887498949;
    std::vector<Sample> samples;
    const double step = surface.areas.sum() / static_cast<double>(count);
    double passed = 0, next = step / 2;
    for (Index t = 0; t < surface.mesh.n_triangles(); ++t) {
        passed += surface.areas[t];
        for (; next < passed && samples.size() < count; next += step) {
            const double r = std::fmod(golden * static_cast<double>(samples.size() + 1), 1.0),
                         s = std::sqrt((static_cast<double>(samples.size()) + 0.5) /
                                       static_cast<double>(count));
            const auto corner = [&](int c) -> Eigen::Vector3d {
                return surface.mesh.vertices.row(surface.mesh.triangles(t, c)).transpose();
            };
            samples.push_back({(1 - s) * corner(0) + s * (1 - r) * corner(1) + s * r * corner(2),
                               surface.normals.row(t).transpose()});
        }
    }
    return samples;
}

std::vector<char> on_boundary(MeshView mesh) {
    std::vector<char> result(static_cast<std::size_t>(mesh.n_vertices()), 0);
    for (const auto& [v, w] : mesh::boundary_edges(mesh::EdgeTable(mesh)))
        result[static_cast<std::size_t>(v)] = result[static_cast<std::size_t>(w)] = 1;
    return result;
}

bool lies_on_boundary(const numerics::ClosestPoint& point, MeshView mesh, const std::vector<char>& ends) {
    constexpr double rounding = 1e-9;
    for (Index c = 0; c < 3; ++c)
        if (point.weights[c] > rounding &&
            ends[static_cast<std::size_t>(mesh.triangles(point.triangle, c))] == 0)
            return false;
    return true;
}

double reach_of(const Surface& source, const Surface& target) {
    constexpr double of_size = 0.005, of_edge = 0.25, most_of_size = 0.02;
    const double size = std::sqrt(std::min(source.areas.sum(), target.areas.sum())),
                 edge = std::max(mean_edge_length(source.mesh), mean_edge_length(target.mesh));
    return std::clamp(of_edge * edge, of_size * size, most_of_size * size);
}

struct Shares {
    double within = 0;     // of all samples
    double agreement = 0;  // of those that the other surface passes by at all
};

// Samples that face the same way within reach of the other surface, and those that it passes by farther off;
// not where it ends. Of a few only, where these say that it is far below a half.
Shares shares_of(const Surface& from, const Surface& to, double reach) {
    constexpr std::size_t count = 2000, few = 100;
    constexpr double hopeless = 0.4, passing_by = 4;
    const std::vector<Sample> samples = spread_samples(from, count);
    const std::vector<char> ends = on_boundary(to.mesh);
    enum : char { near, beside, elsewhere };
    std::vector<char> where(samples.size(), elsewhere);
    const auto shares_of_every = [&](std::size_t stride) {
        const std::size_t n = (samples.size() + stride - 1) / stride;
        parallel_for(n, 64, [&](std::size_t k) {
            const Sample& sample = samples[k * stride];
            const auto point =
                to.closest.closest(sample.position, sample.normal, same_way, passing_by * reach);
            where[k] = point.triangle < 0                        ? elsewhere
                       : point.squared_distance <= reach * reach ? near
                       : lies_on_boundary(point, to.mesh, ends)  ? elsewhere
                                                                 : beside;
        });
        const auto end = where.begin() + static_cast<std::ptrdiff_t>(n);
        const auto n_near = static_cast<double>(std::count(where.begin(), end, near)),
                   n_beside = static_cast<double>(std::count(where.begin(), end, beside));
        return Shares{n_near / static_cast<double>(std::max<std::size_t>(n, 1)),
                      n_near / std::max(n_near + n_beside, 1.0)};
    };
    const Shares roughly = shares_of_every(count / few);
    return roughly.within < hopeless && roughly.agreement < coinciding_share ? roughly : shares_of_every(1);
}

// Whether the boxes overlap by more than half of the smaller one, in each direction.
bool boxes_overlap(MeshView a, MeshView b) {
    const Eigen::Array3d low_a = a.vertices.colwise().minCoeff().transpose(),
                         high_a = a.vertices.colwise().maxCoeff().transpose(),
                         low_b = b.vertices.colwise().minCoeff().transpose(),
                         high_b = b.vertices.colwise().maxCoeff().transpose();
    // Flat meshes have no extent in one direction.
    const double slack = 0.02 * std::max((high_a - low_a).maxCoeff(), (high_b - low_b).maxCoeff());
    const Eigen::Array3d common = high_a.min(high_b) - low_a.max(low_b) + slack,
                         smaller = (high_a - low_a).min(high_b - low_b) + slack;
    return (common > 0.5 * smaller).all();
}

}  // namespace

Surface::Surface(MeshView of)
    : mesh(of),
      areas(triangle_areas(of)),
      normals(triangle_normals(of)),
      closest(of.vertices, of.triangles) {}

Coincidence measure_coincidence(MeshView source, MeshView target) {
    if (source.n_triangles() == 0 || target.n_triangles() == 0 || !boxes_overlap(source, target)) return {};
    const Surface from(source), to(target);
    if (!(from.areas.sum() > 0) || !(to.areas.sum() > 0))
        throw UnsuitableMesh("a mesh has no area: what lies in the same place cannot be seen");
    Coincidence result{reach_of(from, to)};
    const Shares of_source = shares_of(from, to, result.reach);
    if (of_source.within == 0) return result;
    const Shares of_target = shares_of(to, from, result.reach);
    result.source_share = of_source.within;
    result.target_share = of_target.within;
    result.agreement = std::min(of_source.agreement, of_target.agreement);
    return result;
}

}  // namespace counterpart::place
