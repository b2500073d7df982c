// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "transfer/attributes.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/map/invert.hpp>
#include <counterpart/map/project.hpp>
#include <counterpart/transfer/transfer.hpp>

#include <algorithm>
#include <numeric>
#include <vector>

#include <fmt/format.h>

namespace counterpart {
namespace {

// Transfers one attribute after another into the result.
struct Transfer {
    const SurfaceMap& map;
    const AttributedMesh& source;
    const TransferOptions& options;
    TransferResult result;
    std::vector<Index> source_triangles;  // of the target's triangles, once known

    template <class Compute>
    CornerAttribute corners(const std::string& name, const Compute& compute) {
        attributes::TransferredCorners transferred;
        try {
            transferred = compute();
        } catch (const InvalidInput& error) {
            throw InvalidInput(name + ": " + error.what());
        }
        result.attributes.push_back({.name = name,
                                     .coverage = transferred.coverage,
                                     .seam_triangles = transferred.seam_triangles,
                                     .moved_vertices = transferred.moved_vertices,
                                     .without_triangles = transferred.without_triangles});
        if (source_triangles.empty()) source_triangles = std::move(transferred.source_from_target);
        return std::move(transferred.attribute);
    }
    std::vector<CornerAttribute> sets(const std::string& name, const std::vector<CornerAttribute>& all) {
        std::vector<CornerAttribute> transferred;
        for (const CornerAttribute& set : all) {
            const std::string numbered =
                all.size() == 1 ? name : fmt::format("{} {}", name, transferred.size());
            transferred.push_back(corners(numbered, [&] {
                return attributes::transfer_corners(map, source.mesh, result.content.mesh, set, source.parts,
                                                    {.n_threads = options.n_threads});
            }));
        }
        return transferred;
    }
    void skin() {
        attributes::TransferredSkin transferred = attributes::transfer_skin(
            map, source.mesh, result.content.mesh, source.skin, {.max_influences = options.max_influences});
        result.attributes.push_back({.name = "skin weights",
                                     .coverage = transferred.coverage,
                                     .limited_vertices = transferred.limited,
                                     .unbound_vertices = transferred.unbound});
        result.content.skin = std::move(transferred.skin);
    }
    void morphs() {
        attributes::TransferredMorphTargets transferred =
            attributes::transfer_morph_targets(map, source.mesh, result.content.mesh, source.morphs);
        result.attributes.push_back({.name = fmt::format("{} morph target{}", source.morphs.size(),
                                                         source.morphs.size() == 1 ? "" : "s"),
                                     .coverage = transferred.coverage});
        result.content.morphs = std::move(transferred.morphs);
    }
    // For each target triangle the source's part that it lies on.
    std::vector<Index> parts() {
        if (source.parts.empty()) return {};
        const CornerAttribute nothing{{}, Triangles::Constant(source.mesh.n_triangles(), 3, -1)};
        if (source_triangles.empty())
            source_triangles = attributes::transfer_corners(map, source.mesh, result.content.mesh, nothing,
                                                            source.parts, {.n_threads = options.n_threads})
                                   .source_from_target;
        std::vector<Index> parts;
        for (const Index t : source_triangles) parts.push_back(source.parts[static_cast<std::size_t>(t)]);
        return parts;
    }
};

// A skeleton is not moved: the target should lie where the source does.
void warn_of_another_place(TransferResult& result, const SurfaceMap& source_from_target,
                           const AttributedMesh& source) {
    constexpr double noticeable = 0.05;       // share of the source's size, on average ...
    constexpr double noticeable_part = 0.10;  // ... or for a twentieth of the vertices: a limb that is bent
    PointsView target = result.content.mesh.vertices;
    const Points images = image_positions(source_from_target, source.mesh);
    PointsView vertices = source.mesh.vertices;
    const double size = (vertices.colwise().maxCoeff() - vertices.colwise().minCoeff()).norm();
    std::vector<double> shares;
    for (Index v = 0; v < source_from_target.source_size(); ++v)
        if (source_from_target[v].matched()) shares.push_back((images.row(v) - target.row(v)).norm() / size);
    if (shares.empty()) return;
    const double mean =
        std::accumulate(shares.begin(), shares.end(), 0.0) / static_cast<double>(shares.size());
    const auto far = shares.begin() + static_cast<std::ptrdiff_t>(0.95 * static_cast<double>(shares.size()));
    std::nth_element(shares.begin(), far, shares.end());
    if (mean > noticeable || *far > noticeable_part)
        result.messages.push_back(
            {MessageCode::skeleton_stays, Severity::caution,
             fmt::format(
                 "the target is {:.0f} % of the source's size away from the source on average, {:.0f} % "
                 "or more for a twentieth of its vertices, but the skeleton stays in place: move the "
                 "target into the source's bind pose and position first",
                 100 * mean, 100 * *far)});
}

}  // namespace

TransferResult transfer_through_inverse(const AttributedMesh& source, const AttributedMesh& target,
                                        const SurfaceMap& source_from_target,
                                        const TransferOptions& options) {
    require_valid(source_from_target, target.mesh.n_vertices(), source.mesh.n_triangles());
    Transfer transfer{source_from_target, source, options, {.content = target}, {}};
    TransferResult& result = transfer.result;
    result.n_matched = count_matched(source_from_target);
    AttributedMesh& content = result.content;
    if (options.texture_coordinates && !source.texture_coordinates.empty())
        content.texture_coordinates = transfer.sets("texture coordinates", source.texture_coordinates);
    report_progress(options.progress, 0.25);
    if (options.colors && !source.colors.empty()) content.colors = transfer.sets("colors", source.colors);
    report_progress(options.progress, 0.4);
    const bool takes_skin = options.skin && source.skin.weights.size() > 0;
    if (takes_skin) transfer.skin();
    if (options.morphs && !source.morphs.empty()) transfer.morphs();
    report_progress(options.progress, 0.7);
    const bool has_normals = options.normals && source.normals.values.rows() > 0;
    if (has_normals && !options.flat_normals && attributes::is_shaded_flat(source.mesh, source.normals)) {
        result.messages.push_back({MessageCode::shaded_flat, Severity::notice,
                                   "the source is shaded flat: its normals, which say no more than its "
                                   "triangles, are not transferred"});
    } else if (has_normals) {
        content.normals = transfer.corners("normals", [&] {
            return attributes::transfer_normals(source_from_target, source.mesh, content.mesh, source.normals,
                                                {.n_threads = options.n_threads});
        });
    }
    result.has_materials = options.materials && has_materials(source);
    const bool takes_labels = options.materials && target.document == nullptr && source.document == nullptr;
    if (takes_skin || options.materials) result.source_parts = transfer.parts();
    if (takes_skin || takes_labels) {
        content.parts = result.source_parts;
        content.part_names = source.part_names;
    }
    if (takes_skin) {
        content.document = source.document;
        // The document is the source's now; without its materials the target keeps its own.
        if (!result.has_materials && (has_materials(source) || has_materials(target)))
            content = with_materials(content, target, target.parts);
        warn_of_another_place(result, source_from_target, source);
    } else if (result.has_materials) {
        content = with_materials(content, source, result.source_parts);
    }
    report_progress(options.progress, 1);
    return std::move(result);
}

TransferResult transfer(const AttributedMesh& source, const AttributedMesh& target,
                        const SurfaceMap& target_from_source, const TransferOptions& options) {
    constexpr double inverted = 0.5;  // of the work
    const MapPair maps =
        with_inverse(target_from_source, source.mesh, target.mesh,
                     {.n_threads = options.n_threads, .progress = part_of(options.progress, 0, inverted)});
    TransferOptions rest = options;
    rest.progress = part_of(options.progress, inverted, 1);
    return transfer_through_inverse(source, target, maps.source_from_target, rest);
}

TransferResult transfer(const AttributedMesh& source, const AttributedMesh& target,
                        const VertexMap& target_from_source, const TransferOptions& options) {
    constexpr double projected = 0.2;  // of the work
    const SurfaceMap map =
        project_map(source.mesh, target.mesh, target_from_source,
                    {.n_threads = options.n_threads, .progress = part_of(options.progress, 0, projected)});
    TransferOptions rest = options;
    rest.progress = part_of(options.progress, projected, 1);
    return transfer(source, target, map, rest);
}

}  // namespace counterpart
