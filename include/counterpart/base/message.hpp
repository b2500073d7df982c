// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// What a result tells people: sentences for them, codes and severities for programs.
#pragma once

#include <counterpart/base/types.hpp>

#include <string>
#include <vector>

namespace counterpart {

/// What a message means for who wants to use the map.
enum class Severity {
    notice,      ///< good to know
    caution,     ///< look at the map before you use it
    do_not_use,  ///< the map is most likely wrong
};
/// "notice", "caution", "do not use".
std::string to_string(Severity severity);

/// What a message says, for programs. Its sentence may come to be worded otherwise; its code stays.
enum class MessageCode {
    // How a mesh was taken.
    merged_vertices,      ///< vertices at the place of another one
    isolated_vertices,    ///< vertices in no triangle
    duplicate_triangles,  ///< left out
    flipped_triangles,    ///< oriented like those around them
    one_sided,            ///< a part is like a Moebius band
    inside_out,           ///< turned, or the mesh is mirrored
    non_manifold,         ///< edges of more than two triangles, vertices in several patches
    open_surface,         ///< it has a boundary
    several_components,   ///< that nothing connects
    fragments,            ///< too fragmented to be treated as one mesh
    small_components,     ///< left out
    flat,                 ///< its sides cannot be told apart
    sphere_like,          ///< nearly symmetric about every axis
    fused,                ///< parts of it that touch seem to be one surface
    welded,               ///< vertices merged for the match
    recut_polygons,       ///< cut into other triangles in the other mesh
    reversed_triangles,   ///< wound the other way in the other mesh
    // How two meshes differ.
    same_connectivity,
    connectivity_differs,
    connectivity_undecided,
    same_order,          ///< vertex i is vertex i
    same_places,         ///< vertices of the one lie where those of the other lie
    same_layout,         ///< of texture coordinates
    components_differ,   ///< in number
    openness_differs,    ///< one is open, the other closed
    scale_differs,       ///< in size, or in units of length
    axes_differ,         ///< another axis points up
    mirror_image,        ///< one is the mirror image of the other
    handedness_unknown,  ///< whether one is a mirror image does not show
    self_similar,        ///< a shape is alike in itself
    unlike_shapes,       ///< nothing fits
    weldable,            ///< they have the same connectivity once vertices at one place are merged
    // How sure a map is.
    symmetric_connectivity,      ///< several isomorphisms; geometry chose
    mirrored_connectivity,       ///< isomorphisms that reverse orientation
    interchangeable_components,  ///< paired by position
    alike_parts,                 ///< only place tells how they lie
    poor_score,                  ///< no map fits well
    close_runner_up,             ///< another map fits nearly as well
    misfit,                      ///< parts that should meet do not
    layout_overlaps,             ///< several places have the same texture coordinates
    unsure,                      ///< little confidence on the whole
    no_partners,                 ///< nothing is matched
    few_partners,                ///< less than half is matched
    filled_vertices,             ///< those without a partner follow what surrounds them
    doubtful_vertices,           ///< vertices of little confidence
    no_confidence,               ///< the method does not tell how sure it is
    by_position,                 ///< only place speaks for the map
    refined,                     ///< from a map that was given
    // How a request was met.
    against_request,    ///< the map goes against what was said of it
    option_not_used,    ///< by the method that was chosen
    shaded_flat,        ///< normals that say no more than the triangles do are left out
    skeleton_stays,     ///< though the mesh is carried away from it
    turned_inside_out,  ///< so that the outside of a mirrored mesh stays out
};
/// Its name: "merged_vertices", ...
std::string to_string(MessageCode code);

/// What a message is about.
enum class Subject { map, source, target };
/// "map", "source", "target".
std::string to_string(Subject subject);

/// The mesh that a message is about, or the map, and the vertices of it, from 0; of the map, source vertices.
/// Without vertices it is about the whole, or they are not known.
struct Where {
    Subject subject = Subject::map;
    std::vector<Index> vertices{};
};

struct Message {
    MessageCode code = MessageCode::unsure;
    Severity severity = Severity::notice;
    std::string sentence;  ///< what is so, and what to do; of a mesh without its name
    Where where{};
};
/// The sentence, with "source: " or "target: " before it if it is about a mesh.
std::string to_string(const Message& message);

/// The gravest of these severities; notice of none.
Severity gravest(const std::vector<Message>& messages);

/// Whether a message has this code.
bool contains(const std::vector<Message>& messages, MessageCode code);

}  // namespace counterpart
