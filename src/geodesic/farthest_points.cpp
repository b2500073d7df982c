// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "geodesic/dijkstra.hpp"
#include "geodesic/require.hpp"

#include <counterpart/geodesic/farthest_points.hpp>
#include <counterpart/mesh/adjacency.hpp>
#include <counterpart/mesh/measure.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace counterpart {
namespace {

constexpr double unreached = std::numeric_limits<double>::infinity();

void require_options(MeshView mesh, const DistanceGraph& graph, const FarthestPointOptions& options) {
    if (mesh.n_vertices() != graph.n_vertices())
        throw InvalidInput(fmt::format("the mesh has {} vertices, its distance graph {}", mesh.n_vertices(),
                                       graph.n_vertices()));
    if (options.count < 0 || !(options.radius >= 0) || (options.count == 0 && options.radius == 0))
        throw InvalidInput(
            fmt::format("farthest-point sampling needs a positive count or a positive radius, not {} and {}",
                        options.count, options.radius));
    if (options.first != -1) geodesic::require_vertices(graph, std::array{options.first}, "the first sample");
}

// The vertex to begin each component with, the component with most vertices first.
std::vector<Index> beginnings(MeshView mesh) {
    const Components components = connected_components(Adjacency(mesh));
    const Eigen::RowVector3d center = surface_centroid(mesh).transpose();
    struct Beginning {
        Index size = 0;
        double distance = -1;
        Index vertex = -1;
    };
    std::vector<Beginning> found(static_cast<std::size_t>(components.count));
    for (Index v = 0; v < mesh.n_vertices(); ++v) {
        Beginning& beginning =
            found[static_cast<std::size_t>(components.of_vertex[static_cast<std::size_t>(v)])];
        const double distance = (mesh.vertices.row(v) - center).squaredNorm();
        ++beginning.size;
        if (distance > beginning.distance) {
            beginning.distance = distance;
            beginning.vertex = v;
        }
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const Beginning& a, const Beginning& b) { return a.size > b.size; });
    std::vector<Index> vertices;
    for (const Beginning& beginning : found) vertices.push_back(beginning.vertex);
    return vertices;
}

// The farthest of the vertices that are reached at all. A new sample changes few blocks of vertices, and only
// these are looked through again.
class Farthest {
  public:
    explicit Farthest(const Vector& distance)
        : distance_(distance),
          best_((static_cast<std::size_t>(distance.size()) + block_size - 1) / block_size, -1),
          is_stale_(best_.size(), 1) {}

    void changed(Index v) { is_stale_[static_cast<std::size_t>(v) / block_size] = 1; }

    // The smallest of equally far ones; -1 if none is farther than 0.
    Index find() {
        Index best = -1;
        for (std::size_t block = 0; block < best_.size(); ++block) {
            if (is_stale_[block] != 0) {
                const auto begin = static_cast<Index>(block * block_size);
                best_[block] =
                    farthest(begin, std::min(begin + block_size, static_cast<Index>(distance_.size())));
                is_stale_[block] = 0;
            }
            if (best_[block] >= 0 && (best < 0 || distance_[best_[block]] > distance_[best]))
                best = best_[block];
        }
        return best;
    }

  private:
    static constexpr Index block_size = 256;

    Index farthest(Index begin, Index end) const {
        Index best = -1;
        double greatest = 0;
        for (Index v = begin; v < end; ++v) {
            if (distance_[v] > greatest && distance_[v] < unreached) {
                greatest = distance_[v];
                best = v;
            }
        }
        return best;
    }

    const Vector& distance_;
    std::vector<Index> best_;  // of each block
    std::vector<char> is_stale_;
};

}  // namespace

FarthestPointSamples farthest_point_samples(MeshView mesh, const DistanceGraph& graph,
                                            const FarthestPointOptions& options) {
    require_options(mesh, graph, options);
    const auto n = static_cast<std::size_t>(mesh.n_vertices());
    FarthestPointSamples result{
        {}, std::vector<Index>(n, -1), Vector::Constant(mesh.n_vertices(), unreached), 0};
    const auto count = options.count > 0 ? static_cast<std::size_t>(options.count) : n;
    geodesic::Dijkstra dijkstra(graph);
    Farthest farthest(result.distance_to_sample);
    const auto take = [&](Index base) {
        const auto number = static_cast<Index>(result.vertices.size());
        report_progress(options.progress, static_cast<double>(number) / static_cast<double>(count));
        result.vertices.push_back(base);
        dijkstra.add_source(base);
        for (const Index v : dijkstra.visited()) {
            result.sample_of_vertex[static_cast<std::size_t>(v)] = number;
            result.distance_to_sample[v] = dijkstra.distance(v);
            farthest.changed(v);
        }
    };

    if (options.first >= 0) take(options.first);
    for (const Index beginning : beginnings(mesh))
        if (result.vertices.size() < count && result.distance_to_sample[beginning] == unreached)
            take(beginning);
    Index next = farthest.find();
    while (next >= 0 && result.vertices.size() < count && result.distance_to_sample[next] > options.radius) {
        take(next);
        next = farthest.find();
    }
    if (next >= 0) result.covering_radius = result.distance_to_sample[next];
    report_progress(options.progress, 1);
    return result;
}

}  // namespace counterpart
