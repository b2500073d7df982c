// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/isomorphism/dart_map.hpp"

#include "match/isomorphism/spatial_order.hpp"

#include <counterpart/base/errors.hpp>

#include <algorithm>
#include <span>

#include <fmt/format.h>

namespace counterpart::isomorphism {
namespace {

// Triangles as the steps below go through them: the mesh's own, or renumbered.
struct Corners {
    const Index* vertex;  // at corner 3 t + c
    std::size_t n_triangles, n_vertices;
    bool are_coned;  // edges to middles of polygons are joined by join_spokes
    std::array<Index, 4> around(std::size_t t) const {
        const Index* const v = vertex + 3 * t;
        return {v[0], v[1], v[2], v[0]};
    }
};

class TwinFinder {
  public:
    explicit TwinFinder(const Corners& corners) : twin_(3 * corners.n_triangles, no_dart) {
        collect(corners);
        for (std::size_t v = 0; v < corners.n_vertices; ++v) {
            const std::size_t begin = end_[v], size = end_[v + 1] - begin;
            const bool paired = size <= 8           ? pair_by_comparison<8>(begin, size)
                                : size <= max_small ? pair_by_comparison<max_small>(begin, size)
                                                    : false;
            if (!paired) pair_by_sorting(begin, size);
        }
    }
    std::vector<Dart>& twin() { return twin_; }
    // Two buffers of 3 n_triangles that are not needed any more: fresh memory is what large meshes wait for.
    std::vector<Index> take_indices() { return std::move(other_); }
    std::vector<Dart> take_darts() { return std::move(dart_); }
    Index boundary_edges() const { return boundary_edges_; }
    Index non_manifold_edges() const { return non_manifold_edges_; }

  private:
    static constexpr std::size_t max_small = 16;

    // Half-edges meet in the bucket of their smaller endpoint (a counting sort): bucket v is end_[v] ..
    // end_[v + 1], and there other_ is the larger endpoint. A dart's direction bit says that it comes from
    // there.
    void collect(const Corners& corners) {
        end_.assign(corners.n_vertices + 2, 0);
        const std::size_t n_sides = corners.are_coned ? 1 : 3;
        const auto for_each_halfedge = [&](const auto& body) {
            for (std::size_t t = 0; t < corners.n_triangles; ++t) {
                const std::array<Index, 4> v = corners.around(t);
                for (std::size_t c = 0; c < n_sides; ++c)
                    if (v[c] != v[c + 1])  // a collapsed edge is a border
                        body(v[c], v[c + 1], make_dart(static_cast<Index>(t), static_cast<int>(c)));
            }
        };
        for_each_halfedge([&](Index a, Index b, Dart) { ++end_[to_size(std::min(a, b)) + 2]; });
        for (std::size_t v = 0; v + 1 < end_.size(); ++v) end_[v + 1] += end_[v];
        other_.reserve(twin_.size() + max_small);  // what takes them over needs that much
        dart_.reserve(twin_.size());
        other_.resize(end_.back() + max_small);  // comparisons read whole blocks
        dart_.resize(end_.back());
        for_each_halfedge([&](Index a, Index b, Dart f) {
            const std::uint32_t place = end_[to_size(std::min(a, b)) + 1]++;
            other_[place] = std::max(a, b);
            dart_[place] = f | (a > b ? 1U : 0U);
        });
    }

    // Opposite directions are the rule; equal ones mean that one of the two triangles is wound the other way
    // round, and crossing the edge then changes the direction.
    static Dart joined_to(Dart a, Dart b) { return (b & ~1U) | ((a & 1U) == (b & 1U) ? 1U : 0U); }

    // Nearly all buckets are small and hold each edge once or twice. Comparing all with all then has no
    // branch to predict, which in shuffled meshes costs more than the comparisons. False if an edge is there
    // more often.
    template <std::size_t block>
    bool pair_by_comparison(std::size_t begin, std::size_t size) {
        const Index* const other = other_.data() + begin;
        std::array<Index, block> equal{}, sum{};  // how many are equal to i, and the sum of their numbers
        for (std::size_t j = 0; j < size; ++j) {
            const Index mine = other[j];
            for (std::size_t i = 0; i < block; ++i) {
                const Index same = other[i] == mine ? -1 : 0;
                equal[i] -= same;
                sum[i] += same & static_cast<Index>(j);
            }
        }
        Index boundary = 0, more = 0;
        for (std::size_t i = 0; i < size; ++i) {
            boundary += equal[i] == 1 ? 1 : 0;
            more += equal[i] > 2 ? 1 : 0;
        }
        if (more > 0) return false;
        boundary_edges_ += boundary;
        for (std::size_t i = 0; i < size; ++i) {
            const Dart a = dart_[begin + i];
            const std::size_t j = equal[i] == 2 ? to_size(sum[i]) - i : i;
            const Dart b = dart_[begin + j];
            twin_[halfedge_of(a)] = equal[i] == 2 ? joined_to(a, b) : no_dart;
        }
        return true;
    }

