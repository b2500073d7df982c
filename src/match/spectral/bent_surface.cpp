// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/bent_surface.hpp"

#include "match/spectral/islands.hpp"
#include "numerics/oriented_neighbors.hpp"

#include <counterpart/mesh/measure.hpp>

#include <algorithm>
#include <utility>

namespace counterpart::spectral_match {
namespace {

// What islands pull, against the rest: enough to hold a component that is spoiled as a whole.
constexpr double hardly = 1e-6;

// Where a surface is pulled to, and how hard, relative to its own pull.
struct Pull {
    Points towards;
    Vector strength;  // empty: 1 everywhere
};

Pull pull_of_both(const PreparedShape& shape, const PreparedShape& other, const PairedMaps& maps,
                  double back_pull, const std::vector<Index>& pinned) {
    Points images = other.mesh.vertices(maps.b_from_a, Eigen::all);
    if (back_pull == 0) return {std::move(images), {}};
    const Vector& area = shape.basis.mass;
    Points offsets = Points::Zero(images.rows(), 3);
    Vector pulling = area;
    for (Index w = 0; w < other.mesh.n_vertices(); ++w) {
        const Index v = maps.a_from_b[at(w)];
        const double pull = back_pull * other.basis.mass[w];
        offsets.row(v) += pull * (other.mesh.vertices.row(w) - images.row(v));
        pulling[v] += pull;
    }
    for (const Index v : pinned) {  // to where they are pinned alone
        offsets.row(v).setZero();
        pulling[v] = (1 + back_pull) * area[v];
    }
    return {images + pulling.cwiseInverse().asDiagonal() * offsets,
            pulling.cwiseQuotient((1 + back_pull) * area)};
}

}  // namespace

BentSurface::BentSurface(const LevelShape& shape, const LevelShape& other, const std::vector<Index>& pinned,
                         align::ElasticFit& fit, const RefinementTuning& tuning)
    : shape_(shape), other_(other), pinned_(pinned), fit_(fit), tuning_(tuning) {
    fit_.forget_rotations();
}

// Pinned vertices pull like a part of the surface of that area.
Vector BentSurface::pull(double stiffness_length) const {
    Vector area = shape_.shape.laplacian.mass;
    for (const Index v : pinned_) area[v] = std::max(area[v], tuning_.pin_mass);
    return area / (stiffness_length * stiffness_length);
}

void BentSurface::bend(const PairedMaps& maps, double back_pull, double stiffness_length, int n_iterations,
                       const ProgressRange& progress) {
    const Pull both = pull_of_both(shape_.shape, other_.shape, maps, back_pull, pinned_);
    Vector strength = pull(stiffness_length);
    if (both.strength.size() > 0) strength.array() *= both.strength.array();
    const Points start =
        positions_.rows() > 0 ? positions_ : Points(other_.shape.mesh.vertices(maps.b_from_a, Eigen::all));
    positions_ = fit_(both.towards, strength, start, n_iterations, progress);
}

std::vector<Index> BentSurface::without_islands(std::vector<Index> image, double stiffness_length,
                                                const ProgressRange& progress) {
    const Islands islands = find_islands(shape_, other_, image, tuning_.islands);
    if (islands.empty) return image;
    progress.check();
    Vector strength = pull(stiffness_length);
    for (std::size_t v = 0; v < image.size(); ++v)
        if (islands.spoiled[v] != 0) strength[static_cast<Index>(v)] *= hardly;
    const Points images = other_.shape.mesh.vertices(image, Eigen::all);
    fit_.forget_rotations();
    positions_ = fit_(images, strength, images, 1, progress, islands.spoiled);
    const Points bent_normals = normals();
    const numerics::OrientedNeighbors on_other(other_.shape.mesh.vertices, other_.shape.normals,
                                               tuning_.normal_weight / tuning_.position_weight);
    for (std::size_t v = 0; v < image.size(); ++v) {
        const auto row = static_cast<Eigen::Index>(v);
        if (islands.inside[v] != 0) image[v] = on_other.closest(positions_.row(row), bent_normals.row(row));
    }
    return image;
}

MatrixF BentSurface::placement() const { return spectral_match::placement(positions_, normals(), tuning_); }

Points BentSurface::normals() const { return vertex_normals({positions_, shape_.shape.mesh.triangles}); }

}  // namespace counterpart::spectral_match
