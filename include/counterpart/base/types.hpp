// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <Eigen/Core>
#include <Eigen/SparseCore>

/// Which point of mesh B is this point of mesh A?
namespace counterpart {

/// A 0-based vertex or triangle index.
using Index = std::int32_t;
/// N x 3 coordinates, row-major: what NumPy and graphics buffers hold.
using Points = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
/// M x 3 vertex indices, row-major.
using Triangles = Eigen::Matrix<Index, Eigen::Dynamic, 3, Eigen::RowMajor>;
/// Row-major dense matrix.
using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using Vector = Eigen::VectorXd;
using SparseMatrix = Eigen::SparseMatrix<double>;

}  // namespace counterpart