    // A fan of thousands must not cost their square.
    void pair_by_sorting(std::size_t begin, std::size_t size) {
        std::vector<std::pair<Index, Dart>> bucket(size);
        for (std::size_t i = 0; i < size; ++i) bucket[i] = {other_[begin + i], dart_[begin + i]};
        std::sort(bucket.begin(), bucket.end());
        for (std::size_t i = 0, j = 0; i < size; i = j) {
            for (j = i + 1; j < size && bucket[j].first == bucket[i].first;) ++j;
            if (j - i == 1) ++boundary_edges_;
            if (j - i > 2) ++non_manifold_edges_;
            if (j - i != 2) continue;
            const Dart a = bucket[i].second, b = bucket[i + 1].second;
            twin_[halfedge_of(a)] = joined_to(a, b);
            twin_[halfedge_of(b)] = joined_to(b, a);
        }
    }

    std::vector<Dart> twin_;
    std::vector<std::uint32_t> end_;
    std::vector<Index> other_;
    std::vector<Dart> dart_;
    Index boundary_edges_ = 0, non_manifold_edges_ = 0;
};

// The edges between the corners of polygons and their middles: the triangles of two corners that follow one
// another meet there, however often the polygon comes to one vertex. `place` is where triangles went; empty
// if they stayed.
void join_spokes(TrianglesView coned, const std::vector<Index>& place, std::vector<Dart>& twin) {
    const auto dart_at = [&](Eigen::Index j, int corner) {
        const auto t = static_cast<Index>(j);
        return make_dart(place.empty() ? t : place[to_size(t)], corner);
    };
    for (Eigen::Index j = 0, first = 0; j < coned.rows(); ++j) {
        const bool is_last = j + 1 == coned.rows() || coned(j + 1, 2) != coned(j, 2);
        const Dart here = dart_at(j, 2), there = dart_at(is_last ? first : j + 1, 1);
        twin[halfedge_of(here)] = there;
        twin[halfedge_of(there)] = here;
        if (is_last) first = j + 1;
    }
}

// Renumbers along breadth-first traversals. The queue is known some steps ahead, so what a step will touch is
// fetched early: on a shuffled mesh nearly every access misses the caches. Whether a neighbor is new cannot
// be predicted, so both cases take the same steps and write to the place behind the last.
class Renumbering {
  public:
    Renumbering(const Corners& corners, const std::vector<Dart>& twin, DartMap& map)
        : corners_(corners),
          twin_(twin.data()),
          local_triangle_(corners.n_triangles + 1, -1),
          local_vertex_(corners.n_vertices, -1) {
        local_triangle_.back() = 0;  // what is beyond a border is never new
        map.input_triangle.resize(corners.n_triangles + 1);
        map.input_vertex.resize(corners.n_vertices + 1);
        map.twin.resize(3 * corners.n_triangles);
        map.corner.resize(3 * corners.n_triangles);
        for (std::size_t seed = 0; seed < corners.n_triangles; ++seed) {
            if (local_triangle_[seed] >= 0) continue;
            map.component_begin.push_back(static_cast<Index>(n_triangles_));
            visit_component(seed, map);
        }
        map.component_begin.push_back(static_cast<Index>(n_triangles_));
        map.input_triangle.resize(n_triangles_);
        map.input_vertex.resize(n_vertices_);
        for (std::size_t v = 0; v < corners.n_vertices; ++v)
            if (local_vertex_[v] < 0) map.isolated.push_back(static_cast<Index>(v));
    }

  private:
    void visit_component(std::size_t seed, DartMap& map) {
        Index* const order = map.input_triangle.data();
        Index* const vertices = map.input_vertex.data();
        std::size_t done = n_triangles_;
        local_triangle_[seed] = static_cast<Index>(n_triangles_);
        order[n_triangles_++] = static_cast<Index>(seed);
        for (; done < n_triangles_; ++done) {
            fetch(order, done);
            const auto t = to_size(order[done]);
            for (std::size_t c = 0; c < 3; ++c) {
                const Dart f = twin_[3 * t + c];
                const std::size_t there = f == no_dart ? corners_.n_triangles : f >> 3U;
                Index& triangle = local_triangle_[there];
                const bool is_new = triangle < 0;
                triangle = is_new ? static_cast<Index>(n_triangles_) : triangle;
                order[n_triangles_] = static_cast<Index>(there);
                n_triangles_ += is_new ? 1 : 0;
                map.twin[3 * done + c] =
                    f == no_dart ? no_dart : (static_cast<Dart>(triangle) << 3U) | (f & 7U);

                const Index v = corners_.vertex[3 * t + c];
                Index& vertex = local_vertex_[to_size(v)];
                const bool is_new_vertex = vertex < 0;
                vertex = is_new_vertex ? static_cast<Index>(n_vertices_) : vertex;
                vertices[n_vertices_] = v;
                n_vertices_ += is_new_vertex ? 1 : 0;
                map.corner[3 * done + c] = vertex;
            }
        }
    }

