// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "spectral/orientation.hpp"

#include <counterpart/base/errors.hpp>

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace counterpart::spectral {

OrientationTensor orientation_tensor(MeshView mesh, const EigenBasis& basis, int size, int n_coefficients) {
    if (basis.mass.size() != mesh.n_vertices())
        throw InvalidInput("orientation_tensor: the basis belongs to another mesh");
    if (size < 2 || n_coefficients < 2)
        throw InvalidInput("orientation_tensor: at least 2 functions and coefficients are needed");
    OrientationTensor result;
    result.size = std::min(size, basis.size());
    result.n_coefficients = std::min(n_coefficients, basis.size());
    const Eigen::MatrixXd& phi = basis.eigenfunctions;
    // In a triangle with corners 0, 1, 2 and area T: omega(f, g) = (df1 dg2 - df2 dg1) / (2 T). Its integral
    // against a linear function is T * omega * mean of the function: the area cancels.
    const int s = result.size;
    Eigen::MatrixXd coefficients = Eigen::MatrixXd::Zero(s * (s - 1) / 2, result.n_coefficients);
    constexpr Index block = 2048;  // triangles at a time, to keep the table of products small
    for (Index start = 0; start < mesh.n_triangles(); start += block) {
        const Index n = std::min(block, mesh.n_triangles() - start);
        Eigen::MatrixXd first(n, s), second(n, s), mean(n, result.n_coefficients), omega(n, s * (s - 1) / 2);
        for (Index t = 0; t < n; ++t) {
            const Index a = mesh.triangles(start + t, 0), b = mesh.triangles(start + t, 1),
                        c = mesh.triangles(start + t, 2);
            first.row(t) = phi.row(b).head(s) - phi.row(a).head(s);
            second.row(t) = phi.row(c).head(s) - phi.row(a).head(s);
            mean.row(t) = (phi.row(a) + phi.row(b) + phi.row(c)).head(result.n_coefficients) / 6;
        }
        for (int i = 0, column = 0; i < s; ++i)
            for (int j = i + 1; j < s; ++j, ++column)
                omega.col(column) =
                    first.col(i).cwiseProduct(second.col(j)) - second.col(i).cwiseProduct(first.col(j));
        coefficients.noalias() += omega.transpose() * mean;
    }
    result.values.setZero(s * s, result.n_coefficients);
    for (int i = 0, row = 0; i < s; ++i) {
        for (int j = i + 1; j < s; ++j, ++row) {
            result.values.row(i * s + j) = coefficients.row(row).cast<float>();
            result.values.row(j * s + i) = -coefficients.row(row).cast<float>();
        }
    }
    return result;
}

double orientation_score(const OrientationTensor& a, const OrientationTensor& b,
                         const Eigen::MatrixXf& a_from_b) {
    if (a_from_b.size() == 0) throw InvalidInput("orientation_score: the functional map is empty");
    const int sa = std::min<int>(a.size, static_cast<int>(a_from_b.rows()));
    const int sb = std::min<int>(b.size, static_cast<int>(a_from_b.cols()));
    const int ca = std::min<int>(a.n_coefficients, static_cast<int>(a_from_b.rows()));
    const int cb = std::min<int>(b.n_coefficients, static_cast<int>(a_from_b.cols()));
    const Eigen::MatrixXf c = a_from_b.topLeftCorner(sa, sb);
    // Pulled back: the tensor of B with its coefficients taken to A; pushed: the tensor of A on C phi_i, C
    // phi_j.
    const Eigen::MatrixXf pulled = b.values.leftCols(cb) * a_from_b.topLeftCorner(ca, cb).transpose();
    double product = 0, norm_pulled = 0, norm_pushed = 0;
    Eigen::MatrixXf slice(sa, sa);
    for (int m = 0; m < ca; ++m) {
        for (int i = 0; i < sa; ++i)
            for (int j = 0; j < sa; ++j) slice(i, j) = a.values(i * a.size + j, m);
        const Eigen::MatrixXf pushed = c.transpose() * slice * c;
        for (int i = 0; i < sb; ++i) {
            for (int j = i + 1; j < sb; ++j) {
                const double x = pulled(i * b.size + j, m), y = pushed(i, j);
                product += x * y;
                norm_pulled += x * x;
                norm_pushed += y * y;
            }
        }
    }
    const double norm = std::sqrt(norm_pulled * norm_pushed);
    return norm > 0 ? product / norm : 0;
}

}  // namespace counterpart::spectral
