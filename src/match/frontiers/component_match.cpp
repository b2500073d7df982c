// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/frontiers/component_match.hpp"

#include "base/parallel.hpp"
#include "frontier/edge_splits.hpp"
#include "frontier/seed_selection.hpp"
#include "match/frontiers/side.hpp"

#include <counterpart/align/transform.hpp>
#include <counterpart/base/errors.hpp>
#include <counterpart/geodesic/critical_points.hpp>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>

namespace counterpart::frontiers {
namespace {

using Corners = std::array<Index, 3>;

// Starting at the smallest corner, winding kept.
Corners canonical(Index a, Index b, Index c) {
    if (a <= b && a <= c) return {a, b, c};
    return b <= a && b <= c ? Corners{b, c, a} : Corners{c, a, b};
}

std::vector<Corners> sorted_triangles(MeshView mesh) {
    std::vector<Corners> result;
    for (Index t = 0; t < mesh.n_triangles(); ++t)
        result.push_back(canonical(mesh.triangles(t, 0), mesh.triangles(t, 1), mesh.triangles(t, 2)));
    std::sort(result.begin(), result.end());
    return result;
}

// How well a map onto one of several candidate seeds fits: triangles lost or inverted, then edge
// lengths (which bending hardly changes), then positions.
struct Misfit {
    Index lost_triangles = 0;
    double lengths_and_positions = 0;
    auto operator<=>(const Misfit&) const = default;
};

Misfit misfit(const FrontierSide& a, const FrontierSide& b, const std::vector<Index>& image,
              const Eigen::Matrix3d* rotation) {
    const std::vector<Corners> triangles = sorted_triangles(b.mesh);
    Misfit result;
    for (Index t = 0; t < a.mesh.n_triangles(); ++t) {
        const auto corner = [&](int c) { return image[to_size(a.mesh.triangles(t, c))]; };
        if (!std::binary_search(triangles.begin(), triangles.end(),
                                canonical(corner(0), corner(1), corner(2))))
            ++result.lost_triangles;
    }
    double lengths = 0;
    MatchedPairs pairs;
    for (Index v = 0; v < a.mesh.n_vertices(); ++v) {
        if (image[to_size(v)] < 0) continue;
        pairs.add(v, image[to_size(v)]);
        for (const Index w : a.adjacency.neighbors(v)) {
            if (image[to_size(w)] < 0) continue;
            const double difference =
                (a.points.row(v) - a.points.row(w)).norm() -
                (b.points.row(image[to_size(v)]) - b.points.row(image[to_size(w)])).norm();
            lengths += difference * difference;
        }
    }
    if (pairs.source.empty()) return result;
    const Points x = rows_of(a.points, pairs.source), y = rows_of(b.points, pairs.target);
    const Points moved = rotation != nullptr ? Points(x * rotation->transpose()) : kabsch(x, y)(x);
    // Where the surroundings tell the rotation, position says as much as lengths; else it only breaks ties.
    const double weight = rotation != nullptr ? 1 : 1e-3;
    result.lengths_and_positions = lengths / std::max<Index>(1, 2 * a.adjacency.n_edges()) +
                                   weight * (moved - y).rowwise().squaredNorm().mean();
    return result;
}

// The critical points of a surface, the most prominent first; small components do not need them.
std::vector<Index> candidates_of(const ComponentMesh& component, int n_threads, const Progress& progress) {
    constexpr std::size_t small = 200;
    if (component.vertices.size() < small || component.mesh.n_triangles() == 0) return {};
    CriticalPointOptions critical;
    critical.n_bases = 16;  // the choice is verified, so a coarse sample will do
    critical.n_threads = n_threads;
    critical.progress = progress;
    return critical_points(component.mesh, DistanceGraph(component.mesh), critical).vertices;
}

frontier::SeedSelection sources_of(const ComponentMesh& source, const ComponentMesh& target,
                                   const FrontiersOptions& options, std::pair<Index, Index> given,
                                   Stopwatch& watch) {
    if (given.first >= 0) return {given.first, {given.second}, 1, SeedTest::given};
    const std::vector<Index> ours =
                                 candidates_of(source, options.n_threads, part_of(options.progress, 0, 0.3)),
                             theirs = candidates_of(target, options.n_threads,
                                                    part_of(options.progress, 0.3, 0.6));
    watch.lap("critical points");
    frontier::SeedSelectionOptions selection_options;
    selection_options.n_threads = options.n_threads;
    selection_options.progress = part_of(options.progress, 0.6, 1);
    frontier::SeedSelection selection = frontier::select_seeds(
        source.mesh, source.adjacency, ours, target.mesh, target.adjacency, theirs, selection_options);
    if (selection.targets.empty())
        throw UnsuitableMesh(
            fmt::format("the connectivity differs: no target vertex has the frontiers of source vertex {}; "
                        "the closest ones agree up to "
                        "level {} and differ at the next",
                        source.vertices[to_size(selection.source)], selection.longest_agreement - 1));
    return selection;
}

// Both sides seen from a pair of source vertices, with edges split if that is asked for.
class SidePair {
  public:
    SidePair(const ComponentMesh& source, const ComponentMesh& target, Index s, Index t, bool split_edges) {
        if (split_edges) {
            split_a_.emplace(
                frontier::split_edges_for_depth(source.mesh, bfs_frontiers(source.adjacency, s)).mesh);
            split_b_.emplace(
                frontier::split_edges_for_depth(target.mesh, bfs_frontiers(target.adjacency, t)).mesh);
            adjacency_a_.emplace(*split_a_);
            adjacency_b_.emplace(*split_b_);
        }
        const auto make = [&](bool is_source) {
            if (is_source)
                a_.emplace(split_edges ? *split_a_ : source.mesh,
                           split_edges ? *adjacency_a_ : source.adjacency, s);
            else
                b_.emplace(split_edges ? *split_b_ : target.mesh,
                           split_edges ? *adjacency_b_ : target.adjacency, t);
        };
        parallel_for(2, 1, [&](std::size_t i) { make(i == 0); });
    }
    const FrontierSide& a() const { return *a_; }
    const FrontierSide& b() const { return *b_; }

