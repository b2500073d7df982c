// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include <counterpart/base/errors.hpp>
#include <counterpart/transfer/transfer.hpp>

#include <fmt/format.h>

namespace counterpart {

bool has_materials(const AttributedMesh& content) {
    return content.document != nullptr && content.document->has_materials();
}

AttributedMesh with_materials(const AttributedMesh& content, const AttributedMesh& source,
                              const std::vector<Index>& source_parts) {
    AttributedMesh result = content;
    if (source.document == nullptr) {
        if (content.document == nullptr) return result;
        result.document = content.document->without_materials();
        result.part_names.clear();
        return result;
    }
    if (static_cast<Index>(source_parts.size()) != content.mesh.n_triangles() ||
        (!content.parts.empty() && content.parts.size() != source_parts.size()))
        throw InvalidInput(fmt::format("there are {} parts of the source for {} triangles",
                                       source_parts.size(), content.mesh.n_triangles()));
    if (content.document != nullptr) {
        Document::Assignment assignment =
            content.document->with_materials_of(*source.document, content.parts, source_parts);
        result.document = std::move(assignment.document);
        result.parts = std::move(assignment.parts);
        result.part_names.clear();
        return result;
    }
    result.document = source.document->without_skeleton();
    result.parts = source_parts;
    result.part_names = source.part_names;
    return result;
}

}  // namespace counterpart
