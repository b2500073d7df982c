// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/restricted_nearest.hpp"

#include "base/parallel.hpp"

#include <algorithm>
#include <vector>

namespace counterpart::spectral_match {
namespace {

using Lists = std::vector<std::vector<Index>>;

Lists vertices_of_cells(const PreparedShape& shape) {
    Lists cells(shape.samples.size());
    for (std::size_t v = 0; v < shape.cell_of_vertex.size(); ++v)
        cells[static_cast<std::size_t>(shape.cell_of_vertex[v])].push_back(static_cast<Index>(v));
    return cells;
}

void sort_unique(std::vector<Index>& list) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
}

// Cells within `rings` steps of each cell, itself included.
Lists near_cells(const PreparedShape& shape, int rings) {
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
    for (int ring = 1; ring < rings; ++ring) {
        for (auto& list : near) {
            const std::vector<Index> inner = list;
            for (const Index neighbor : inner) {
                const auto& further = touching[static_cast<std::size_t>(neighbor)];
                list.insert(list.end(), further.begin(), further.end());
            }
            sort_unique(list);
        }
    }
    return near;
}

MatrixF rows_of(const MatrixF& all, const std::vector<Index>& rows) {
    MatrixF result(static_cast<Eigen::Index>(rows.size()), all.cols());
    for (std::size_t i = 0; i < rows.size(); ++i) result.row(static_cast<Eigen::Index>(i)) = all.row(rows[i]);
    return result;
}

// One side of a pair of shapes as the search sees it.
struct PairSide {
    const PreparedShape& shape;
    const MatrixF& coordinates;
    const VectorF& bias;  // half the squared lengths
    Lists cells, near;

    PairSide(const PreparedShape& of, const MatrixF& coordinates_, const VectorF& bias_, int rings)
        : shape(of),
          coordinates(coordinates_),
          bias(bias_),
          cells(vertices_of_cells(of)),
          near(near_cells(of, rings)) {}
};

std::vector<Index> search(const PairSide& from, const PairSide& to, const std::vector<Index>& guess,
                          const ProgressRange& progress) {
    std::vector<Index> image = guess;
    parallel_for(from.cells.size(), 1, [&](std::size_t c) {
        progress.check();
        if (from.cells[c].empty()) return;
        std::vector<Index> around, choices;
        for (const Index v : from.cells[c])
            around.push_back(
                to.shape.cell_of_vertex[static_cast<std::size_t>(guess[static_cast<std::size_t>(v)])]);
        sort_unique(around);
        std::vector<Index> wider;
        for (const Index cell : around) {
            const auto& near = to.near[static_cast<std::size_t>(cell)];
            wider.insert(wider.end(), near.begin(), near.end());
        }
        sort_unique(wider);
        for (const Index near : wider) {
            const auto& cell = to.cells[static_cast<std::size_t>(near)];
            choices.insert(choices.end(), cell.begin(), cell.end());
        }
        std::sort(choices.begin(), choices.end());
        const MatrixF ours = rows_of(from.coordinates, from.cells[c]),
                      theirs = rows_of(to.coordinates, choices);
        VectorF bias(theirs.rows());
        for (std::size_t i = 0; i < choices.size(); ++i)
            bias[static_cast<Eigen::Index>(i)] = to.bias[choices[i]];
        const BestPartners found = best_partners(ours, theirs, VectorF::Zero(ours.rows()), bias);
        for (std::size_t i = 0; i < from.cells[c].size(); ++i)
            image[static_cast<std::size_t>(from.cells[c][i])] =
                choices[static_cast<std::size_t>(found.of_row[i])];
    });
    return image;
}

std::vector<Index> spread_one(const PreparedShape& from, const PreparedShape& to,
                              const std::vector<Index>& map) {
    std::vector<Index> image(from.cell_of_vertex.size());
    for (std::size_t v = 0; v < image.size(); ++v)
        image[v] =
            to.samples[static_cast<std::size_t>(map[static_cast<std::size_t>(from.cell_of_vertex[v])])];
    return image;
}

}  // namespace

PairedMaps spread(const PreparedShape& a, const PreparedShape& b, const PairedMaps& sample_maps) {
    return {spread_one(a, b, sample_maps.b_from_a), spread_one(b, a, sample_maps.a_from_b)};
}

PairedMaps match_points_nearby(const PreparedShape& a, const PreparedShape& b,
                               const PairedFunctionalMaps& functional, const PairedMaps& guess, int rings,
                               const ExtraCoordinates& extra, const ProgressRange& progress) {
    const PairCoordinates pair = pair_coordinates(a.all, b.all, functional, extra);
    const PairSide on_a(a, pair.a, pair.half_a, rings), on_b(b, pair.b, pair.half_b, rings);
    return {search(on_a, on_b, guess.b_from_a, progress), search(on_b, on_a, guess.a_from_b, progress)};
}

}  // namespace counterpart::spectral_match
