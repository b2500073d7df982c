// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/mesh/attributed_mesh.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

#include <cstdint>
#include <vector>

namespace counterpart {

struct ShuffleResult {
    TriangleMesh mesh;
    std::vector<Index> shuffled_from_original;  ///< the true map: new index of each old vertex
    Triangles original_corner_from_shuffled;    ///< for each new corner the old one, 3 * triangle + corner
};

/// The same surface with its vertices, triangles, and the first corner of each triangle in random order.
/// Preserves orientation. A mesh of polygons gets these in random order and from other first corners on, and
/// so mostly cut along other diagonals. O(V + F).
ShuffleResult shuffle(MeshView mesh, std::uint64_t seed);

struct AttributedShuffleResult {
    AttributedMesh content;
    std::vector<Index> shuffled_from_original;  ///< of the vertices
};

/// The same with attributes, whose rows are shuffled too. O(n).
AttributedShuffleResult shuffle(const AttributedMesh& content, std::uint64_t seed);

/// Applies a random rotation, a scale in [0.5, 2] and a translation by up to three mesh units along each
/// axis. No reflection. O(V).
TriangleMesh move_at_random(MeshView mesh, std::uint64_t seed);

/// The mesh's longest, middle and shortest axes are the principal axes of its surface.
struct DeformOptions {
    double bend = 0;   ///< radians between the two ends of the longest axis, bent toward the shortest;
                       ///< -2 pi .. 2 pi
    double twist = 0;  ///< radians between the two ends, about the longest axis; -2 pi .. 2 pi
    double warp = 0;   ///< size of a smooth random displacement, as a fraction of the mesh's length; 0 .. 0.5
    std::uint64_t seed = 1;  ///< of the displacement
};

/// The same mesh in another pose: twisted, bent, then warped. Keeps vertices and triangles in order. Bending
/// and twisting preserve lengths near the central axis and change them by a fraction of about angle *
/// distance from the axis / length away from it. O(V). Throws InvalidInput for an invalid mesh or options out
/// of range.
TriangleMesh deform(MeshView mesh, const DeformOptions& options);

struct RetriangulateOptions {
    double kept_share = 0.7;  ///< of the vertices, 0.05 .. 1: the others are collapsed into a neighbor
    double flip_share = 0.5;  ///< of the triangles that then exchange a diagonal with a neighbor, 0 .. 1
    std::uint64_t seed = 1;   ///< of both choices
};

struct RetriangulateResult {
    TriangleMesh mesh;
    std::vector<Index> original_from_mesh;  ///< the true map: the vertices keep their places and order
};

/// Nearly the same surface in other triangles, so that connectivity says nothing of where a vertex came from:
/// random vertices are collapsed into a neighbor, then random edges flipped. No triangle turns over or gets
/// much thinner than those that it replaces, the topology stays, boundary and non-manifold vertices stay, and
/// so does what touches a vertex of more than 100 triangles. So fewer vertices may go, and fewer edges be
/// flipped, than asked for. Vertices in no triangle do not count, and go. Polygons are not kept. O(V log V).
/// Throws InvalidInput for an invalid mesh or options out of range.
RetriangulateResult retriangulate(MeshView mesh, const RetriangulateOptions& options = {});

struct FusedMesh {
    TriangleMesh mesh;
    std::vector<Index> fused_from_original;  ///< the true map; -1 where surfaces touch and vanished inside
};

/// What a scanner makes of limbs that touch: one surface around all that is inside, in other triangles.
/// Cubes of edge length `cell` (mesh units) are filled where their center is inside; gaps of a cell or
/// narrower are closed. Their faces, smoothed and drawn to the surface, are the mesh: manifold and closed,
/// with edges of about one cell. Parts thinner than a cell may be lost or come off. O(F log F + cells).
/// Throws InvalidInput for an invalid mesh, a cell that is not positive, or more than 2^27 cells, and
/// UnsuitableMesh for a mesh that is not closed or has no cell inside.
FusedMesh fuse(MeshView mesh, double cell);

struct PartOfMesh {
    TriangleMesh mesh;
    std::vector<Index> whole_from_part;  ///< the true map
};

/// The triangles that are marked, one mark each, and the vertices that they use, in order. Polygons are not
/// kept. O(V + F). Throws InvalidInput for an invalid mesh or another number of marks.
PartOfMesh part_of(MeshView mesh, const std::vector<char>& is_kept);

/// The triangles whose three corners lie on the side of a plane that its normal points to: normal . x >
/// offset. O(V + F). Throws InvalidInput for an invalid mesh, or a normal or offset that is not finite.
PartOfMesh cut_by_plane(MeshView mesh, const Eigen::RowVector3d& normal, double offset);

/// Without the triangles that come within `radius`, in a straight line, of `count` vertices drawn at random.
/// O(count * V). Throws InvalidInput for an invalid mesh, a negative count or radius.
PartOfMesh cut_holes(MeshView mesh, int count, double radius, std::uint64_t seed);

}  // namespace counterpart
