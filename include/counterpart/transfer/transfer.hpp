// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/message.hpp>
#include <counterpart/base/progress.hpp>
#include <counterpart/map/complete.hpp>
#include <counterpart/map/surface_map.hpp>
#include <counterpart/map/vertex_map.hpp>
#include <counterpart/mesh/attributed_mesh.hpp>

#include <string>
#include <vector>

namespace counterpart {

/// What to transfer. Attributes that the source does not have, or that are not selected, stay the target's.
struct TransferOptions {
    bool colors = true;
    bool texture_coordinates = true;
    bool normals = true;
    bool skin = true;
    bool morphs = true;
    bool materials = true;  ///< with their textures; texture coordinates are of no use without them
    /// Also normals of a source that is shaded flat, which say no more than its triangles do and would split
    /// every vertex of the target. A box is not shaded flat: most of its edges that bend are sharp.
    bool flat_normals = false;
    int max_influences = 0;  ///< maximum joints per vertex; 0 = as in the source (4 or 8 in glTF)
    int n_threads = 0;       ///< 0 = all; does not change the result
    Progress progress{};     ///< called between attributes
};

/// How one attribute was transferred; counts that do not apply to it are 0.
struct TransferredAttribute {
    std::string name;
    Coverage coverage;            ///< of the target's vertices
    Index seam_triangles = 0;     ///< target triangles with an edge on a seam
    Index moved_vertices = 0;     ///< images of target vertices moved onto a seam, for this attribute only
    Index without_triangles = 0;  ///< target triangles without values, as the source has none there
    Index limited_vertices = 0;   ///< that lost joints to max_influences
    Index unbound_vertices = 0;   ///< on components of the source without joints
};

struct TransferResult {
    AttributedMesh content;  ///< the target's mesh with the source's attributes
    Index n_matched = 0;     ///< target vertices with a point of the source
    std::vector<TransferredAttribute> attributes{};
    bool has_materials = false;  ///< materials of the source were transferred
    /// With skin or materials: for each target triangle the part of the source that it maps to.
    std::vector<Index> source_parts{};
    std::vector<Message> messages{};  ///< what may be wrong, and what to do
};

/// The source's attributes on the target's mesh: corners (transfer_corners, transfer_normals), skin
/// (transfer_skin), morph targets (transfer_morph_targets), then materials. A skeleton belongs to the
/// source's file, so with the skin the target takes over the source's `document` and `parts`; the skeleton is
/// right if the target has the source's bind pose and position, which is checked. Otherwise the target keeps
/// its own document, and the materials go into it. Without any documents the source's parts, being labels,
/// become the target's. The map is inverted first (with_inverse). Throws InvalidInput if map or attributes do
/// not fit the meshes, IoError if a texture is missing, Canceled.
TransferResult transfer(const AttributedMesh& source, const AttributedMesh& target,
                        const SurfaceMap& target_from_source, const TransferOptions& options = {});
/// The same from a vertex map, which is first made a sub-vertex map (project_map).
TransferResult transfer(const AttributedMesh& source, const AttributedMesh& target,
                        const VertexMap& target_from_source, const TransferOptions& options = {});
/// The same from the inverse map.
TransferResult transfer_through_inverse(const AttributedMesh& source, const AttributedMesh& target,
                                        const SurfaceMap& source_from_target,
                                        const TransferOptions& options = {});

/// Whether any part of the content's document has a material. O(number of parts).
bool has_materials(const AttributedMesh& content);

/// The content with the materials of another mesh: `source_parts` gives for each triangle the part of
/// `source` whose material it gets. Materials come with their textures and images into the content's own
/// document, whose skeleton, nodes and animations stay; a part that gets several materials is split. Content
/// without a document takes over the source's, without skeleton and animations. If the source has no
/// document, the result has no materials. Throws InvalidInput if the parts do not fit, IoError for an
/// incomplete document or a missing image.
AttributedMesh with_materials(const AttributedMesh& content, const AttributedMesh& source,
                              const std::vector<Index>& source_parts);

}  // namespace counterpart
