// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/lift.hpp"

#include "align/elastic_fit.hpp"
#include "base/parallel.hpp"

#include <counterpart/mesh/adjacency.hpp>

#include <algorithm>

namespace counterpart::spectral_match {
namespace {

using Lists = std::vector<std::vector<Index>>;

// A full surface, and the vertices of the mesh that was matched, around which its own lie.
struct FullSurface {
    const PreparedShape& shape;
    const Points& vertices;
    const Points& normals;
    Lists cells;  // full vertices around each matched one
    Adjacency neighbors;

    explicit FullSurface(const PreparedShape& of)
        : shape(of),
          vertices(of.full ? of.full->mesh.vertices : of.mesh.vertices),
          normals(of.full ? of.full->normals : of.normals),
          cells(at(of.mesh.n_vertices())),
          neighbors(of.mesh) {
        for (Index v = 0; v < static_cast<Index>(vertices.rows()); ++v)
            cells[at(of.full ? of.full->cell_of_vertex[at(v)] : v)].push_back(v);
    }
};

// Where the neighborhoods of the matched mesh go.
struct Bending {
    Points positions;
    align::LocalSimilarities similarities;
};

Bending bend(const PreparedShape& from, const PreparedShape& to, const std::vector<Index>& map,
             const SpectralTuning& tuning, const ProgressRange& progress) {
    const align::ScaleBounds scales{tuning.refinement.min_scale, tuning.refinement.max_scale};
    const Points images = to.mesh.vertices(map, Eigen::all);
    const double length = tuning.polish.lift_length;
    Bending bending;
    bending.positions = align::ElasticFit(from.mesh.vertices, from.laplacian.stiffness, {.scales = scales})(
        images, from.laplacian.mass / (length * length), images, tuning.polish.n_lift_iterations, progress);
    bending.similarities = align::local_similarities(
        align::Springs(from.laplacian.stiffness, from.mesh.vertices), bending.positions, scales);
    return bending;
}

// Positions and normals of one cell's vertices after bending, weighted: each goes with the neighborhoods
// around it, the less the farther they are.
MatrixF bent_cell(const FullSurface& from, const Bending& bending, Index cell,
                  const RefinementTuning& tuning) {
    std::vector<Index> around{cell};
    for (const Index n : from.neighbors.neighbors(cell)) around.push_back(n);
    const Points& centers = from.shape.mesh.vertices;
    double reach = 0;
    for (const Index n : around) reach = std::max(reach, (centers.row(n) - centers.row(cell)).norm());
    const std::vector<Index>& members = from.cells[at(cell)];
    MatrixF result(static_cast<Eigen::Index>(members.size()), 6);
    for (std::size_t i = 0; i < members.size(); ++i) {
        const Eigen::RowVector3d x = from.vertices.row(members[i]);
        Eigen::RowVector3d position = Eigen::RowVector3d::Zero(), normal = position;
        double sum = 0;
        for (const Index n : around) {
            const Eigen::RowVector3d apart = x - centers.row(n);
            const double closeness = std::max(reach - apart.norm(), n == cell ? 1e-3 * reach : 0.0);
            const double weight = closeness * closeness + (n == cell ? 1e-300 : 0);
            const align::LocalSimilarity& similarity = bending.similarities[at(n)];
            const Eigen::Matrix3d rotation = similarity.rotation.toRotationMatrix().cast<double>();
            const double scale = static_cast<double>(similarity.scale);
            position += weight * (bending.positions.row(n) + scale * apart * rotation.transpose());
            normal += weight * from.normals.row(members[i]) * rotation.transpose();
            sum += weight;
        }
        result.row(static_cast<Eigen::Index>(i)) << (position / sum * tuning.position_weight).cast<float>(),
            (normal / std::max(normal.norm(), 1e-300) * tuning.normal_weight).cast<float>();
    }
    return result;
}

// Full vertices in the cells around the images of a cell and of its neighbors.
std::vector<Index> choices(const FullSurface& from, const FullSurface& to, Index cell,
                           const std::vector<Index>& map) {
    std::vector<Index> cells;
    const auto add_image = [&](Index n) {
        const Index image = map[at(n)];
        cells.push_back(image);
        for (const Index near : to.neighbors.neighbors(image)) cells.push_back(near);
    };
    add_image(cell);
    for (const Index n : from.neighbors.neighbors(cell)) add_image(n);
    std::sort(cells.begin(), cells.end());
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
    std::vector<Index> vertices;
    for (const Index c : cells)
        vertices.insert(vertices.end(), to.cells[at(c)].begin(), to.cells[at(c)].end());
    std::sort(vertices.begin(), vertices.end());
    return vertices;
}

std::vector<Index> lifted(const FullSurface& from, const FullSurface& to, const std::vector<Index>& map,
                          const SpectralTuning& all_tuning, const ProgressRange& progress) {
    const Bending bending = bend(from.shape, to.shape, map, all_tuning, progress);
    const RefinementTuning& tuning = all_tuning.refinement;
    std::vector<Index> image(at(from.vertices.rows()));
    parallel_for(from.cells.size(), 1, [&](std::size_t c) {
        progress.check();
        const auto cell = static_cast<Index>(c);
        const std::vector<Index> near = choices(from, to, cell, map);
        const MatrixF ours = bent_cell(from, bending, cell, tuning);
        MatrixF theirs(static_cast<Eigen::Index>(near.size()), 6);
        for (std::size_t i = 0; i < near.size(); ++i)
            theirs.row(static_cast<Eigen::Index>(i))
                << (to.vertices.row(near[i]) * tuning.position_weight).cast<float>(),
                (to.normals.row(near[i]) * tuning.normal_weight).cast<float>();
        const BestPartners found =
            best_partners(ours, theirs, VectorF::Zero(ours.rows()), theirs.rowwise().squaredNorm() / 2);
        for (std::size_t i = 0; i < from.cells[c].size(); ++i)
            image[at(from.cells[c][i])] = near[at(found.of_row[i])];
    });
    return image;
}

}  // namespace

PairedMaps lift(const PreparedShape& a, const PreparedShape& b, const PairedMaps& maps,
                const SpectralTuning& tuning, const ProgressRange& progress) {
    if (!a.full && !b.full) return maps;
    const FullSurface on_a(a), on_b(b);
    return {lifted(on_a, on_b, maps.b_from_a, tuning, progress),
            lifted(on_b, on_a, maps.a_from_b, tuning, progress)};
}

Vector lift(const PreparedShape& shape, const Vector& values) {
    return shape.full ? Vector(values(shape.full->cell_of_vertex)) : values;
}

}  // namespace counterpart::spectral_match
