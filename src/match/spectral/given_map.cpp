// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/given_map.hpp"

#include "numerics/nearest_neighbors.hpp"

#include <counterpart/base/errors.hpp>

#include <utility>
#include <vector>

namespace counterpart::spectral_match {
namespace {

// The input vertex of each that is matched; of a large mesh, of its proxy's.
std::vector<Index> input_of_vertices(const PreparedShape& shape) {
    if (!shape.full) return shape.origin.input_of_matched;
    std::vector<Index> input(at(shape.mesh.n_vertices()), 0);
    const Points &full = shape.full->mesh.vertices, &proxy = shape.mesh.vertices;
    for (Index f = 0; f < shape.n_full_vertices(); ++f) {
        const Index v = shape.full->cell_of_vertex[at(f)];
        if ((full.row(f) - proxy.row(v)).isZero(0)) input[at(v)] = shape.origin.input_of_matched[at(f)];
    }
    return input;
}

std::vector<Index> forward(const PreparedShape& a, const PreparedShape& b, const VertexMap& map) {
    const std::vector<Index> input = input_of_vertices(a);
    std::vector<Index> image(at(a.mesh.n_vertices()), -1), known;
    for (Index v = 0; v < a.mesh.n_vertices(); ++v) {
        if (map[input[at(v)]] < 0) continue;
        image[at(v)] = b.vertex_of_input(map[input[at(v)]]);
        known.push_back(v);
    }
    if (known.empty()) throw InvalidInput("the initial map matches no vertex: leave it out");
    const numerics::NearestNeighbors nearest(Points(a.mesh.vertices(known, Eigen::all)));
    for (Index v = 0; v < a.mesh.n_vertices(); ++v)
        if (image[at(v)] < 0)
            image[at(v)] = image[at(known[at(nearest.closest(a.mesh.vertices.row(v)).index)])];
    return image;
}

Map better(const Map& x, const Map& y) { return y.rank() > x.rank() ? y : x; }

}  // namespace

Map given_map(const Level& whole, const VertexMap& target_from_source) {
    const PreparedShape &a = whole.a.shape, &b = whole.b.shape;
    PairedMaps maps{forward(a, b, target_from_source), {}};
    const numerics::NearestNeighbors images(Points(b.mesh.vertices(maps.b_from_a, Eigen::all)));
    for (Index w = 0; w < b.mesh.n_vertices(); ++w)
        maps.a_from_b.push_back(images.closest(b.mesh.vertices.row(w)).index);
    return scored(whole, pinned(std::move(maps), whole.pair.priors.pins()));
}

Polished polish_given(const Map& given, const Level& whole, const ProgressRange& progress) {
    Map best = better(given, Refiner(whole)(given, whole.tuning.polish.given, {}, progress.part(0, 0.5)));
    const NearIsometry near = grown_near_isometry(whole, best);
    if (near.is_one) best = better(best, refined_near_isometry(whole, near, progress.part(0.5, 1)));
    progress.reach(1);
    return {std::move(best), {}};
}

}  // namespace counterpart::spectral_match
