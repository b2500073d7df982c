// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/stored_shape.hpp"

#include "base/hash_mixing.hpp"

#include <counterpart/base/errors.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>

namespace counterpart::spectral_match {
namespace {

// With the version: to be raised with every change of what is stored or of `prepare`. Its tuning follows.
constexpr std::string_view magic = "counterpart spectral shape 3\n";

// Names every field: a new one does not compile until it is added here.
std::uint64_t hash_of(const PreparationTuning& tuning) {
    const auto& [min_share, n_sources, radius, apart, max_extremities, times, percentile, relief, n_relief,
                 large, proxy, proxy_area, tolerance, min_local, per_function, local_radius] = tuning;
    std::uint64_t hash = 0;
    const auto add = [&](const auto&... values) {
        ((hash = mixed(std::bit_cast<std::uint64_t>(static_cast<double>(values)), hash)), ...);
    };
    add(min_share, n_sources, radius, apart, max_extremities, percentile, relief, n_relief, large, proxy,
        proxy_area, tolerance, min_local, per_function, local_radius);
    for (const double time : times) add(time);
    return hash;
}

void require(bool condition, const char* reason) {
    if (!condition) throw InvalidInput(std::string("not a prepared shape of this version: ") + reason);
}

// Fields one after another; arrays with their sizes in front.
class Writer {
  public:
    template <class... Fields>
    void operator()(const Fields&... fields) {
        (write(fields), ...);
    }
    std::string bytes;

  private:
    template <class Number>
    requires std::is_arithmetic_v<Number>
    void write(Number value) { raw(&value, 1); }
    template <class Number>
    void write(const std::vector<Number>& values) {
        write(std::uint64_t{values.size()});
        raw(values.data(), values.size());
    }
    template <class Derived>
    void write(const Eigen::PlainObjectBase<Derived>& array) {
        write(std::uint64_t(array.rows()));
        write(std::uint64_t(array.cols()));
        raw(array.data(), static_cast<std::size_t>(array.size()));
    }
    void write(const SparseMatrix& matrix) {
        write(std::uint64_t(matrix.rows()));
        write(std::vector(matrix.outerIndexPtr(), matrix.outerIndexPtr() + matrix.cols() + 1));
        write(std::vector(matrix.innerIndexPtr(), matrix.innerIndexPtr() + matrix.nonZeros()));
        write(std::vector(matrix.valuePtr(), matrix.valuePtr() + matrix.nonZeros()));
    }
    template <class Value>
    void raw(const Value* values, std::size_t count) {
        bytes.append(reinterpret_cast<const char*>(values), count * sizeof(Value));
    }
};

class Reader {
  public:
    explicit Reader(std::string_view bytes) : rest_(bytes) {}
    template <class... Fields>
    void operator()(Fields&... fields) {
        (read(fields), ...);
    }
    bool is_at_end() const { return rest_.empty(); }

