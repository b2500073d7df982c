// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "base/parallel.hpp"
#include "base/to_size.hpp"
#include "match/verdict/doubts.hpp"
#include "match/volume/extension.hpp"
#include "match/volume/isomorphism.hpp"
#include "numerics/nearest_neighbors.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/map/project.hpp>
#include <counterpart/map/surface_map.hpp>
#include <counterpart/match/volume.hpp>

#include <utility>

#include <fmt/format.h>

namespace counterpart {
namespace {

VolumeResult by_frontiers(const TetrahedralMesh& source, const TetrahedralMesh& target,
                          const VolumeOptions& options) {
    FrontiersOptions how = options.frontiers;
    how.n_threads = options.n_threads;
    how.progress = options.progress;
    VolumeResult result;
    result.method = MatchMethod::frontiers;
    result.frontiers = match_frontiers(all_faces(source), all_faces(target), how);
    result.target_from_source = result.frontiers->target_from_source;
    result.confidence = result.frontiers->confidence;
    result.stages = result.frontiers->stages;
    return result;
}

// Where the solid's vertices go and how sure that is: the surface's from its map, those inside between them.
Matrix images_in_space(const TetrahedralMesh& source, const SolidBoundary& from, const SurfaceMap& map,
                       const SolidBoundary& to, const Vector& confidence) {
    Matrix values = Matrix::Zero(source.n_vertices(), 4);
    const Points positions = image_positions(map, to.mesh);
    std::vector<char> known(to_size(source.n_vertices()), 0);
    for (std::size_t i = 0; i < from.vertices.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        if (!map[static_cast<Index>(i)].matched()) continue;
        values.row(from.vertices[i]) << positions.row(row), confidence[row];
        known[to_size(from.vertices[i])] = 1;
    }
    return volume::extended(source, values, known);
}

VolumeResult by_surfaces(const TetrahedralMesh& source, const TetrahedralMesh& target,
                         const VolumeOptions& options) {
    Stopwatch watch;
    const SolidBoundary from = boundary(source), to = boundary(target);
    SpectralOptions how = options.spectral;
    how.n_threads = options.n_threads;
    how.progress = part_of(options.progress, 0, 0.9);
    VolumeResult result;
    result.method = MatchMethod::spectral;
    result.spectral = match_spectral(from.mesh, to.mesh, how, options.spectral_shape);
    result.messages = result.spectral->messages;
    watch.lap("surfaces");
    const VertexMap& surface_map = result.spectral->target_from_source;
    const SurfaceMap points = project_map(from.mesh, to.mesh, surface_map, {.n_threads = options.n_threads});
    const Matrix images = images_in_space(source, from, points, to, result.spectral->confidence);
    report_progress(options.progress, 0.95);
    const numerics::NearestNeighbors nodes(target.vertices);
    std::vector<Index> image(to_size(source.n_vertices()));
    parallel_for(image.size(), 256, [&](std::size_t v) {
        image[v] = nodes.closest(images.row(static_cast<Eigen::Index>(v)).head<3>()).index;
    });
    for (std::size_t i = 0; i < from.vertices.size(); ++i) {
        const Index partner = surface_map[static_cast<Index>(i)];
        image[to_size(from.vertices[i])] = partner < 0 ? -1 : to.vertices[to_size(partner)];
    }
    result.target_from_source = VertexMap(std::move(image), target.n_vertices());
    result.confidence = images.col(3).cwiseMax(0).cwiseMin(1);
    watch.lap("inside");
    result.stages = watch.stages();
    report_progress(options.progress, 1);
    return result;
}

// What a person knows of the map is followed or refused, never dropped.
void require_followed(const VolumeOptions& options) {
    const SpectralOptions& said = options.spectral;
    const bool is_known = !said.landmarks.empty() || !said.excluded.empty() || said.aligned ||
                          !said.up.isZero(0) || !said.facing.isZero(0) || said.symmetric || said.initial;
    if (is_known && options.method != MatchMethod::spectral)
        throw InvalidInput(
            "of solids, only the method 'spectral' follows what is known of the map (landmarks, excluded, "
            "aligned, up, facing, symmetric, initial): name it");
}

VolumeResult matched(const TetrahedralMesh& source, const TetrahedralMesh& target,
                     const VolumeOptions& options) {
    switch (options.method) {
        case MatchMethod::frontiers:
            return by_frontiers(source, target, options);
        case MatchMethod::spectral:
            return by_surfaces(source, target, options);
        case MatchMethod::exact:
            return volume::match_connectivity(source, target, options.allow_mirror, options.progress);
        case MatchMethod::automatic:
            break;
        default:
            throw InvalidInput(fmt::format("solids are not matched by '{}': use exact, frontiers or spectral",
                                           to_string(options.method)));
    }
    VolumeResult exact =
        volume::match_connectivity(source, target, options.allow_mirror, part_of(options.progress, 0, 0.1));
    if (exact.identical) return exact;
    VolumeOptions rest = options;
    rest.progress = part_of(options.progress, 0.1, 1);
    VolumeResult result = by_surfaces(source, target, rest);
    result.difference = std::move(exact.difference);
    return result;
}

}  // namespace

VolumeResult match_volume(const TetrahedralMesh& source, const TetrahedralMesh& target,
                          const VolumeOptions& options) {
    require_valid(source);
    require_valid(target);
    require_followed(options);
    return with_threads(options.n_threads, [&] {
        VolumeResult result = matched(source, target, options);
        if (result.method == MatchMethod::exact && !result.identical) return result;
        for (Message& doubt :
             judgment::doubts(result.target_from_source, result.confidence, all_faces(source), 1))
            result.messages.push_back(std::move(doubt));
        return result;
    });
}

}  // namespace counterpart
