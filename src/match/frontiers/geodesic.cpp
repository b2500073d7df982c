// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "base/parallel.hpp"
#include "base/progress_range.hpp"
#include "match/frontiers/side.hpp"

#include <counterpart/align/transform.hpp>
#include <counterpart/base/errors.hpp>
#include <counterpart/base/progress.hpp>
#include <counterpart/geodesic/critical_points.hpp>
#include <counterpart/match/frontiers.hpp>
#include <counterpart/mesh/measure.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace counterpart {
namespace {

constexpr double much_difference = 0.1;  // of two area profiles

constexpr int profile_steps = 64;
constexpr std::size_t most_candidates = 8;

// Share of the reached area within each of `profile_steps` parts of the largest distance.
using Profile = std::array<double, profile_steps>;

struct View {
    Index source = -1;
    Vector distance;  // relative to the farthest vertex, infinite where unreached
    Profile profile{};
};

// All that one mesh contributes before it is seen from a source vertex.
struct PairSide {
    explicit PairSide(MeshView m) : mesh(m), graph(m), areas(vertex_areas(m)) {}

    View view_from(Index source) const {
        View view{source, distances_from(graph, source), {}};
        double farthest = 0, area = 0;
        for (const double d : view.distance)
            if (std::isfinite(d)) farthest = std::max(farthest, d);
        if (farthest > 0) view.distance /= farthest;
        for (Index v = 0; v < view.distance.size(); ++v) {
            if (!std::isfinite(view.distance[v])) continue;
            const auto step = static_cast<std::size_t>(view.distance[v] * profile_steps);
            view.profile[std::min<std::size_t>(step, profile_steps - 1)] += areas[v];
            area += areas[v];
        }
        double sum = 0;
        for (double& share : view.profile) share = (sum += share) / (area > 0 ? area : 1);
        return view;
    }

    std::vector<View> views(Index given, const Progress& progress) const {
        if (given >= 0) return {view_from(given)};
        CriticalPointOptions critical;
        critical.progress = progress;
        std::vector<Index> tips = critical_points(mesh, graph, critical).vertices;
        if (tips.size() > most_candidates) tips.resize(most_candidates);
        std::vector<View> result;
        for (const Index tip : tips) result.push_back(view_from(tip));
        return result;
    }

    MeshView mesh;
    DistanceGraph graph;
    Vector areas;
};

double difference(const Profile& a, const Profile& b) {
    double largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
    return largest;
}

// Bands in a common frame and unit, none of them empty: an empty one joins the one before.
struct Bands {
    Bands(const PairSide& side, const View& view, Index count, double unit)
        : points((side.mesh.vertices.rowwise() - surface_centroid(side.mesh).transpose()) /
                 (unit * std::sqrt(surface_area(side.mesh)))),
          frontiers(distance_frontiers(view.distance, (1 + 1e-9) / count)) {}

    std::span<const Index> at_level(Index k) const {
        k = std::min(k, frontiers.count() - 1);
        while (k > 0 && frontiers.size(k) == 0) --k;
        return frontiers[k];
    }
    Points centers(Index count) const {
        Points result(count, 3);
        for (Index k = 0; k < count; ++k)
            result.row(k) = frontiers::rows_of(points, at_level(k)).colwise().mean();
        return result;
    }

