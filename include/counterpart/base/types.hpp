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

/// The rows of an array that someone else owns, without a copy: of `Points`, or of memory that is laid out
/// like it (a NumPy array, a graphics buffer). It must not outlive them. Functions take their arrays as views
/// by value.
template <typename Rows>
class RowsView : public Eigen::Map<const Rows> {
  public:
    using Eigen::Map<const Rows>::Map;
    RowsView() : Eigen::Map<const Rows>(nullptr, 0, 3) {}
    RowsView(const Rows& rows) : Eigen::Map<const Rows>(rows.data(), rows.rows(), rows.cols()) {}
    RowsView(const RowsView&) = default;
    RowsView& operator=(const RowsView&) = delete;
};

using PointsView = RowsView<Points>;
using TrianglesView = RowsView<Triangles>;
using SparseMatrix = Eigen::SparseMatrix<double>;

}  // namespace counterpart