  private:
    template <class Number>
    requires std::is_arithmetic_v<Number>
    void read(Number& value) {
        raw(&value, 1);
        if constexpr (std::is_floating_point_v<Number>)
            require(std::isfinite(value), "a value is not finite");
    }
    void read(bool& value) {
        std::uint8_t byte = 0;
        read(byte);
        require(byte <= 1, "a yes or no is neither");
        value = byte == 1;
    }
    template <class Number>
    void read(std::vector<Number>& values) {
        values.resize(size<Number>());
        raw(values.data(), values.size());
        require_finite(values.data(), values.size());
    }
    template <class Derived>
    void read(Eigen::PlainObjectBase<Derived>& array) {
        using Number = typename Derived::Scalar;
        std::uint64_t rows = 0, cols = 0;
        (*this)(rows, cols);
        constexpr std::uint64_t most = std::numeric_limits<Index>::max();
        require(rows <= most && cols <= most && rows * cols <= rest_.size() / sizeof(Number),
                "it is cut short");
        require((Derived::RowsAtCompileTime == Eigen::Dynamic ||
                 rows == static_cast<std::uint64_t>(Derived::RowsAtCompileTime)) &&
                    (Derived::ColsAtCompileTime == Eigen::Dynamic ||
                     cols == static_cast<std::uint64_t>(Derived::ColsAtCompileTime)),
                "an array has another form");
        array.resize(static_cast<Eigen::Index>(rows), static_cast<Eigen::Index>(cols));
        raw(array.data(), static_cast<std::size_t>(array.size()));
        require_finite(array.data(), static_cast<std::size_t>(array.size()));
    }
    void read(SparseMatrix& matrix) {
        std::uint64_t rows = 0;
        std::vector<SparseMatrix::StorageIndex> outer, inner;
        std::vector<double> values;
        (*this)(rows, outer, inner, values);
        require(!outer.empty() && inner.size() == values.size() && outer.front() == 0 &&
                    std::is_sorted(outer.begin(), outer.end()) &&
                    static_cast<std::size_t>(outer.back()) == values.size() && rows + 1 == outer.size(),
                "a matrix does not fit together");
        for (std::size_t c = 0; c < rows; ++c) {
            auto row_before = SparseMatrix::StorageIndex(-1);  // rows increase within a column
            for (auto i = static_cast<std::size_t>(outer[c]); i < static_cast<std::size_t>(outer[c + 1]);
                 ++i) {
                require(inner[i] > row_before && static_cast<std::uint64_t>(inner[i]) < rows,
                        "a row is out of range or out of order");
                row_before = inner[i];
            }
        }
        const auto n = static_cast<Eigen::Index>(rows);
        matrix = Eigen::Map<const SparseMatrix>(n, n, static_cast<Eigen::Index>(values.size()), outer.data(),
                                                inner.data(), values.data());
    }
    template <class Number>
    std::size_t size() {
        std::uint64_t count = 0;
        read(count);
        require(count <= rest_.size() / sizeof(Number), "it is cut short");
        return static_cast<std::size_t>(count);
    }
    template <class Value>
    void raw(Value* values, std::size_t count) {
        require(count <= rest_.size() / sizeof(Value), "it is cut short");
        if (count > 0) std::memcpy(values, rest_.data(), count * sizeof(Value));
        rest_.remove_prefix(count * sizeof(Value));
    }
    template <class Number>
    static void require_finite(const Number* values, std::size_t count) {
        if constexpr (std::is_floating_point_v<Number>)
            require(std::all_of(values, values + count, [](Number x) { return std::isfinite(x); }),
                    "a value is not finite");
    }

