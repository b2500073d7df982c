// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include <counterpart/base/errors.hpp>
#include <counterpart/transfer/corner_attribute.hpp>
#include <counterpart/transfer/morph_targets.hpp>
#include <counterpart/transfer/normals.hpp>
#include <counterpart/transfer/skin.hpp>
#include <counterpart/transfer/transfer.hpp>

#include <fmt/format.h>

namespace counterpart {
namespace {

// Carries one thing after another into the result.
struct Transfer {
    const SurfaceMap& map;
    const AttributedMesh& source;
    const TransferOptions& options;
    TransferResult result;
    std::vector<Index> source_triangles;  // of the target's triangles, once known

    template <class Carry>
    CornerAttribute corners(const std::string& name, const Carry& carry) {
        CarriedCorners carried;
        try {
            carried = carry();
        } catch (const InvalidInput& error) {
            throw InvalidInput(name + ": " + error.what());
        }
        result.attributes.push_back({.name = name,
                                     .coverage = carried.coverage,
                                     .seam_triangles = carried.seam_triangles,
                                     .moved_vertices = carried.moved_vertices,
                                     .without_triangles = carried.without_triangles});
        if (source_triangles.empty()) source_triangles = std::move(carried.source_from_target);
        return std::move(carried.attribute);
    }
    std::vector<CornerAttribute> sets(const std::string& name, const std::vector<CornerAttribute>& all) {
        std::vector<CornerAttribute> carried;
        for (const CornerAttribute& set : all) {
            const std::string numbered = all.size() == 1 ? name : fmt::format("{} {}", name, carried.size());
            carried.push_back(corners(numbered, [&] {
                return carry_corners(map, source.mesh, result.content.mesh, set, source.parts,
                                     {.n_threads = options.n_threads});
            }));
        }
        return carried;
    }
    void skin() {
        CarriedSkin carried = carry_skin(map, source.mesh, result.content.mesh, source.skin,
                                         {.max_influences = options.max_influences});
        result.attributes.push_back({.name = "skin weights",
                                     .coverage = carried.coverage,
                                     .limited_vertices = carried.limited,
                                     .unbound_vertices = carried.unbound});
        result.content.skin = std::move(carried.skin);
    }
    void morphs() {
        CarriedMorphs carried = carry_morphs(map, source.mesh, result.content.mesh, source.morphs);
        result.attributes.push_back(
            {.name = fmt::format("{} morph targets", source.morphs.size()), .coverage = carried.coverage});
        result.content.morphs = std::move(carried.morphs);
    }
    // For each target triangle the source's part that it lies on.
    std::vector<Index> parts() {
        if (source.parts.empty()) return {};
        const CornerAttribute nothing{{}, Triangles::Constant(source.mesh.n_triangles(), 3, -1)};
        if (source_triangles.empty())
            source_triangles = carry_corners(map, source.mesh, result.content.mesh, nothing, source.parts,
                                             {.n_threads = options.n_threads})
                                   .source_from_target;
        std::vector<Index> parts;
        for (const Index t : source_triangles) parts.push_back(source.parts[static_cast<std::size_t>(t)]);
        return parts;
    }
};

}  // namespace

TransferResult transfer_attributes(const SurfaceMap& source_from_target, const AttributedMesh& source,
                                   const AttributedMesh& target, const TransferOptions& options) {
    Transfer transfer{source_from_target, source, options, {target, {}, {}}, {}};
    AttributedMesh& content = transfer.result.content;
    if (options.texture_coordinates && !source.texture_coordinates.empty())
        content.texture_coordinates = transfer.sets("texture coordinates", source.texture_coordinates);
    if (options.colors && !source.colors.empty()) content.colors = transfer.sets("colours", source.colors);
    const bool takes_skin = options.skin && source.skin.weights.size() > 0;
    if (takes_skin) transfer.skin();
    if (options.morphs && !source.morphs.empty()) transfer.morphs();
    if (takes_skin || options.material) transfer.result.source_parts = transfer.parts();
    if (takes_skin) content.document = source.document;
    if (takes_skin || (options.material && target.document == nullptr && source.document == nullptr)) {
        content.parts = transfer.result.source_parts;
        content.part_names = source.part_names;
    }
    if (options.normals && source.normals.values.rows() > 0) {
        content.normals = transfer.corners("normals", [&] {
            return carry_normals(source_from_target, source.mesh, content.mesh, source.normals,
                                 {.n_threads = options.n_threads});
        });
    }
    return std::move(transfer.result);
}

}  // namespace counterpart