    Points points;
    Frontiers frontiers;
};

// How far apart the bands' centers are as they lie, and how to bring them together if that is clearly closer.
struct CentersFit {
    double residual = 0;
    std::optional<Similarity> turn;
};

CentersFit fit_centers(const Bands& ours, const Bands& theirs, Index count) {
    constexpr double clearly = 0.5;
    const Points x = ours.centers(count), y = theirs.centers(count);
    const Similarity turn = kabsch(x, y);
    const double as_they_lie = (align_centroids(x, y)(x) - y).squaredNorm(),
                 turned = (turn(x) - y).squaredNorm() / clearly;
    if (turned < as_they_lie) return {turned, turn};
    return {as_they_lie, std::nullopt};
}

void require_usable(MeshView source, MeshView target, const GeodesicFrontiersOptions& options) {
    require_valid(source);
    require_valid(target);
    if (!(surface_area(source) > 0) || !(surface_area(target) > 0))
        throw InvalidInput("a mesh has no area: all its triangles are degenerate");
    if ((options.source_seed == -1) != (options.target_seed == -1))
        throw InvalidInput("give both seed vertices, one of each mesh, or none");
    if (options.source_seed < -1 || options.target_seed < -1 || options.source_seed >= source.n_vertices() ||
        options.target_seed >= target.n_vertices())
        throw InvalidInput("a seed vertex does not exist");
    if (options.n_bands < 0 || options.n_bands > 1'000'000 || !(options.deformation_threshold >= 0))
        throw InvalidInput("n_bands must be from 0 to 1000000 and deformation_threshold at least 0");
}

struct Start {
    double profile_difference = 0;
    Bands source, target;
    CentersFit fit;
    Index source_vertex = -1, target_vertex = -1;
};

// Of the views that are about as much alike as the two that are most, as from the left and the right hand,
// those whose bands lie closest.
Start choose_start(const PairSide& a, const PairSide& b, const GeodesicFrontiersOptions& options,
                   Index n_bands, double unit) {
    constexpr double about = 0.02;
    const std::vector<View> sources = a.views(options.source_seed, part_of(options.progress, 0, 0.3)),
                            targets = b.views(options.target_seed, part_of(options.progress, 0.3, 0.6));
    double least = std::numeric_limits<double>::infinity();
    for (const View& x : sources)
        for (const View& y : targets) least = std::min(least, difference(x.profile, y.profile));
    std::optional<Start> best;
    for (const View& x : sources) {
        for (const View& y : targets) {
            const double unlike = difference(x.profile, y.profile);
            if (unlike > least + about) continue;
            report_progress(options.progress, 0.6);
            Start start{unlike,  Bands(a, x, n_bands, unit), Bands(b, y, n_bands, unit), {}, x.source,
                        y.source};
            start.fit = fit_centers(start.source, start.target, n_bands);
            if (!best || start.fit.residual < best->fit.residual) best = std::move(start);
        }
    }
    return std::move(*best);
}

GeodesicFrontiersResult match(MeshView source, MeshView target, const GeodesicFrontiersOptions& options) {
    Stopwatch watch;
    const PairSide a(source), b(target);
    const Index fewer = std::min(source.n_vertices(), target.n_vertices());
    const Index n = options.n_bands > 0
                        ? options.n_bands
                        : std::max<Index>(1, static_cast<Index>(std::lround(std::sqrt(fewer))));
    // The unit is the mean edge of both at unit area.
    const double unit = (mean_edge_length(source) / std::sqrt(surface_area(source)) +
                         mean_edge_length(target) / std::sqrt(surface_area(target))) /
                        2;
    Start start = choose_start(a, b, options, n, unit);
    Bands &ours = start.source, &theirs = start.target;
    if (start.fit.turn) ours.points = (*start.fit.turn)(ours.points);
    GeodesicFrontiersResult result;
    result.source_seed = start.source_vertex;
    result.target_seed = start.target_vertex;
    result.profile_difference = start.profile_difference;
    if (start.profile_difference > much_difference)
        result.messages.push_back(
            {MessageCode::unsure, Severity::caution,
             "the surfaces around the two seeds differ too much: this map is unreliable"});
    result.n_bands = n;
    watch.lap("frontiers");
    std::vector<Index> image(to_size(source.n_vertices()), VertexMap::unmatched);
    const Progress check = frontiers::checking(options.progress);
    parallel_for(to_size(std::min(n, ours.frontiers.count())), 1, [&](std::size_t k) {
        const auto mine = ours.frontiers[static_cast<Index>(k)],
                   other = theirs.at_level(static_cast<Index>(k));
        if (mine.empty()) return;
        const Points x = frontiers::rows_of(ours.points, mine), y = frontiers::rows_of(theirs.points, other);
        const Points aligned = frontiers::align_whole_frontier(x, y, options.deformation_threshold, check);
        const std::vector<Index> chosen =
            frontiers::pair_up(frontiers::pairing_cost(mine, aligned, other, y, {}), options.pairing, check);
        for (std::size_t i = 0; i < mine.size(); ++i)
            if (chosen[i] >= 0) image[to_size(mine[i])] = other[to_size(chosen[i])];
    });
    result.target_from_source = VertexMap(std::move(image), target.n_vertices());
    watch.lap("matching");
    result.stages = watch.stages();
    return result;
}

}  // namespace

GeodesicFrontiersResult match_geodesic_frontiers(MeshView source, MeshView target,
                                                 const GeodesicFrontiersOptions& options) {
    require_usable(source, target, options);
    return with_progress(options.progress, [&](const ProgressRange& progress) {
        GeodesicFrontiersOptions shared = options;
        shared.progress = progress.callback();  // which any of the threads may call
        return with_threads(options.n_threads, [&] { return match(source, target, shared); });
    });
}

}  // namespace counterpart
