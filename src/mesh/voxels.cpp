// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "mesh/voxels.hpp"

#include <counterpart/base/errors.hpp>

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

#include <fmt/format.h>

namespace counterpart::mesh {
namespace {

// Where the line through the centers of a column meets the surface, and +1 where it leaves it.
struct Crossing {
    double z;
    int sign;
};

class Columns {
  public:
    explicit Columns(const Voxels& voxels)
        : voxels_(voxels),
          crossings_(static_cast<std::size_t>(voxels.counts()[0]) *
                     static_cast<std::size_t>(voxels.counts()[1])) {}

    std::vector<Crossing>& at(Index x, Index y) {
        return crossings_[static_cast<std::size_t>(y) * static_cast<std::size_t>(voxels_.counts()[0]) +
                          static_cast<std::size_t>(x)];
    }

    void add(const Eigen::RowVector3d& a, const Eigen::RowVector3d& b, const Eigen::RowVector3d& c) {
        const Eigen::RowVector3d origin = voxels_.center({0, 0, 0}),
                                 step = voxels_.center({1, 1, 1}) - origin;
        const auto first = [&](int k) {
            const double least = std::min({a[k], b[k], c[k]});
            return static_cast<Index>(std::floor((least - origin[k]) / step[k]));
        };
        const auto last = [&](int k) {
            const double most = std::max({a[k], b[k], c[k]});
            return static_cast<Index>(std::ceil((most - origin[k]) / step[k]));
        };
        for (Index y = first(1); y <= last(1); ++y)
            for (Index x = first(0); x <= last(0); ++x) cross(a, b, c, x, y);
    }

  private:
    // Twice the area of (a, b, point) seen from above. On an edge the same triangle of the two always wins,
    // since both see it with the same ends in the same order: a tie counts for the upper or the left one.
    static bool is_left(const Eigen::RowVector3d& a, const Eigen::RowVector3d& b, const Eigen::RowVector3d& p,
                        double& area) {
        const bool swapped = std::pair(b[0], b[1]) < std::pair(a[0], a[1]);
        const Eigen::RowVector3d &s = swapped ? b : a, &t = swapped ? a : b;
        area = (t[0] - s[0]) * (p[1] - s[1]) - (t[1] - s[1]) * (p[0] - s[0]);
        const bool left = area >= 0;
        if (swapped) area = -area;
        return left != swapped;
    }

    void cross(const Eigen::RowVector3d& a, const Eigen::RowVector3d& b, const Eigen::RowVector3d& c, Index x,
               Index y) {
        const Eigen::RowVector3d p = voxels_.center({x, y, 0});
        double ab = 0, bc = 0, ca = 0;
        const bool left = is_left(a, b, p, ab);
        if (is_left(b, c, p, bc) != left || is_left(c, a, p, ca) != left) return;
        const double sum = ab + bc + ca;
        if (sum == 0) return;
        at(x, y).push_back({(bc * a[2] + ca * b[2] + ab * c[2]) / sum, left ? 1 : -1});
    }

