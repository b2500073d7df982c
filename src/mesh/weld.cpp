// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include <counterpart/base/errors.hpp>
#include <counterpart/mesh/weld.hpp>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include <fmt/format.h>

namespace counterpart {
namespace {

using GridCell = std::array<std::int64_t, 3>;

// Kept vertices by cell of a grid: a hash table with chains through the vertices.
class CellTable {
  public:
    explicit CellTable(std::size_t n_vertices)
        : first_(std::bit_ceil(2 * n_vertices), -1), next_(n_vertices, -1), cell_(n_vertices) {}

    void insert(const GridCell& cell, Index kept) {
        Index& head = first_[slot(cell)];
        next_[static_cast<std::size_t>(kept)] = head;
        cell_[static_cast<std::size_t>(kept)] = cell;
        head = kept;
    }
    // The smallest kept vertex of the cell for which `accept` holds, -1 if there is none.
    template <class Accept>
    Index find(const GridCell& cell, const Accept& accept) const {
        Index found = -1;
        for (Index k = first_[slot(cell)]; k >= 0; k = next_[static_cast<std::size_t>(k)])
            if (cell_[static_cast<std::size_t>(k)] == cell && accept(k)) found = k;  // chains run downward
        return found;
    }

  private:
    std::size_t slot(const GridCell& cell) const {
        std::uint64_t hash = 0;
        for (const std::int64_t part : cell) {
            hash = (hash ^ static_cast<std::uint64_t>(part)) * 0x9e3779b97f4a7c15ULL;
            hash ^= hash >> 32;
        }
        return hash & (first_.size() - 1);
    }

    std::vector<Index> first_, next_;
    std::vector<GridCell> cell_;
};

// Exact welding: a cell per position. Adding zero makes -0 and 0 one.
GridCell exact_cell(const Eigen::RowVector3d& p) {
    GridCell cell;
    for (int k = 0; k < 3; ++k) cell[static_cast<std::size_t>(k)] = std::bit_cast<std::int64_t>(p[k] + 0.0);
    return cell;
}

GridCell grid_cell(const Eigen::RowVector3d& p, double width) {
    GridCell cell;
    for (int k = 0; k < 3; ++k)
        cell[static_cast<std::size_t>(k)] = static_cast<std::int64_t>(std::floor(p[k] / width));
    return cell;
}

template <class Accept>
Index find_around(const CellTable& table, const GridCell& center, const Accept& accept) {
    Index found = -1;
    for (std::int64_t x = -1; x <= 1; ++x) {
        for (std::int64_t y = -1; y <= 1; ++y) {
            for (std::int64_t z = -1; z <= 1; ++z) {
                const Index kept = table.find({center[0] + x, center[1] + y, center[2] + z}, accept);
                if (kept >= 0 && (found < 0 || kept < found)) found = kept;
            }
        }
    }
    return found;
}

}  // namespace

WeldResult weld(MeshView mesh, const WeldOptions& options) {
    require_valid(mesh);
    if (!(options.distance >= 0) || !std::isfinite(options.distance))
        throw InvalidInput(fmt::format("weld: the distance must be at least 0, not {}", options.distance));
    const bool exact = options.distance == 0;
    if (!exact && mesh.vertices.cwiseAbs().maxCoeff() / options.distance > 1e15)
        throw InvalidInput(
            fmt::format("weld: distance {} is below the resolution of the coordinates", options.distance));

    WeldResult result;
    result.welded_from_original.resize(static_cast<std::size_t>(mesh.n_vertices()));
    result.mesh.vertices.resize(mesh.n_vertices(), 3);
    Index n_kept = 0;
    CellTable table(static_cast<std::size_t>(mesh.n_vertices()));
    const double limit = options.distance * options.distance;
    for (Index v = 0; v < mesh.n_vertices(); ++v) {
        const Eigen::RowVector3d p = mesh.vertices.row(v);
        const auto close = [&](Index k) { return (result.mesh.vertices.row(k) - p).squaredNorm() <= limit; };
        const GridCell cell = exact ? exact_cell(p) : grid_cell(p, options.distance);
        Index kept = exact ? table.find(cell, [](Index) { return true; }) : find_around(table, cell, close);
        if (kept < 0) {
            kept = n_kept++;
            result.mesh.vertices.row(kept) = p;
            table.insert(cell, kept);
        }
        result.welded_from_original[static_cast<std::size_t>(v)] = kept;
    }
    result.mesh.vertices.conservativeResize(n_kept, 3);
    result.mesh.triangles = mesh.triangles.unaryExpr(
        [&](Index v) { return result.welded_from_original[static_cast<std::size_t>(v)]; });
    if (mesh.polygons != nullptr) result.mesh.polygons = *mesh.polygons;
    return result;
}

}  // namespace counterpart
