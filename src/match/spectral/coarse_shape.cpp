// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/coarse_shape.hpp"

#include "match/surface/proxy.hpp"

#include <counterpart/mesh/measure.hpp>

#include <numeric>
#include <utility>

namespace counterpart::spectral_match {
namespace {

// What refinement reads, at some of the vertices.
PreparedShape restricted(const PreparedShape& fine, const surface_match::Proxy& proxy) {
    const std::vector<Index>& kept = proxy.full_of_proxy;
    PreparedShape coarse;
    coarse.full = {fine.mesh, fine.normals, proxy.cell_of_full};
    coarse.mesh = proxy.mesh;
    coarse.flat = fine.flat;
    coarse.laplacian = laplace_beltrami(coarse.mesh);
    coarse.basis = {fine.basis.eigenvalues, fine.basis.eigenfunctions(kept, Eigen::all),
                    coarse.laplacian.mass};
    coarse.all = {fine.all.functions(kept, Eigen::all), fine.all.frequencies};
    coarse.normals = fine.normals(kept, Eigen::all);
    coarse.curvature = fine.curvature(kept, Eigen::all);
    coarse.relief = fine.relief(kept, Eigen::all);
    coarse.wave_kernel = fine.wave_kernel(kept, Eigen::all);
    for (const Index sample : fine.samples) coarse.samples.push_back(proxy.cell_of_full[at(sample)]);
    for (const Index v : kept) coarse.cell_of_vertex.push_back(fine.cell_of_vertex[at(v)]);
    coarse.sample_distances = fine.sample_distances(Eigen::all, kept);
    coarse.extremities = fine.extremities;
    for (geodesic::Extremity& extremity : coarse.extremities)
        extremity.vertex = proxy.cell_of_full[at(extremity.vertex)];
    coarse.n_prominent = fine.n_prominent;
    coarse.extremity_distances = fine.extremity_distances(Eigen::all, kept);
    coarse.orientation = fine.orientation;
    return coarse;
}

CoarseShape as_it_is(const PreparedShape& fine) {
    CoarseShape same{fine, std::vector<Index>(at(fine.mesh.n_vertices())), {}};
    same.shape.full.reset();
    std::iota(same.fine_of_coarse.begin(), same.fine_of_coarse.end(), 0);
    same.coarse_of_fine = same.fine_of_coarse;
    return same;
}

}  // namespace

CoarseShape coarsened(const PreparedShape& fine, Index n_vertices, const PreparationTuning& tuning) {
    const double least = tuning.min_proxy_area * surface_area(fine.mesh);
    for (; n_vertices < fine.mesh.n_vertices(); n_vertices *= 2) {
        surface_match::Proxy proxy = surface_match::make_proxy(fine.mesh, n_vertices);
        // Of a surface that no proxy resolves (dust, thin leaves) one of this size is still better than all
        // of it.
        const bool is_largest =
            2 * n_vertices > tuning.proxy_size && fine.mesh.n_vertices() > tuning.large_mesh;
        if (surface_area(proxy.mesh) < least && !(is_largest && proxy.mesh.n_triangles() > 0)) continue;
        PreparedShape shape = restricted(fine, proxy);
        return {std::move(shape), std::move(proxy.full_of_proxy), std::move(proxy.cell_of_full)};
    }
    return as_it_is(fine);
}

Priors coarsened(const Priors& priors, const CoarseShape& a, const CoarseShape& b) {
    Priors coarse = priors;
    for (std::vector<PriorPair>* pairs : {&coarse.landmarks, &coarse.excluded})
        for (PriorPair& pair : *pairs)
            pair = {a.coarse_of_fine[at(pair.a)], b.coarse_of_fine[at(pair.b)],
                    VectorF(pair.from_a(a.fine_of_coarse)), VectorF(pair.from_b(b.fine_of_coarse))};
    return coarse;
}

}  // namespace counterpart::spectral_match
