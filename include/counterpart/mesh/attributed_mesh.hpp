// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/mesh/triangle_mesh.hpp>

#include <memory>
#include <string>
#include <vector>

namespace counterpart {

/// Values per corner of a mesh's triangles: texture coordinates, colors. Corners at a vertex that share a row
/// are continuous there; where two triangles at one vertex use different rows there is a seam.
struct CornerAttribute {
    Matrix values;      ///< one row per distinct value
    Triangles corners;  ///< n_triangles x 3: the row of each corner, -1 where the triangle has none
};

/// The joints that move each vertex, as 0-based indices into the skin's list, and their weights.
struct SkinBinding {
    Eigen::Matrix<Index, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> joints;  ///< n_vertices x K
    Matrix weights;  ///< n_vertices x K; each row sums to 1, or is all 0 for a vertex without a joint
};

/// A blend shape: the displacement of each vertex at weight 1.
struct MorphTarget {
    std::string name;
    Points displacements;  ///< n_vertices x 3, in the mesh's units
};

/// What was measured at each vertex, or its label.
struct VertexValues {
    std::string name;
    Matrix values;  ///< n_vertices x K
};

/// The objects of a file, numbered from 0: what it has under names of their own.
struct MeshObjects {
    std::vector<std::string> names;  ///< of each object; may be empty, and that of another too
    std::vector<Index> of_triangle;  ///< for each triangle its object
    /// For each vertex the object that the file has it in, -1: none. An object's vertices are those that its
    /// triangles name, and of those that no triangle names the ones that are said here to be in it.
    std::vector<Index> of_vertex;
};

/// What a file holds besides the mesh: materials with their textures, a skeleton, other nodes, animations. A
/// file format that has such content derives its own kind; no other module looks inside.
class Document {
  public:
    virtual ~Document() = default;

    /// The document to be kept, whole; document_from_bytes (io/gltf.hpp) makes it again. Files that it names
    /// beside its own stay where they are.
    virtual std::string to_bytes() const = 0;
    virtual bool has_materials() const = 0;
    virtual std::shared_ptr<const Document> without_materials() const = 0;
    /// Without skins and animations.
    virtual std::shared_ptr<const Document> without_skeleton() const = 0;

    /// A document and, for each triangle, the index of its part in it.
    struct Assignment {
        std::shared_ptr<const Document> document;
        std::vector<Index> parts;
    };
    /// This document with materials of `source`: triangle i, which is in part parts[i] of this one, gets the
    /// material of part source_parts[i] of the source. Textures and images come along; a part that gets
    /// several materials is split. Throws InvalidInput if a part does not exist or the source is of another
    /// format, IoError if an image is missing.
    virtual Assignment with_materials_of(const Document& source, const std::vector<Index>& parts,
                                         const std::vector<Index>& source_parts) const = 0;
};

/// A mesh with its attributes. Empty members are absent.
struct AttributedMesh {
    TriangleMesh mesh;
    CornerAttribute normals;                           ///< n x 3 values
    std::vector<CornerAttribute> texture_coordinates;  ///< n x 2 values each, (0, 0) at the image's top left
    std::vector<CornerAttribute> colors;               ///< n x 3 or n x 4 values in 0 .. 1 each
    SkinBinding skin;
    std::vector<MorphTarget> morphs;
    std::vector<VertexValues> values;
    /// For each triangle its part: the index of one of the document's primitives, which have materials;
    /// without a document, any label from 0. Empty: a single part.
    std::vector<Index> parts;
    /// The material of each part, by name; empty: unnamed.
    std::vector<std::string> part_names;
    /// What else the mesh's file holds. It is also written; code that copies skin or parts from another mesh
    /// must copy it too. Null for files that hold nothing else.
    std::shared_ptr<const Document> document;
    MeshObjects objects{};  ///< no names: the file knows no objects
};

}  // namespace counterpart
