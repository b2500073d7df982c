// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/message.hpp>
#include <counterpart/base/progress.hpp>
#include <counterpart/map/vertex_map.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace counterpart {

struct ExactOptions {
    /// Let geometry also choose among orientation-reversing matches. They are used without this where nothing
    /// else fits (the target's winding is reversed).
    bool allow_mirror = false;
    /// First weld vertices of each mesh that are no further apart than this, in mesh units. Negative: weld
    /// only where more than half of the vertices of a mesh lie at the places of others, as its faces are
    /// separate, and then with 0. Every duplicate gets a partner of its own where the corners tell.
    double weld_distance = -1;
    /// How many of the other matches that a symmetric mesh has to return, best first; at least 0.
    Index max_alternatives = 0;
    int n_threads = 0;    ///< 0: all that the machine has. The result does not depend on it
    Progress progress{};  ///< called between steps; may stop the match
};

/// A number of matches.
struct Count {
    double log10 = 0;                     ///< of the number; -infinity for none
    std::optional<std::uint64_t> number;  ///< absent from 10^13 on
    bool is_lower_bound = false;          ///< the search was cut short: there may be more
};
/// "12", "about 10^35659", "at least 4096".
std::string to_string(const Count& count);

/// Components of the source with the same connectivity: only geometry tells which is which.
struct EqualComponents {
    Index n_triangles = 0;  ///< of each component
    std::vector<Index> source,
        target;  ///< smallest vertex of each component; target[i] is source[i]'s partner
};

/// How the connectivity was taken apart.
enum class ExactPath {
    surface,  ///< every edge has one or two triangles: components are matched one by one
    patches,  ///< cut open along non-manifold edges or vertices; patches are matched so that what they share
              ///< agrees
};

struct ExactResult {
    /// The two meshes have the same connectivity: only then is anything below meaningful.
    bool identical = false;
    /// Where not identical: the first difference found, as a sentence.
    std::string difference;

    VertexMap target_from_source;
    /// For every triangle and corner of the source, 3 * triangle + corner of the target.
    Triangles target_corner_from_source;

    ExactPath path = ExactPath::surface;
    Index n_components = 0;  ///< connected through manifold edges
    std::vector<EqualComponents> interchangeable;
    /// Source vertices of parts alike in themselves or to each other, whose images place alone tells, as edge
    /// lengths fit another way about as well. Increasing; not told where `path` is patches.
    std::vector<Index> by_place;
    /// Of the source's triangles, the share whose components lengths and curvature confirm to be partners:
    /// all where the connectivity has no symmetry. Below a half, regular triangulations (grids, wraps of a
    /// template) may have their connectivity in common by accident. Not told where `path` is patches.
    double confirmed_share = 0;
    Count automorphisms;            ///< of the source, orientation-preserving, with the identity
    Count mirror_automorphisms;     ///< of the source, orientation-reversing
    Index reversed_triangles = 0;   ///< in opposite winding in the target
    Index recut_polygons = 0;       ///< or quads found, cut into other triangles in the target
    bool winding_reversed = false;  ///< all of them: the target's winding is reversed as a whole
    /// The target is a mirror image of the source: by the volumes of closed surfaces, or because such a match
    /// was chosen, which only allow_mirror permits.
    bool mirrored = false;
    std::vector<VertexMap> alternatives;  ///< the same for other automorphisms, best first

    std::vector<Message> messages;  ///< all of the above that a person should know
};

/// Matches meshes with the same connectivity whatever their numbering, winding, pose, genus, borders and
/// number of components. On a component an isomorphism is fixed by the image of one half-edge, chosen of the
/// rarest color (Weisfeiler-Leman), and checked by a simultaneous traversal. Where symmetry or equal
/// components leave a choice, edge lengths make it first, then distance after the best similarity. Isolated
/// vertices are paired by position. O(V + F) unless most traversals fail late. Throws InvalidInput for
/// invalid meshes or options, Canceled, and NumericalError where patches of a non-manifold mesh fit in more
/// ways than can be searched.
///
/// Meshes of constant z, one at z = 0, are drawings: mirror images are told apart, whatever their winding.
///
/// Where both meshes have polygons these are compared: at which corner a polygon begins and how it was cut
/// into triangles does not matter. Where polygons differ, or only one mesh has some, triangles are compared;
/// and where these differ, those edges may be diagonals of quads that the two meshes cut differently which
/// lie inside polygons, or, where no mesh has any, inside convex quads bent by less than 60 degrees. Meshes
/// without polygons that differ in less than most of their neighborhoods count as edited, not as cut
/// differently. `recut_polygons` says how many quads differ.
ExactResult match_exact(MeshView source, MeshView target, const ExactOptions& options = {});

}  // namespace counterpart