    // First the triangle, then what it points to.
    void fetch(const Index* order, std::size_t done) const {
        constexpr std::size_t ahead = 8;
        if (done + 2 * ahead < n_triangles_) {
            const auto t = to_size(order[done + 2 * ahead]);
            __builtin_prefetch(&twin_[3 * t]);
            __builtin_prefetch(&corners_.vertex[3 * t]);
        }
        if (done + ahead >= n_triangles_) return;
        const auto t = to_size(order[done + ahead]);
        for (std::size_t c = 0; c < 3; ++c) {
            const Dart f = twin_[3 * t + c];
            if (f != no_dart) __builtin_prefetch(&local_triangle_[f >> 3U]);
            __builtin_prefetch(&local_vertex_[to_size(corners_.vertex[3 * t + c])]);
        }
    }

    const Corners& corners_;
    const Dart* twin_;
    std::vector<Index> local_triangle_, local_vertex_;
    std::size_t n_triangles_ = 0, n_vertices_ = 0;
};

void name_by_input(const SpatialOrder& order, DartMap& map) {
    for (Index& t : map.input_triangle) t = order.input_triangle[to_size(t)];
    for (Index& v : map.input_vertex) v = order.input_vertex[to_size(v)];
    for (Index& v : map.isolated) v = order.input_vertex[to_size(v)];
    std::sort(map.isolated.begin(), map.isolated.end());
}

// Only where some edge is run along twice in one direction.
void orient_components(DartMap& map) {
    if (std::all_of(map.twin.begin(), map.twin.end(), [](Dart f) { return f == no_dart || (f & 1U) == 0; }))
        return;
    map.flipped.assign(map.input_triangle.size(), 2);
    map.one_sided.assign(to_size(map.n_components()), 0);
    for (Index component = 0; component < map.n_components(); ++component) {
        const Index begin = map.component_begin[to_size(component)];
        std::vector<Index> queue{begin};
        map.flipped[to_size(begin)] = 0;
        std::size_t against = 0;
        for (std::size_t k = 0; k < queue.size(); ++k) {
            const unsigned here = map.flipped[to_size(queue[k])];
            against += here;
            for (int c = 0; c < 3; ++c) {
                const Dart f = map.across(make_dart(queue[k], c, here));
                if (f == no_dart) continue;
                const unsigned there = map.flipped[to_size(f >> 3U)];
                if (there != 2) {
                    if (there != direction_of(f)) map.one_sided[to_size(component)] = 1;
                    continue;
                }
                map.flipped[to_size(f >> 3U)] = static_cast<std::uint8_t>(direction_of(f));
                queue.push_back(triangle_of(f));
            }
        }
        if (2 * against > queue.size())
            for (const Index t : queue) map.flipped[to_size(t)] ^= 1U;
    }
}

Index count_non_manifold_vertices(const DartMap& map) {
    std::vector<Index> component_of(map.input_vertex.size(), -1);
    Index count = 0;
    for (Index i = 0; i < map.n_components(); ++i) {
        for (std::size_t h = 3 * to_size(map.component_begin[to_size(i)]);
             h < 3 * to_size(map.component_begin[to_size(i) + 1]); ++h) {
            Index& seen = component_of[to_size(map.corner[h])];
            if (seen >= 0 && seen != i) {
                ++count;
                seen = -2;  // counted
            } else if (seen == -1) {
                seen = i;
            }
        }
    }
    return count;
}

}  // namespace

DartMap make_dart_map(MeshView mesh, Index first_center) {
    constexpr Index most = (1 << 28) - 1;
    if (mesh.n_triangles() > most) {
        throw InvalidInput(fmt::format("the mesh has {} triangles; exact matching handles at most {}",
                                       mesh.n_triangles(), most));
    }
    // Meshes that the last cache holds gain nothing from a better order.
    constexpr Index cached = 1 << 20;
    const bool reorder = mesh.n_triangles() > cached;
    const SpatialOrder order = reorder ? make_spatial_order(mesh) : SpatialOrder{};
    const Corners corners{reorder ? order.corner.data() : mesh.triangles.data(), to_size(mesh.n_triangles()),
                          to_size(mesh.n_vertices()), first_center != no_center};
    DartMap map;
    map.first_center = first_center;
    TwinFinder twins(corners);
    if (corners.are_coned) {
        std::vector<Index> place(order.input_triangle.size());
        for (std::size_t t = 0; t < place.size(); ++t)
            place[to_size(order.input_triangle[t])] = static_cast<Index>(t);
        join_spokes(mesh.triangles, place, twins.twin());
    }
    map.corner = twins.take_indices();
    map.twin = twins.take_darts();
    map.boundary_edges = twins.boundary_edges();
    map.non_manifold_edges = twins.non_manifold_edges();
    const Renumbering renumbering(corners, twins.twin(), map);
    if (reorder) name_by_input(order, map);
    orient_components(map);
    map.non_manifold_vertices = map.n_components() > 1 ? count_non_manifold_vertices(map) : 0;
    return map;
}

}  // namespace counterpart::isomorphism
