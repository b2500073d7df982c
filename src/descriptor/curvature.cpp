// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include <counterpart/base/errors.hpp>
#include <counterpart/descriptor/descriptors.hpp>
#include <counterpart/mesh/measure.hpp>

namespace counterpart {

Vector mean_curvature(MeshView mesh, const LaplaceBeltrami& laplacian) {
    if (laplacian.mass.size() != mesh.n_vertices())
        throw InvalidInput("mean_curvature: the Laplacian belongs to another mesh");
    const Points laplace_of_position = laplacian.stiffness * mesh.vertices;
    const Points normals = vertex_normals(mesh);
    return laplace_of_position.cwiseProduct(normals).rowwise().sum().array() / (2 * laplacian.mass.array());
}

Eigen::MatrixXd diffuse(const Vector& function, const EigenBasis& basis, const std::vector<double>& times) {
    if (function.size() != basis.mass.size())
        throw InvalidInput("diffuse: the function and the basis have different numbers of vertices");
    const Vector coefficients = basis.eigenfunctions.transpose() * basis.mass.cwiseProduct(function);
    Eigen::MatrixXd filtered(basis.size(), static_cast<Eigen::Index>(times.size()));
    for (std::size_t i = 0; i < times.size(); ++i)
        filtered.col(static_cast<Eigen::Index>(i)) =
            coefficients.array() * (-times[i] * basis.eigenvalues.array()).exp();
    return basis.eigenfunctions * filtered;
}

}  // namespace counterpart
