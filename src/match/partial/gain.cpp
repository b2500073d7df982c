// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/partial/gain.hpp"

#include "base/parallel.hpp"
#include "base/to_size.hpp"

#include <counterpart/mesh/measure.hpp>

#include <algorithm>
#include <cmath>

namespace counterpart::partial_match {
namespace {

struct Laid {
    const Points& positions;
    const Points& normals;
};

double fit(const Laid& a, Eigen::Index v, const Laid& b, Eigen::Index w, const GainTuning& tuning) {
    const double gap = (a.positions.row(v) - b.positions.row(w)).norm() / tuning.gap;
    return std::exp(-gap * gap / 2) * std::max(0.0, a.normals.row(v).dot(b.normals.row(w)));
}

}  // namespace

std::vector<char> near_boundary(const Surface& surface) {
    std::vector<char> near = surface.on_boundary;
    const Triangles& triangles = surface.mesh.triangles;
    for (Index t = 0; t < triangles.rows(); ++t) {
        bool touches = false;
        for (int c = 0; c < 3; ++c) touches |= surface.on_boundary[to_size(triangles(t, c))] != 0;
        for (int c = 0; touches && c < 3; ++c) near[to_size(triangles(t, c))] = 1;
    }
    return near;
}

Gain gain(const Surface& part, const Surface& whole, const BentSource& bent, const GainTuning& tuning) {
    const Laid a{bent.positions, bent.normals}, b{whole.mesh.vertices, whole.normals};
    const std::vector<char> open_part = near_boundary(part), open_whole = near_boundary(whole);
    const Vector part_areas = vertex_areas(part.mesh), whole_areas = vertex_areas(whole.mesh);
    Gain result;
    const auto add = [&](double q, double area, bool open) {
        result.fits += area * q;
        if (!open) result.lacks += area * (1 - q);
    };
    for (Index v = 0; v < part.mesh.n_vertices(); ++v) {
        const Index w = bent.image[to_size(v)];
        const double q = fit(a, v, b, w, tuning);
        result.fit_of_part.push_back(static_cast<float>(q));
        add(q, part_areas[v], open_whole[to_size(w)] != 0);
    }
    const numerics::OrientedNeighbors on_part(bent.positions, bent.normals, tuning.normal_weight);
    std::vector<Index> images(to_size(whole.mesh.n_vertices()));
    parallel_for(images.size(), 64, [&](std::size_t w) {
        const auto row = static_cast<Eigen::Index>(w);
        images[w] = on_part.closest(b.positions.row(row), b.normals.row(row));
    });
    for (Index w = 0; w < whole.mesh.n_vertices(); ++w) {
        const Index v = images[to_size(w)];
        add(fit(b, w, a, v, tuning), whole_areas[w], open_part[to_size(v)] != 0);
    }
    const double area = part_areas.sum() + whole_areas.sum();
    result.fits /= area;
    result.lacks /= area;
    result.total = result.fits - tuning.lack_weight * result.lacks;
    return result;
}

}  // namespace counterpart::partial_match
