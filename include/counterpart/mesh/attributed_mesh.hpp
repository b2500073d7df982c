// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/mesh/triangle_mesh.hpp>

#include <memory>
#include <string>
#include <vector>

namespace counterpart {

/// Values that a surface carries per corner of its triangles: texture coordinates, colours. Corners that
/// share a row are smooth there; where two triangles at one vertex use different rows there is a seam.
struct CornerAttribute {
    Matrix values;      ///< one row per distinct value
    Triangles corners;  ///< n_triangles x 3: the row of each corner, -1 where the triangle has none
};

/// What moves each vertex: numbers of joints, counted from 0 in the skin's list, and their weights.
struct SkinBinding {
    Eigen::Matrix<Index, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> joints;  ///< n_vertices x K
    Matrix weights;  ///< n_vertices x K; each row sums to 1, or is all 0 for a vertex without a joint
};

/// A blend shape: where each vertex goes at weight 1.
struct MorphTarget {
    std::string name;
    Points displacements;  ///< n_vertices x 3, in the mesh's units
};

/// A file as it was read; known to the module io only.
struct GltfDocument;

/// A mesh with what artists attach to it. Empty parts are absent.
struct AttributedMesh {
    TriangleMesh mesh;
    CornerAttribute normals;                           ///< n x 3 values
    std::vector<CornerAttribute> texture_coordinates;  ///< n x 2 values each, (0, 0) at the image's top left
    std::vector<CornerAttribute> colors;               ///< n x 3 or n x 4 values in 0 .. 1 each
    SkinBinding skin;
    std::vector<MorphTarget> morphs;
    /// For each triangle what it is made of: the number of one of the document's primitives, which have their
    /// materials; without a document any label from 0. Empty: all alike.
    std::vector<Index> parts;
    /// The material of each part, by name; empty: unnamed.
    std::vector<std::string> part_names;
    /// The glTF file that the mesh is from: whatever else it holds (materials, textures, the skeleton, other
    /// nodes, animations) is written along, so who takes skin or parts from another mesh takes this too. Null
    /// for meshes from elsewhere.
    std::shared_ptr<const GltfDocument> document;
};

}  // namespace counterpart
