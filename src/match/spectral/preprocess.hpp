// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// The part of a mesh that is matched, cleaned up; every other vertex follows its nearest one.
#pragma once

#include "match/spectral/tuning.hpp"

#include <counterpart/map/vertex_map.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

#include <vector>

namespace counterpart::spectral_match {

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
/// small components; orients what is left. O((V + F) log F).
Preprocessed preprocess(MeshView mesh, const PreparationTuning& tuning = {});

/// A map between matched parts as one between the inputs.
VertexMap between_inputs(const VertexMap& map, const Preprocessed& source, const Preprocessed& target);

}  // namespace counterpart::spectral_match
