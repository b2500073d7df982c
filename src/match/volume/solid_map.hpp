// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// The connectivity of tetrahedra: which ones share a face, and colors that do not depend on numbering.
#pragma once

#include "base/to_size.hpp"

#include <counterpart/mesh/tetrahedral_mesh.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace counterpart::volume {

using Color = std::uint64_t;

struct SolidMap {
    explicit SolidMap(const TetrahedralMesh& mesh_of_side);

    const TetrahedralMesh& mesh;
    /// Of the face opposite corner c of tetrahedron t, at 4 t + c: the corner 4 t' + c' opposite which the
    /// neighbor has it; -1 at the boundary. Faces with more than two tetrahedra are cut open.
    std::vector<Index> across;
    std::vector<Index> order;  ///< tetrahedra by component
    std::vector<Index>
        component_begin;          ///< component i is order[component_begin[i] .. component_begin[i + 1])
    std::vector<Index> isolated;  ///< vertices without tetrahedra
    std::vector<Color> colors;    ///< of vertices; see refine
    Index boundary_faces = 0, overlapping_faces = 0;

    Index n_components() const { return static_cast<Index>(component_begin.size()) - 1; }
    Index component_size(Index i) const {
        return component_begin[to_size(i) + 1] - component_begin[to_size(i)];
    }
    Index corner(Index t, int c) const { return mesh.tetrahedra(t, c); }
    /// Equal for tetrahedra that an isomorphism can exchange.
    Color color_of(Index t) const;
    /// Rounds of Weisfeiler-Leman refinement: the colors of the tetrahedra around join a vertex's own.
    void refine(int rounds);

  private:
    void find_neighbors();
    void find_components();
};

}  // namespace counterpart::volume