  private:
    std::optional<TriangleMesh> split_a_, split_b_;
    std::optional<Adjacency> adjacency_a_, adjacency_b_;
    std::optional<FrontierSide> a_, b_;
};

}  // namespace

ComponentImage match_component(const ComponentMesh& source, const ComponentMesh& target,
                               const FrontiersOptions& options, std::pair<Index, Index> given,
                               const Eigen::Matrix3d* rotation, Stopwatch& watch) {
    if (source.vertices.size() == 1) return {{0}, 0, {1, 1, 0, 0, SeedTest::eccentric, 1}};
    const Progress& progress = options.progress;
    FrontiersOptions run = options;
    run.progress = part_of(progress, 0, 0.4);
    const frontier::SeedSelection selection = sources_of(source, target, run, given, watch);
    watch.lap("source selection");
    ComponentImage best;
    std::optional<Misfit> best_misfit;
    const auto n_targets = static_cast<double>(selection.targets.size());
    double n_tried = 0;
    for (const Index candidate : selection.targets) {
        run.progress =
            part_of(progress, 0.4 + 0.6 * n_tried / n_targets, 0.4 + 0.6 * (n_tried + 1) / n_targets);
        ++n_tried;
        report_progress(run.progress, 0);
        const SidePair sides(source, target, selection.source, candidate, options.edge_splits);
        require_same_frontiers(sides.a(), sides.b());
        watch.lap("frontiers");
        SideMatch match = options.paper ? match_whole_frontiers(sides.a(), sides.b(), run)
                                        : match_frontiers_in_sequence(sides.a(), sides.b(), run, rotation);
        std::optional<Misfit> fit;
        if (selection.targets.size() > 1) fit = misfit(sides.a(), sides.b(), match.image, rotation);
        watch.lap("matching");
        if (best_misfit && !(*fit < *best_misfit)) continue;
        best_misfit = fit;
        // Vertices made by edge splits come last and are dropped.
        match.image.resize(source.vertices.size());
        for (Index& image : match.image)
            if (image >= static_cast<Index>(target.vertices.size())) image = VertexMap::unmatched;
        best = {std::move(match.image),
                match.n_decided_by_position,
                {static_cast<Index>(source.vertices.size()), sides.a().frontiers.count(), selection.source,
                 candidate, selection.test, selection.n_alike}};
    }
    return best;
}

}  // namespace counterpart::frontiers