    const Voxels& voxels_;
    std::vector<std::vector<Crossing>> crossings_;
};

}  // namespace

Voxels::Voxels(const Eigen::RowVector3d& low, double size, const Cell& counts)
    : low_(low), size_(size), counts_(counts), filled_(index({0, 0, counts[2]}), 0) {}

void Voxels::close_gaps() {
    const std::array<std::size_t, 3> step{index({1, 0, 0}), index({0, 1, 0}), index({0, 0, 1})};
    const auto spread = [&](char value) {  // to the six cells beside each
        const std::vector<char> before = filled_;
        for (std::size_t i = step[2]; i + step[2] < filled_.size(); ++i)
            for (const std::size_t s : step)
                if (before[i - s] == value || before[i + s] == value) filled_[i] = value;
    };
    spread(1);
    spread(0);
}

// The cells that fill of the 2 x 2 x 2 from `c` on must hang together by faces, and so must the empty ones.
bool Voxels::mend_block(const Cell& c) {
    const auto corner = [&](int i) { return Cell{c[0] + (i & 1), c[1] + (i >> 1 & 1), c[2] + (i >> 2 & 1)}; };
    unsigned mask = 0;
    for (int i = 0; i < 8; ++i) mask |= at(corner(i)) ? 1U << static_cast<unsigned>(i) : 0U;
    if (mask == 0 || mask == 255) return false;
    const auto filled = [&](int i) { return (mask >> static_cast<unsigned>(i) & 1U) != 0; };
    for (int i = 0; i < 8; ++i)
        for (int j = i + 1; j < 8; ++j) {
            const int apart = i ^ j;
            if (filled(i) != filled(j) || apart == 1 || apart == 2 || apart == 4) continue;
            if (apart != 7) {  // across a face of the block
                const int low_bit = apart & -apart, p = i ^ low_bit, q = j ^ low_bit;
                if (filled(p) == filled(i) || filled(q) == filled(i)) continue;
                fill(filled(i) ? corner(p) : corner(i));
                return true;
            }
            bool connected = false;  // through the block: three steps along axes
            for (const int first : {1, 2, 4})
                for (const int second : {1, 2, 4})
                    connected |= first != second && filled(i ^ first) == filled(i) &&
                                 filled(i ^ first ^ second) == filled(i);
            if (connected) continue;
            fill(filled(i) ? corner(i ^ 1) : corner(i));
            return true;
        }
    return false;
}

void Voxels::make_manifold() {
    for (bool changed = true; changed;) {
        changed = false;
        for (Index z = 0; z + 1 < counts_[2]; ++z)
            for (Index y = 0; y + 1 < counts_[1]; ++y)
                for (Index x = 0; x + 1 < counts_[0]; ++x) changed |= mend_block({x, y, z});
    }
}

TriangleMesh Voxels::surface() const {
    std::unordered_map<std::size_t, Index> number;
    std::vector<Eigen::RowVector3d> points;
    std::vector<std::array<Index, 3>> triangles;
    const auto vertex = [&](const Cell& c) {  // the lowest corner of a cell
        const auto [found, is_new] = number.try_emplace(index(c), static_cast<Index>(points.size()));
        if (is_new) points.push_back(center(c).array() - 0.5 * size_);
        return found->second;
    };
    const auto add_face = [&](Cell c, int axis, bool is_upper) {
        const int u = (axis + 1) % 3, w = (axis + 2) % 3;
        if (is_upper) ++c[static_cast<std::size_t>(axis)];
        std::array<Index, 4> ring{};
        for (int k = 0; k < 4; ++k) {
            Cell corner = c;
            corner[static_cast<std::size_t>(u)] += k == 1 || k == 2 ? 1 : 0;
            corner[static_cast<std::size_t>(w)] += k >= 2 ? 1 : 0;
            ring[static_cast<std::size_t>(is_upper ? k : 3 - k)] = vertex(corner);
        }
        triangles.push_back({ring[0], ring[1], ring[2]});
        triangles.push_back({ring[0], ring[2], ring[3]});
    };
    for (Index z = 1; z + 1 < counts_[2]; ++z)
        for (Index y = 1; y + 1 < counts_[1]; ++y)
            for (Index x = 1; x + 1 < counts_[0]; ++x) {
                const Cell c{x, y, z};
                if (!at(c)) continue;
                for (int axis = 0; axis < 3; ++axis)
                    for (const int side : {-1, 1}) {
                        Cell beside = c;
                        beside[static_cast<std::size_t>(axis)] += side;
                        if (!at(beside)) add_face(c, axis, side == 1);
                    }
            }
    TriangleMesh mesh;
    mesh.vertices.resize(static_cast<Eigen::Index>(points.size()), 3);
    for (std::size_t v = 0; v < points.size(); ++v)
        mesh.vertices.row(static_cast<Eigen::Index>(v)) = points[v];
    mesh.triangles.resize(static_cast<Eigen::Index>(triangles.size()), 3);
    for (std::size_t t = 0; t < triangles.size(); ++t)
        for (int k = 0; k < 3; ++k)
            mesh.triangles(static_cast<Eigen::Index>(t), k) = triangles[t][static_cast<std::size_t>(k)];
    return mesh;
}

Voxels voxels_inside(MeshView mesh, double size) {
    constexpr double margin = 3, max_cells = 1 << 27;
    Eigen::RowVector3d low = Eigen::RowVector3d::Zero(), extent = low;
    if (mesh.n_vertices() > 0) {
        low = mesh.vertices.colwise().minCoeff();
        extent = mesh.vertices.colwise().maxCoeff() - low;
    }
    const Eigen::Array3d n = (extent.array() / size).ceil() + 2 * margin;
    if (!(n.prod() <= max_cells))
        throw InvalidInput(
            fmt::format("cells of size {} are too small: the mesh would have {:.2g} of them, and {:.2g} are "
                        "allowed",
                        size, n.prod(), max_cells));
    Voxels voxels(low.array() - margin * size, size,
                  {static_cast<Index>(n[0]), static_cast<Index>(n[1]), static_cast<Index>(n[2])});
    Columns columns(voxels);
    for (Index t = 0; t < mesh.n_triangles(); ++t)
        columns.add(mesh.vertices.row(mesh.triangles(t, 0)), mesh.vertices.row(mesh.triangles(t, 1)),
                    mesh.vertices.row(mesh.triangles(t, 2)));
    for (Index y = 0; y < voxels.counts()[1]; ++y)
        for (Index x = 0; x < voxels.counts()[0]; ++x) {
            std::vector<Crossing>& all = columns.at(x, y);
            std::sort(all.begin(), all.end(), [](const Crossing& a, const Crossing& b) {
                return std::pair(a.z, a.sign) < std::pair(b.z, b.sign);
            });
            int winding = 0;
            std::size_t k = 0;
            for (Index z = 0; z < voxels.counts()[2]; ++z) {
                for (; k < all.size() && all[k].z < voxels.center({x, y, z})[2]; ++k) winding += all[k].sign;
                if (winding != 0) voxels.fill({x, y, z});
            }
        }
    return voxels;
}

}  // namespace counterpart::mesh
