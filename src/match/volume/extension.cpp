// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/volume/extension.hpp"

#include "base/to_size.hpp"

#include <counterpart/base/errors.hpp>

#include <Eigen/Geometry>
#include <Eigen/IterativeLinearSolvers>

namespace counterpart::volume {
namespace {

// The gradients of the four linear functions that are 1 at one corner and 0 at the others, and the volume.
struct Element {
    Eigen::Matrix<double, 4, 3> gradients;
    double volume = 0;
};
Element element_of(const TetrahedralMesh& mesh, Index t) {
    Eigen::Matrix3d edges;
    for (int c = 0; c < 3; ++c)
        edges.row(c) =
            mesh.vertices.row(mesh.tetrahedra(t, c + 1)) - mesh.vertices.row(mesh.tetrahedra(t, 0));
    Element element;
    element.gradients.bottomRows<3>() = edges.inverse().transpose();
    element.gradients.row(0) = -element.gradients.bottomRows<3>().colwise().sum();
    element.volume = edges.determinant() / 6;
    return element;
}

}  // namespace

Matrix extended(const TetrahedralMesh& mesh, const Matrix& values, const std::vector<char>& known) {
    std::vector<Index> row(known.size(), -1), unknown;
    for (Eigen::Index i = 0; i < mesh.tetrahedra.size(); ++i) {
        const Index v = mesh.tetrahedra.data()[i];
        if (known[to_size(v)] || row[to_size(v)] >= 0) continue;
        row[to_size(v)] = static_cast<Index>(unknown.size());
        unknown.push_back(v);
    }
    Matrix result = values;
    if (unknown.empty()) return result;
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::MatrixXd right = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(unknown.size()), values.cols());
    for (Index t = 0; t < mesh.n_tetrahedra(); ++t) {
        const Element element = element_of(mesh, t);
        for (int c = 0; c < 4; ++c) {
            const Index i = row[to_size(mesh.tetrahedra(t, c))];
            if (i < 0) continue;
            for (int d = 0; d < 4; ++d) {
                const double stiffness =
                    element.volume * element.gradients.row(c).dot(element.gradients.row(d));
                const Index w = mesh.tetrahedra(t, d);
                if (row[to_size(w)] >= 0)
                    entries.emplace_back(i, row[to_size(w)], stiffness);
                else
                    right.row(i) -= stiffness * values.row(w);
            }
        }
    }
    SparseMatrix stiffness(right.rows(), right.rows());
    stiffness.setFromTriplets(entries.begin(), entries.end());
    Eigen::ConjugateGradient<SparseMatrix, Eigen::Lower | Eigen::Upper> solver(stiffness);
    constexpr double precise = 1e-8;  // relative residual
    solver.setTolerance(precise);
    for (Eigen::Index k = 0; k < right.cols(); ++k) {
        const Vector column = solver.solve(right.col(k));
        if (!column.allFinite()) throw NumericalError("the map could not be continued into the solid");
        for (std::size_t i = 0; i < unknown.size(); ++i)
            result(unknown[i], k) = column[static_cast<Eigen::Index>(i)];
    }
    return result;
}

}  // namespace counterpart::volume
