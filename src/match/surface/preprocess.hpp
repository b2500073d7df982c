// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// The part of a mesh that is matched, cleaned up; every other vertex follows its nearest one.
#pragma once

#include <counterpart/map/vertex_map.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

#include <string>
#include <vector>

namespace counterpart::surface_match {

struct Preprocessed {
    TriangleMesh mesh;  // duplicate vertices merged, consistently oriented, outward
    /// Per input vertex; for those left out, the matched vertex nearest in space.
    std::vector<Index> matched_of_input;
    std::vector<Index> input_of_matched;
    std::vector<Index> left_out;      // input vertices that only follow, increasing
    Index n_merged = 0;               // vertices that coincide with another one
    Index n_unreferenced = 0;         // vertices in no triangle
    Index n_duplicate_triangles = 0;  // left out
    Index n_components = 1;           // of the matched part
    Index n_small_components = 0;     // left out
    double small_share = 0;           // of the area, left out
    Index n_boundary_loops = 0, n_nonmanifold_edges = 0;
    Index n_disagreeing = 0, n_one_sided = 0;  // see OrientResult
    bool was_inside_out = false;
};

/// Merges coincident vertices; leaves out vertices in no triangle, degenerate and duplicate triangles, and
/// components of less than
/// `min_component_share` of the largest one's area; orients what is left. O((V + F) log F).
Preprocessed preprocess(MeshView mesh, double min_component_share = 0.1);

/// What a method needs of a mesh, and what it calls the mesh where it does not get it.
struct Needed {
    std::string method;
    Index min_vertices = 0;
    std::string name = "mesh";
    double min_component_share = 0.1;
};

/// `preprocess`, of a mesh that has what is needed. Throws UnsuitableMesh without area, for one too large to
/// measure, or for fewer distinct vertices.
Preprocessed preprocess(MeshView mesh, const Needed& needed);

/// Stands for "in another component" where an infinite distance would spoil sums; far beyond any real one at
/// unit area.
constexpr float unreachable = 10;

/// A map between matched parts as one between the inputs.
VertexMap between_inputs(const VertexMap& map, const Preprocessed& source, const Preprocessed& target);

}  // namespace counterpart::surface_match
