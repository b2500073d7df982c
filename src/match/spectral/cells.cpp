// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/cells.hpp"

#include "base/parallel.hpp"

#include <algorithm>
#include <limits>

namespace counterpart::spectral_match {
namespace {

// Vertices of a cell from which on a product of matrices is quicker than single ones.
constexpr std::size_t worth_gathering = 3;

void sort_unique(std::vector<Index>& list) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
}

MatrixF rows_of(const MatrixF& all, const std::vector<Index>& rows) {
    MatrixF result(static_cast<Eigen::Index>(rows.size()), all.cols());
    for (std::size_t i = 0; i < rows.size(); ++i) result.row(static_cast<Eigen::Index>(i)) = all.row(rows[i]);
    return result;
}

// Vertices in the cells that are near the images of a cell's vertices, increasing.
std::vector<Index> choices(const std::vector<Index>& cell, const Cells& to, const Cells::Lists& near,
                           const std::vector<Index>& guess) {
    std::vector<Index> around, wider, result;
    for (const Index v : cell) around.push_back(to.of_vertex(guess[at(v)]));
    sort_unique(around);
    for (const Index image : around)
        wider.insert(wider.end(), near[at(image)].begin(), near[at(image)].end());
    sort_unique(wider);
    for (const Index c : wider)
        result.insert(result.end(), to.vertices()[at(c)].begin(), to.vertices()[at(c)].end());
    std::sort(result.begin(), result.end());
    return result;
}

// The best of the choices for one vertex.
Index nearest_of(const MatrixF& ours, Index v, const MatrixF& theirs, const VectorF& half,
                 const std::vector<Index>& there, Index otherwise) {
    float most = -std::numeric_limits<float>::max();
    Index best = otherwise;
    for (const Index w : there) {
        const float value = ours.row(v).dot(theirs.row(w)) - half[w];
        if (value > most) most = value, best = w;
    }
    return best;
}

std::vector<Index> spread_one(const PreparedShape& from, const PreparedShape& to,
                              const std::vector<Index>& map) {
    std::vector<Index> image;
    for (const Index cell : from.cell_of_vertex) image.push_back(to.samples[at(map[at(cell)])]);
    return image;
}

}  // namespace

Cells::Cells(const PreparedShape& shape)
    : shape_(shape), vertices_(shape.samples.size()), touching_(shape.samples.size()) {
    for (Index v = 0; v < shape.mesh.n_vertices(); ++v) vertices_[at(of_vertex(v))].push_back(v);
    for (std::size_t c = 0; c < touching_.size(); ++c) touching_[c].push_back(static_cast<Index>(c));
    for (Index t = 0; t < shape.mesh.n_triangles(); ++t) {
        for (int i = 0; i < 3; ++i) {
            const Index x = of_vertex(shape.mesh.triangles(t, i)),
                        y = of_vertex(shape.mesh.triangles(t, (i + 1) % 3));
            if (x == y) continue;
            touching_[at(x)].push_back(y);
            touching_[at(y)].push_back(x);
        }
    }
    for (auto& list : touching_) sort_unique(list);
}

Cells::Lists Cells::near(int rings) const {
    Lists near = touching_;
    for (int ring = 1; ring < rings; ++ring) {
        for (auto& list : near) {
            const std::vector<Index> inner = list;
            for (const Index c : inner)
                list.insert(list.end(), touching_[at(c)].begin(), touching_[at(c)].end());
            sort_unique(list);
        }
    }
    return near;
}

PairedMaps spread(const PreparedShape& a, const PreparedShape& b, const PairedMaps& sample_maps) {
    return {spread_one(a, b, sample_maps.b_from_a), spread_one(b, a, sample_maps.a_from_b)};
}

std::vector<Index> nearest_nearby(const Cells& from, const Cells& to, const Cells::Lists& near,
                                  const MatrixF& ours, const MatrixF& theirs, const VectorF& half,
                                  const std::vector<Index>& guess, const ProgressRange& progress) {
    std::vector<Index> image = guess;
    parallel_for(from.vertices().size(), 1, [&](std::size_t c) {
        progress.check();
        const std::vector<Index>& cell = from.vertices()[c];
        if (cell.empty()) return;
        const std::vector<Index> there = choices(cell, to, near, guess);
        if (cell.size() < worth_gathering) {
            for (const Index v : cell) image[at(v)] = nearest_of(ours, v, theirs, half, there, guess[at(v)]);
            return;
        }
        VectorF bias(static_cast<Eigen::Index>(there.size()));
        for (std::size_t i = 0; i < there.size(); ++i) bias[static_cast<Eigen::Index>(i)] = half[there[i]];
        const MatrixF here = rows_of(ours, cell);
        const BestPartners found =
            best_partners(here, rows_of(theirs, there), VectorF::Zero(here.rows()), bias);
        for (std::size_t i = 0; i < cell.size(); ++i) image[at(cell[i])] = there[at(found.of_row[i])];
    });
    return image;
}

}  // namespace counterpart::spectral_match