    std::string_view rest_;
};

// What is stored, in this order: one list for both directions. `derive` makes the rest.
template <class Archive, class Shape>
void visit(Archive& archive, Shape& shape) {
    auto& origin = shape.origin;
    archive(origin.matched_of_input, origin.input_of_matched, origin.left_out, origin.n_merged,
            origin.n_unreferenced, origin.n_duplicate_triangles, origin.n_components,
            origin.n_small_components, origin.small_share, origin.n_boundary_loops,
            origin.n_nonmanifold_edges, origin.n_disagreeing, origin.n_one_sided, origin.was_inside_out);
    bool has_full = shape.full.has_value();
    archive(has_full);
    if constexpr (!std::is_const_v<Shape>)
        if (has_full) shape.full.emplace();
    if (has_full) {
        auto& full = *shape.full;
        archive(full.mesh.vertices, full.mesh.triangles, full.normals, full.cell_of_vertex);
    }
    archive(shape.mesh.vertices, shape.mesh.triangles, shape.flat);
    auto& laplacian = shape.laplacian;
    archive(laplacian.stiffness, laplacian.mass, laplacian.n_flips, laplacian.n_cut_edges,
            laplacian.n_components);
    archive(shape.basis.eigenvalues, shape.basis.eigenfunctions, shape.basis.mass);
    archive(shape.normals, shape.curvature, shape.relief);
    archive(shape.orientation.size, shape.orientation.n_coefficients, shape.orientation.values);
    archive(shape.samples, shape.cell_of_vertex, shape.sample_distances, shape.extremity_distances);
    auto n_extremities = static_cast<std::uint64_t>(shape.extremities.size());
    archive(n_extremities, shape.n_prominent);
    if constexpr (!std::is_const_v<Shape>) {
        require(n_extremities == static_cast<std::uint64_t>(shape.extremity_distances.rows()),
                "extremities are missing");
        shape.extremities.resize(static_cast<std::size_t>(n_extremities));
    }
    for (auto& extremity : shape.extremities) archive(extremity.vertex, extremity.average_distance);
}

void require_below(const std::vector<Index>& numbers, Index end) {
    require(std::all_of(numbers.begin(), numbers.end(), [&](Index i) { return i >= 0 && i < end; }),
            "a number is out of range");
}

void require_mesh(const TriangleMesh& mesh, const Points& normals) {
    require(mesh.triangles.size() == 0 ||
                (mesh.triangles.minCoeff() >= 0 && mesh.triangles.maxCoeff() < mesh.n_vertices()),
            "a triangle is out of range");
    require(normals.rows() == mesh.n_vertices(), "normals are missing");
}

void require_consistent(const PreparedShape& shape) {
    const Index n = shape.mesh.n_vertices(), n_full = shape.n_full_vertices();
    require(n >= min_vertices, "there are too few vertices");
    require_mesh(shape.mesh, shape.normals);
    if (shape.full) {
        require_mesh(shape.full->mesh, shape.full->normals);
        require(static_cast<Index>(shape.full->cell_of_vertex.size()) == n_full, "cells are missing");
        require_below(shape.full->cell_of_vertex, n);
    }
    const Preprocessed& origin = shape.origin;
    const auto n_input = static_cast<Index>(origin.matched_of_input.size());
    require(static_cast<Index>(origin.input_of_matched.size()) == n_full, "vertices are missing");
    require_below(origin.matched_of_input, n_full);
    require_below(origin.input_of_matched, n_input);
    require_below(origin.left_out, n_input);

    const EigenBasis& basis = shape.basis;
    require(basis.eigenfunctions.rows() == n && basis.eigenfunctions.cols() == basis.eigenvalues.size() &&
                basis.size() >= 2 && basis.mass.size() == n,
            "eigenfunctions are missing");
    require(basis.eigenvalues.minCoeff() >= 0 && basis.mass.minCoeff() > 0, "a value is negative");
    require(shape.laplacian.stiffness.rows() == n && shape.laplacian.mass.size() == n &&
                shape.laplacian.mass.minCoeff() > 0,
            "the Laplacian is of another mesh");
    const PreparationTuning tuning;
    require(shape.curvature.rows() == n && shape.relief.rows() == n && shape.relief.cols() == 4 &&
                shape.curvature.cols() == static_cast<Eigen::Index>(tuning.curvature_times.size()),
            "curvature is missing");
    const OrientationTensor& tensor = shape.orientation;
    require(tensor.size >= 2 && tensor.size <= basis.size() && tensor.n_coefficients >= 2 &&
                tensor.n_coefficients <= basis.size() && tensor.values.rows() == tensor.size * tensor.size &&
                tensor.values.cols() == tensor.n_coefficients,
            "the orientation is of another size");
    require(!shape.samples.empty() && static_cast<Index>(shape.cell_of_vertex.size()) == n &&
                shape.sample_distances.rows() >= 1 &&
                shape.sample_distances.rows() <= static_cast<Eigen::Index>(shape.samples.size()) &&
                shape.sample_distances.cols() == n &&
                (shape.extremities.empty() || shape.extremity_distances.cols() == n),
            "samples are missing");
    require_below(shape.samples, n);
    require_below(shape.cell_of_vertex, static_cast<Index>(shape.samples.size()));
    for (const geodesic::Extremity& extremity : shape.extremities) require_below({extremity.vertex}, n);
    require_below({shape.n_prominent}, static_cast<Index>(shape.extremities.size()) + 1);
}

}  // namespace

std::string to_bytes(const PreparedShape& shape, const PreparationTuning& tuning) {
    Writer writer;
    writer.bytes = magic;
    writer(hash_of(tuning));
    visit(writer, shape);
    return std::move(writer.bytes);
}

PreparedShape shape_from_bytes(std::string_view bytes, const PreparationTuning& tuning) {
    require(bytes.starts_with(magic), "it begins with something else");
    Reader reader(bytes.substr(magic.size()));
    std::uint64_t prepared_with = 0;
    reader(prepared_with);
    require(prepared_with == hash_of(tuning), "it was prepared with other constants");
    PreparedShape shape;
    visit(reader, shape);
    require(reader.is_at_end(), "something follows it");
    require_consistent(shape);
    derive(shape);
    return shape;
}

}  // namespace counterpart::spectral_match
