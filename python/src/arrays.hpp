// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// NumPy arrays in and out. What comes in has been given its type and layout by the Python side; it is copied
// before it is checked, since other threads may change an array while the library runs without the
// interpreter's lock. What goes out takes over the memory of the result.
#pragma once

#include <counterpart/base/types.hpp>
#include <counterpart/map/surface_map.hpp>
#include <counterpart/map/vertex_map.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

namespace counterpart::python {

namespace nb = nanobind;

using PointArray = nb::ndarray<const double, nb::shape<-1, 3>, nb::c_contig, nb::device::cpu>;
using TriangleArray = nb::ndarray<const Index, nb::shape<-1, 3>, nb::c_contig, nb::device::cpu>;
using IndexArray = nb::ndarray<const Index, nb::ndim<1>, nb::c_contig, nb::device::cpu>;
using PairArray = nb::ndarray<const Index, nb::shape<-1, 2>, nb::c_contig, nb::device::cpu>;
using VectorArray = nb::ndarray<const double, nb::ndim<1>, nb::c_contig, nb::device::cpu>;
using MatrixArray = nb::ndarray<const double, nb::ndim<2>, nb::c_contig, nb::device::cpu>;
/// Column-major, as eigenfunctions are kept.
using ColumnArray = nb::ndarray<const double, nb::ndim<2>, nb::f_contig, nb::device::cpu>;

// ---- in ----
inline std::vector<Index> vector_of(const IndexArray& array) {
    return {array.data(), array.data() + array.size()};
}
inline std::vector<std::pair<Index, Index>> pairs_of(const PairArray& array) {
    std::vector<std::pair<Index, Index>> pairs(array.shape(0));
    for (std::size_t i = 0; i < pairs.size(); ++i) pairs[i] = {array(i, 0), array(i, 1)};
    return pairs;
}
inline VertexMap vertex_map_of(const IndexArray& array, Index target_size) {
    return {vector_of(array), target_size};
}
inline Eigen::Map<const Vector> map_of(const VectorArray& array) {
    return {array.data(), static_cast<Eigen::Index>(array.size())};
}
inline PointsView map_of(const PointArray& array) {
    return {array.data(), static_cast<Eigen::Index>(array.shape(0)), 3};
}
inline TrianglesView map_of(const TriangleArray& array) {
    return {array.data(), static_cast<Eigen::Index>(array.shape(0)), 3};
}
inline Eigen::Map<const Matrix> map_of(const MatrixArray& array) {
    return {array.data(), static_cast<Eigen::Index>(array.shape(0)),
            static_cast<Eigen::Index>(array.shape(1))};
}
inline Eigen::Map<const Eigen::MatrixXd> map_of(const ColumnArray& array) {
    return {array.data(), static_cast<Eigen::Index>(array.shape(0)),
            static_cast<Eigen::Index>(array.shape(1))};
}
/// A valid mesh, for a call.
class Mesh {
  public:
    /// A copy of the arrays. Throws InvalidInput as require_valid does.
    Mesh(const PointArray& vertices, const TriangleArray& triangles);
    /// One that is valid, outlives it and does not change, with its polygons.
    explicit Mesh(const TriangleMesh& mesh) : view_(mesh) {}
    Mesh(const Mesh&) = delete;
    Mesh& operator=(const Mesh&) = delete;

    MeshView view() const { return view_; }
    operator MeshView() const { return view_; }
    Index n_vertices() const { return view_.n_vertices(); }
    Index n_triangles() const { return view_.n_triangles(); }

  private:
    TriangleMesh copy_;
    MeshView view_;
};

/// From its triangles and weights (n x 3); throws InvalidInput unless it fits that many target triangles.
SurfaceMap surface_map_of(const IndexArray& triangle, const PointArray& weights, Index target_triangles);

// ---- out ----
/// The owner of `value`, which the arrays made of it keep alive.
template <class T>
std::pair<T*, nb::capsule> keep(T value) {
    auto* kept = new T(std::move(value));
    return {kept, nb::capsule(kept, [](void* memory) noexcept { delete static_cast<T*>(memory); })};
}

template <class T>
using NewVector = nb::ndarray<nb::numpy, T, nb::ndim<1>>;
template <class T>
using NewMatrix = nb::ndarray<nb::numpy, T, nb::ndim<2>>;

template <class T>
NewVector<T> array(std::vector<T> values) {
    const std::size_t size = values.size();
    auto [kept, owner] = keep(std::move(values));
    return {kept->data(), {size}, owner};
}
inline NewVector<double> array(Vector values) {
    const auto size = static_cast<std::size_t>(values.size());
    auto [kept, owner] = keep(std::move(values));
    return {kept->data(), {size}, owner};
}
/// Any dense matrix, in its own order.
template <class Derived>
NewMatrix<typename Derived::Scalar> matrix_array(Derived matrix) {
    const auto rows = matrix.rows(), columns = matrix.cols();
    auto [kept, owner] = keep(std::move(matrix));
    return {kept->data(),
            {static_cast<std::size_t>(rows), static_cast<std::size_t>(columns)},
            owner,
            {Derived::IsRowMajor ? columns : 1, Derived::IsRowMajor ? 1 : rows}};
}
inline NewVector<Index> array(const VertexMap& map) { return array(map.image()); }
/// The triangles (n) and the weights (n x 3).
std::tuple<NewVector<Index>, NewMatrix<double>> arrays(const SurfaceMap& map);
nb::list arrays(std::vector<VertexMap> maps);
/// Vertices and triangles.
std::tuple<NewMatrix<double>, NewMatrix<Index>> arrays(TriangleMesh mesh);

}  // namespace counterpart::python
