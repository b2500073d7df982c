// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/match/match.hpp>
#include <counterpart/mesh/tetrahedral_mesh.hpp>

#include <optional>
#include <string>
#include <vector>

namespace counterpart {

struct VolumeOptions {
    /// automatic, exact, frontiers or spectral. Automatic is exact where that can answer, else spectral.
    MatchMethod method = MatchMethod::automatic;
    /// Exact: accept a mirror image where nothing else fits.
    bool allow_mirror = false;
    FrontiersOptions frontiers{};
    SpectralOptions spectral{};
    SpectralShapeOptions spectral_shape{};
    int n_threads = 0;    ///< 0 = all; the result does not depend on it
    Progress progress{};  ///< see base/progress.hpp
};

struct VolumeResult {
    VertexMap target_from_source;                 ///< of all vertices, also those inside
    MatchMethod method = MatchMethod::automatic;  ///< the one that found the map
    Vector confidence;  ///< per source vertex, in [0, 1]: of exact 1, of frontiers and spectral their own;
                        ///< inside the solid spectral continues that of its surface
    bool identical = false;         ///< exact: the tetrahedra have the same connectivity
    std::string difference;         ///< exact, where they have not: the first difference found, as a sentence
    bool mirrored = false;          ///< exact: the target is a mirror image
    Index n_components = 0;         ///< exact: connected through faces
    Count automorphisms;            ///< exact: of the source, orientation-preserving, with the identity
    std::vector<Message> messages;  ///< what was noticed and what may be wrong
    std::vector<StageTime> stages;
    std::optional<FrontiersResult> frontiers{};
    std::optional<SpectralResult> spectral{};  ///< of the two surfaces
};

/// Which target vertex is each source vertex, of two solids of tetrahedra?
///
/// Exact: the isomorphism, as match_exact finds it for surfaces. On a component, what is connected through
/// faces, it is fixed by the image of one tetrahedron, of the rarest color, and checked by walking from face
/// to face in both. Symmetry is left to geometry: edge lengths, then the distance after the best similarity,
/// then as the solids lie. About O(T).
///
/// Frontiers: match_frontiers with all faces of the tetrahedra (all_faces), the edges as neighbors.
///
/// Spectral, for other tetrahedralizations of alike solids: match_spectral maps the surfaces. Inside,
/// positions are harmonic (linear elements, cotangent weights), so the mean of those around, and the closest
/// vertex is taken. O(V^1.5).
///
/// Throws InvalidInput for invalid meshes or options, frontiers also where the connectivity differs, and for
/// what is known of the map (landmarks, excluded, ...) unless the method is spectral; Canceled. For exact
/// different connectivity is a result: see `identical`.
VolumeResult match_volume(const TetrahedralMesh& source, const TetrahedralMesh& target,
                          const VolumeOptions& options = {});

}  // namespace counterpart
