// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/mesh/attributed_mesh.hpp>

#include <vector>

namespace counterpart {

/// Whether any part of the content's document has a material. O(number of parts).
bool has_materials(const AttributedMesh& content);

/// The content with the materials of another mesh: `source_parts` names for each triangle the part of
/// `source` whose material it gets. Materials come with their textures and images into the content's own
/// document, whose skeleton, nodes and animations stay; a part that gets several materials is split. Content
/// without a document takes over the source's, without skeleton and animations. A source without a document
/// has no materials: then content has none either. Throws InvalidInput if the parts do not fit, IoError for a
/// document that is not whole or an image that is missing.
AttributedMesh with_materials(const AttributedMesh& content, const AttributedMesh& source,
                              const std::vector<Index>& source_parts);

}  // namespace counterpart
