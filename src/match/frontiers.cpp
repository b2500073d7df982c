// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "base/parallel.hpp"
#include "base/progress_range.hpp"
#include "match/frontiers/component_match.hpp"
#include "match/frontiers/components.hpp"
#include "match/frontiers/side.hpp"
#include "mesh/polygons.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/base/progress.hpp>
#include <counterpart/match/frontiers.hpp>

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace counterpart {
namespace {

void require_usable(MeshView source, MeshView target, const FrontiersOptions& options) {
    require_valid(source);
    require_valid(target);
    if ((options.source_seed == -1) != (options.target_seed == -1))
        throw InvalidInput("give both seed vertices, one of each mesh, or none");
    if (options.source_seed < -1 || options.target_seed < -1 || options.source_seed >= source.n_vertices() ||
        options.target_seed >= target.n_vertices())
        throw InvalidInput(fmt::format(
            "source seed {} or target seed {} does not exist: vertices run from 0 to "
            "{} and {}",
            options.source_seed, options.target_seed, source.n_vertices() - 1, target.n_vertices() - 1));
    if (!(options.deformation_threshold >= 0) || !(options.edge_penalty >= 0))
        throw InvalidInput("deformation_threshold and edge_penalty must be at least 0");
}

Index local_index(const frontiers::ComponentMesh& component, Index vertex) {
    const auto it = std::lower_bound(component.vertices.begin(), component.vertices.end(), vertex);
    return it != component.vertices.end() && *it == vertex
               ? static_cast<Index>(it - component.vertices.begin())
               : -1;
}

// The share of each vertex's edges that its image keeps; isolated vertices have nothing to contradict them.
Vector edge_confidence(const Adjacency& source, const Adjacency& target, const VertexMap& map) {
    Vector confidence(map.source_size());
    parallel_for(map.image().size(), 512, [&](std::size_t i) {
        const auto v = static_cast<Index>(i);
        const auto neighbors = source.neighbors(v);
        const auto kept = std::count_if(neighbors.begin(), neighbors.end(), [&](Index w) {
            return map[v] >= 0 && map[w] >= 0 && target.has_edge(map[v], map[w]);
        });
        confidence[v] = map[v] < 0 ? 0
                        : neighbors.empty()
                            ? 1
                            : static_cast<double>(kept) / static_cast<double>(neighbors.size());
    });
    return confidence;
}

class FrontiersMatch {
  public:
    FrontiersMatch(MeshView source, MeshView target, const FrontiersOptions& options)
        : source_(source), target_(target), options_(options) {}

    FrontiersResult run() {
        const Adjacency source_adjacency(source_), target_adjacency(target_);
        frontiers::require_same_counts(source_, source_adjacency, target_, target_adjacency);
        source_parts_ = frontiers::split_components(source_, source_adjacency);
        target_parts_ = frontiers::split_components(target_, target_adjacency);
        const std::vector<frontiers::ComponentGroup> groups =
            frontiers::group_components(source_parts_, target_parts_);
        image_.assign(to_size(source_.n_vertices()), VertexMap::unmatched);
        watch_.lap("connectivity");
        // Components of unique connectivity anchor those that share theirs with others.
        for (const bool single : {true, false})
            for (const frontiers::ComponentGroup& group : groups)
                if ((group.source.size() == 1) == single) match_group(group);
        std::stable_sort(
            result_.components.begin(), result_.components.end(),
            [](const ComponentMatch& a, const ComponentMatch& b) { return a.n_vertices > b.n_vertices; });
        result_.target_from_source = VertexMap(std::move(image_), target_.n_vertices());
        result_.confidence = edge_confidence(source_adjacency, target_adjacency, result_.target_from_source);
        watch_.lap("confidence");
        result_.stages = watch_.stages();
        return std::move(result_);
    }

  private:
    void match_group(const frontiers::ComponentGroup& group) {
        std::vector<frontiers::PlacedPair> pairs{{0, 0, {}}};
        if (group.source.size() > 1)
            pairs = frontiers::place_components(source_, target_, source_parts_, target_parts_, group, image_,
                                                given_pair(group), frontiers::checking(options_.progress));
        watch_.lap("components");
        for (const frontiers::PlacedPair& pair : pairs) {
            const frontiers::ComponentMesh& ours = source_parts_[group.source[pair.source]];
            const frontiers::ComponentMesh& theirs = target_parts_[group.target[pair.target]];
            const Index source = local_index(ours, options_.source_seed),
                        partner = local_index(theirs, options_.target_seed);
            if ((source < 0) != (partner < 0))
                throw InvalidInput(
                    fmt::format("source seed {} and target seed {} lie in components of different "
                                "connectivity",
                                options_.source_seed, options_.target_seed));
            const frontiers::ComponentImage match =
                frontiers::match_component(ours, theirs, options_for(ours), {source, partner},
                                           pair.rotation ? &*pair.rotation : nullptr, watch_);
            ComponentMatch summary = match.summary;
            summary.n_interchangeable = static_cast<Index>(group.source.size());
            summary.source = ours.vertices[to_size(summary.source)];
            summary.target = theirs.vertices[to_size(summary.target)];
            result_.components.push_back(summary);
            result_.n_decided_by_position += match.n_decided_by_position;
            for (std::size_t v = 0; v < match.image.size(); ++v)
                if (match.image[v] >= 0)
                    image_[to_size(ours.vertices[v])] = theirs.vertices[to_size(match.image[v])];
        }
    }

    // With progress counted over the vertices of all components.
    FrontiersOptions options_for(const frontiers::ComponentMesh& component) {
        FrontiersOptions options = options_;
        const double all = source_.n_vertices(), done = n_done_ / all;
        const double share = static_cast<double>(component.vertices.size()) / all;
        n_done_ += static_cast<double>(component.vertices.size());
        options.progress = part_of(options_.progress, done, done + share);
        return options;
    }

    // The places in the group of the components that the given source vertices name.
    std::pair<Index, Index> given_pair(const frontiers::ComponentGroup& group) const {
        std::pair<Index, Index> given{-1, -1};
        for (std::size_t i = 0; i < group.source.size(); ++i) {
            if (local_index(source_parts_[group.source[i]], options_.source_seed) >= 0)
                given.first = static_cast<Index>(i);
            if (local_index(target_parts_[group.target[i]], options_.target_seed) >= 0)
                given.second = static_cast<Index>(i);
        }
        return given;
    }

    MeshView source_, target_;
    const FrontiersOptions& options_;
    std::vector<frontiers::ComponentMesh> source_parts_, target_parts_;
    std::vector<Index> image_;  // of the components matched so far
    FrontiersResult result_;
    double n_done_ = 0;
    Stopwatch watch_;
};

// By polygons, wherever they begin and however they were cut: their middles are matched like vertices, and
// left out of the result.
FrontiersResult match_coned(MeshView source, MeshView target, const FrontiersOptions& options) {
    const TriangleMesh from = mesh::coned(source), to = mesh::coned(target);
    FrontiersResult result = FrontiersMatch(from, to, options).run();
    const Index n = source.n_vertices();
    std::vector<Index> image(result.target_from_source.image().begin(),
                             result.target_from_source.image().begin() + n);
    for (Index& w : image)
        if (w >= target.n_vertices()) w = VertexMap::unmatched;
    result.confidence.conservativeResize(n);
    const Components components = connected_components(Adjacency(source));
    std::vector<Index> sizes(to_size(components.count), 0);
    for (const Index component : components.of_vertex) ++sizes[to_size(component)];
    for (ComponentMatch& component : result.components) {
        if (component.source >= n) {
            component.source = source.triangles(source.polygons->first_triangle(component.source - n), 0);
            component.target = image[to_size(component.source)];
        }
        component.n_vertices = sizes[to_size(components.of_vertex[to_size(component.source)])];
    }
    result.target_from_source = VertexMap(std::move(image), target.n_vertices());
    return result;
}

bool have_like_polygons(MeshView source, MeshView target) {
    return source.polygons != nullptr && target.polygons != nullptr &&
           mesh::first_difference(*source.polygons, *target.polygons).empty();
}

}  // namespace

FrontiersResult match_frontiers(MeshView source, MeshView target, const FrontiersOptions& options) {
    require_usable(source, target, options);
    return with_progress(options.progress, [&](const ProgressRange& progress) {
        FrontiersOptions shared = options;
        shared.progress = progress.callback();  // which any of the threads may call
        return with_threads(options.n_threads, [&] {
            return have_like_polygons(source, target) ? match_coned(source, target, shared)
                                                      : FrontiersMatch(source, target, shared).run();
        });
    });
}

}  // namespace counterpart
