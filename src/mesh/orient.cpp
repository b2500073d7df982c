// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "mesh/disjoint_sets.hpp"
#include "mesh/edge_table.hpp"

#include <counterpart/mesh/measure.hpp>
#include <counterpart/mesh/orient.hpp>

#include <cmath>
#include <vector>

#include <Eigen/Geometry>

namespace counterpart {
namespace {

struct Piece {
    Index n_even = 0, n_odd = 0;  // triangles wound like the piece's first, and against it
    bool open = false, one_sided = false;
    double volume = 0, area = 0;
};

void turn(TriangleMesh& mesh, Index t) { std::swap(mesh.triangles(t, 1), mesh.triangles(t, 2)); }

std::vector<Piece> agree_within_pieces(TriangleMesh& mesh, std::vector<Index>& piece_of_triangle) {
    DisjointSets sets(mesh.n_triangles());
    std::vector<Piece> pieces(static_cast<std::size_t>(mesh.n_triangles()));  // by smallest triangle
    const EdgeTable edges(mesh);
    std::vector<Index> open, contradicted;
    for (Index e = 0; e < edges.n_edges(); ++e) {
        const auto sides = edges.sides(e);
        if (sides.size() != 2) {
            for (const EdgeTable::Side& side : sides) open.push_back(side.triangle);
        } else if (!sets.join(sides[0].triangle, sides[1].triangle, sides[0].forward == sides[1].forward)) {
            contradicted.push_back(sides[0].triangle);
        }
    }
    const auto piece = [&](Index t) -> Piece& { return pieces[static_cast<std::size_t>(sets.root(t))]; };
    for (const Index t : open) piece(t).open = true;
    for (const Index t : contradicted) piece(t).one_sided = true;
    for (Index t = 0; t < mesh.n_triangles(); ++t) ++(sets.is_odd(t) ? piece(t).n_odd : piece(t).n_even);
    for (Index t = 0; t < mesh.n_triangles(); ++t) {
        const bool odd_is_less = piece(t).n_odd <= piece(t).n_even;
        if (sets.is_odd(t) == odd_is_less) turn(mesh, t);
        piece_of_triangle.push_back(sets.root(t));
    }
    return pieces;
}

}  // namespace

OrientResult orient(const TriangleMesh& mesh) {
    require_valid(mesh);
    OrientResult result{mesh};
    std::vector<Index> piece_of_triangle;
    std::vector<Piece> pieces = agree_within_pieces(result.mesh, piece_of_triangle);
    const Eigen::RowVector3d center = surface_centroid(mesh).transpose();
    const Vector areas = triangle_areas(mesh);
    double open_volume = 0;
    for (Index t = 0; t < mesh.n_triangles(); ++t) {
        Piece& piece = pieces[static_cast<std::size_t>(piece_of_triangle[static_cast<std::size_t>(t)])];
        const auto corner = [&](int c) {
            return Eigen::RowVector3d(result.mesh.vertices.row(result.mesh.triangles(t, c)) - center);
        };
        const double volume = corner(0).dot(corner(1).cross(corner(2))) / 6;
        piece.volume += volume;
        piece.area += areas[t];
        if (piece.open || piece.one_sided) open_volume += volume;
    }
    // Rounding leaves a flat mesh a volume of either sign.
    const double noise = 1e-12 * std::pow(areas.sum(), 1.5);
    double turned_area = 0;
    for (Piece& piece : pieces) {
        if (piece.one_sided) ++result.n_one_sided;
        if (!piece.one_sided) result.n_disagreeing += std::min(piece.n_even, piece.n_odd);
        if (piece.open || piece.one_sided) piece.volume = open_volume;
        if (piece.volume < -noise) turned_area += piece.area;
    }
    for (Index t = 0; t < mesh.n_triangles(); ++t)
        if (pieces[static_cast<std::size_t>(piece_of_triangle[static_cast<std::size_t>(t)])].volume < -noise)
            turn(result.mesh, t);
    result.was_inside_out = turned_area > areas.sum() / 2;
    return result;
}

}  // namespace counterpart
