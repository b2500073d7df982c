// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/local_search.hpp"

#include "base/parallel.hpp"

#include <algorithm>
#include <vector>

namespace counterpart::spectral_match {
namespace {

using Lists = std::vector<std::vector<Index>>;

Lists vertices_of_cells(const Shape& shape) {
    Lists cells(shape.samples.size());
    for (std::size_t v = 0; v < shape.cell_of_vertex.size(); ++v)
        cells[static_cast<std::size_t>(shape.cell_of_vertex[v])].push_back(static_cast<Index>(v));
    return cells;
}

void sort_unique(std::vector<Index>& list) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
}

// Cells within two steps of each cell, itself included.
Lists near_cells(const Shape& shape) {
    Lists touching(shape.samples.size());
    const auto cell = [&](Index v) { return shape.cell_of_vertex[static_cast<std::size_t>(v)]; };
    for (std::size_t c = 0; c < touching.size(); ++c) touching[c].push_back(static_cast<Index>(c));
    for (Index t = 0; t < shape.mesh.n_triangles(); ++t) {
        for (int i = 0; i < 3; ++i) {
            const Index from = cell(shape.mesh.triangles(t, i)),
                        to = cell(shape.mesh.triangles(t, (i + 1) % 3));
            if (from == to) continue;
            touching[static_cast<std::size_t>(from)].push_back(to);
            touching[static_cast<std::size_t>(to)].push_back(from);
        }
    }
    for (auto& list : touching) sort_unique(list);
    Lists near = touching;
    for (std::size_t c = 0; c < near.size(); ++c) {
        for (const Index neighbor : touching[c]) {
            const auto& further = touching[static_cast<std::size_t>(neighbor)];
            near[c].insert(near[c].end(), further.begin(), further.end());
        }
        sort_unique(near[c]);
    }
    return near;
}

MatrixF rows_of(const MatrixF& all, const std::vector<Index>& rows) {
    MatrixF result(static_cast<Eigen::Index>(rows.size()), all.cols());
    for (std::size_t i = 0; i < rows.size(); ++i) result.row(static_cast<Eigen::Index>(i)) = all.row(rows[i]);
    return result;
}

// from -> to, where x and y are coordinates whose products count and `bias` half the squared lengths on `to`.
std::vector<Index> search(const Lists& from_cells, const Lists& to_cells, const Lists& to_near,
                          const std::vector<Index>& to_from, const MatrixF& x, const MatrixF& y,
                          const VectorF& bias) {
    std::vector<Index> image(static_cast<std::size_t>(x.rows()));
    parallel_for(from_cells.size(), 1, [&](std::size_t c) {
        std::vector<Index> choices;
        for (const Index near : to_near[static_cast<std::size_t>(to_from[c])]) {
            const auto& cell = to_cells[static_cast<std::size_t>(near)];
            choices.insert(choices.end(), cell.begin(), cell.end());
        }
        std::sort(choices.begin(), choices.end());
        const MatrixF ours = rows_of(x, from_cells[c]), theirs = rows_of(y, choices);
        VectorF their_bias(theirs.rows());
        for (std::size_t i = 0; i < choices.size(); ++i)
            their_bias[static_cast<Eigen::Index>(i)] = bias[choices[i]];
        const BestPartners found = best_partners(ours, theirs, VectorF::Zero(ours.rows()), their_bias);
        for (std::size_t i = 0; i < from_cells[c].size(); ++i)
            image[static_cast<std::size_t>(from_cells[c][i])] =
                choices[static_cast<std::size_t>(found.of_row[i])];
    });
    return image;
}

}  // namespace

PairedMaps match_points_nearby(const Shape& a, const Shape& b, const PairedFunctionalMaps& functional,
                               const PairedMaps& sample_maps) {
    const PairCoordinates pair = pair_coordinates(a.all, b.all, functional);
    const Lists cells_a = vertices_of_cells(a), cells_b = vertices_of_cells(b);
    return {search(cells_a, cells_b, near_cells(b), sample_maps.b_from_a, pair.a, pair.b, pair.half_b),
            search(cells_b, cells_a, near_cells(a), sample_maps.a_from_b, pair.b, pair.a, pair.half_a)};
}

}  // namespace counterpart::spectral_match
