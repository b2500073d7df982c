// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// The part of a mesh that is matched, cleaned; everything else follows it.
#pragma once

#include <counterpart/map/vertex_map.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

#include <vector>

namespace counterpart::spectral_match {

struct Core {
    TriangleMesh mesh;  // coincident vertices joined, wound consistently and outwards
    std::vector<Index>
        core_of_input;  // per input vertex; for those left out, the core vertex nearest in space
    std::vector<Index> input_of_core;
    std::vector<Index> left_out;   // input vertices that only follow, increasing
    Index n_joined = 0;            // vertices at the place of another one
    Index n_unreferenced = 0;      // vertices in no triangle
    Index n_repeated = 0;          // triangles with the corners of another, left out
    Index n_components = 1;        // of the core
    Index n_small_components = 0;  // left out
    double small_share = 0;        // of the area, left out
    Index n_boundary_loops = 0, n_nonmanifold_edges = 0;
    Index n_disagreeing = 0, n_one_sided = 0;  // see OrientResult
    bool was_inside_out = false;
};

/// Vertices at one place become one; vertices in no triangle, triangles with the same corners as one before
/// and components of less than a tenth of the largest one's area are left out. O((V + F) log F).
Core core_of(const TriangleMesh& mesh);

/// A map between cores as one between the inputs.
VertexMap between_inputs(const VertexMap& map, const Core& source, const Core& target);

}  // namespace counterpart::spectral_match
