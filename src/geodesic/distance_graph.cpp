// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// M. Hilaga, Y. Shinagawa, T. Kohmura, T. L. Kunii, "Topology matching for fully automatic similarity
// estimation of 3D shapes", SIGGRAPH 2001, section 4.1: short-cut edges.
#include "numerics/morton_order.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/geodesic/distances.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <Eigen/Geometry>
#include <fmt/format.h>

namespace counterpart {
namespace {

void require_measurable(MeshView mesh) {
    require_valid(mesh);
    const double spread =
        (mesh.vertices.colwise().maxCoeff() - mesh.vertices.colwise().minCoeff()).maxCoeff();
    if (spread > 1e150 || (spread > 0 && spread < 1e-150)) {
        throw InvalidInput(
            fmt::format("distances cannot be measured on a mesh of extent {}: rescale it first", spread));
    }
}

// A triangle at an edge that starts at its smaller rank: the far end of the edge, and the third vertex.
struct EdgeSide {
    Index far = 0, apex = 0;
    auto operator<=>(const EdgeSide&) const = default;
};

// The sides of all edges, by the smaller rank of the edge, then by the far end.
struct EdgeSides {
    std::vector<Index> first;
    std::vector<EdgeSide> sides;
};

EdgeSides edge_sides(MeshView mesh, const std::vector<Index>& rank) {
    const auto rank_of = [&](Index t, int corner) {
        return rank[static_cast<std::size_t>(mesh.triangles(t, corner % 3))];
    };
    EdgeSides result{std::vector<Index>(rank.size() + 1, 0), {}};
    const auto for_each_side = [&](const auto& use) {
        for (Index t = 0; t < mesh.n_triangles(); ++t) {
            for (int c = 0; c < 3; ++c) {
                const Index a = rank_of(t, c), b = rank_of(t, c + 1);
                if (a != b) use(std::min(a, b), EdgeSide{std::max(a, b), rank_of(t, c + 2)});
            }
        }
    };
    for_each_side([&](Index near, const EdgeSide&) { ++result.first[static_cast<std::size_t>(near) + 1]; });
    for (std::size_t r = 0; r < rank.size(); ++r) result.first[r + 1] += result.first[r];
    result.sides.resize(static_cast<std::size_t>(result.first.back()));
    std::vector<Index> next(result.first.begin(), result.first.end() - 1);
    for_each_side([&](Index near, const EdgeSide& side) {
        result.sides[static_cast<std::size_t>(next[static_cast<std::size_t>(near)]++)] = side;
    });
    for (std::size_t r = 0; r < rank.size(); ++r)
        std::sort(result.sides.begin() + result.first[r], result.sides.begin() + result.first[r + 1]);
    return result;
}

// The common edge of two triangles laid along the x axis from the origin, and where a third vertex then lies.
class Unfolding {
  public:
    Unfolding(const Eigen::Vector3d& a, const Eigen::Vector3d& b) : origin_(a), axis_(b - a) {
        length_ = axis_.norm();
        if (length_ > 0) axis_ /= length_;
    }
    double length() const { return length_; }
    double height(const Eigen::Vector3d& p) const { return place(p).second; }

    // Straight distance between apexes on both sides, if the line between them crosses the edge inside.
    std::optional<double> shortcut(const Eigen::Vector3d& c, const Eigen::Vector3d& d) const {
        const auto [xc, yc] = place(c);
        const auto [xd, yd] = place(d);
        if (!(yc + yd > 0)) return std::nullopt;
        const double crossing = xc + (xd - xc) * yc / (yc + yd);
        if (!(crossing > 0 && crossing < length_)) return std::nullopt;
        return std::sqrt((xc - xd) * (xc - xd) + (yc + yd) * (yc + yd));
    }

  private:
    std::pair<double, double> place(const Eigen::Vector3d& p) const {
        const Eigen::Vector3d offset = p - origin_;
        return {offset.dot(axis_), offset.cross(axis_).norm()};
    }
    Eigen::Vector3d origin_, axis_;
    double length_ = 0;
};

// Every two triangles at an edge are unfolded while they are few. At an edge of more than `most_in_pairs`,
// which would take quadratically many links, only the pairs with one of `n_hubs` apexes are: those nearest to
// the edge. Two others reach each other over a hub or over an end of the edge. Both are ways on the surface,
// so that no distance gets shorter than it is; it gets longer by at most twice the way from where the
// straight line crosses the edge to the hub or the end. Edges of meshes in use have two triangles, faulty
// ones three or four, which leaves them all as they were; below 16, all pairs take no more links than 8 for
// each triangle.
constexpr std::size_t most_in_pairs = 16, n_hubs = 8;

// Puts the hubs in front, each apex once, and returns how many they are: all if the edge is an ordinary one.
template <class Position>
std::size_t sort_hubs_first(std::vector<Index>& apexes, const Unfolding& unfolding,
                            const Position& position) {
    if (apexes.size() <= most_in_pairs) return apexes.size();
    apexes.erase(std::unique(apexes.begin(), apexes.end()), apexes.end());  // they come sorted
    if (apexes.size() <= most_in_pairs) return apexes.size();
    std::vector<std::pair<double, Index>> by_height;
    for (const Index apex : apexes) by_height.emplace_back(unfolding.height(position(apex)), apex);
    std::nth_element(by_height.begin(), by_height.begin() + n_hubs, by_height.end());
    std::sort(by_height.begin(), by_height.begin() + n_hubs);
    for (std::size_t i = 0; i < apexes.size(); ++i) apexes[i] = by_height[i].second;
    return n_hubs;
}

}  // namespace

DistanceGraph::DistanceGraph(MeshView mesh, const DistanceGraphOptions& options) {
    require_measurable(mesh);
    vertex_of_rank_ = numerics::space_filling_order(mesh.vertices);
    rank_of_vertex_.resize(vertex_of_rank_.size());
    for (std::size_t r = 0; r < vertex_of_rank_.size(); ++r)
        rank_of_vertex_[static_cast<std::size_t>(vertex_of_rank_[r])] = static_cast<Index>(r);
    const auto position = [&](Index rank) -> Eigen::Vector3d {
        return mesh.vertices.row(vertex_of_rank_[static_cast<std::size_t>(rank)]);
    };

    const EdgeSides sides = edge_sides(mesh, rank_of_vertex_);
    std::vector<Index> apexes;
    std::vector<UndirectedLink> links;
    links.reserve(sides.sides.size());  // on a closed mesh: half the sides are edges, each with one shortcut
    for (Index a = 0; a < mesh.n_vertices(); ++a) {
        const auto row_end = sides.sides.begin() + sides.first[static_cast<std::size_t>(a) + 1];
        for (auto edge = sides.sides.begin() + sides.first[static_cast<std::size_t>(a)]; edge != row_end;) {
            const auto edge_end =
                std::find_if(edge, row_end, [&](const EdgeSide& s) { return s.far != edge->far; });
            const Unfolding unfolding(position(a), position(edge->far));
            links.push_back({a, edge->far, unfolding.length()});
            apexes.clear();
            for (; edge != edge_end; ++edge) apexes.push_back(edge->apex);
            if (!options.shortcuts) continue;
            const std::size_t count = sort_hubs_first(apexes, unfolding, position);
            for (std::size_t c = 0; c < count; ++c) {
                for (std::size_t d = c + 1; d < apexes.size(); ++d) {
                    if (apexes[c] == apexes[d]) continue;
                    if (const auto length = unfolding.shortcut(position(apexes[c]), position(apexes[d])))
                        links.push_back({apexes[c], apexes[d], *length});
                }
            }
        }
    }
    fill_rows(links);
    choose_buckets();
}

void DistanceGraph::fill_rows(const std::vector<UndirectedLink>& links) {
    if (links.size() > static_cast<std::size_t>(std::numeric_limits<Index>::max()) / 2)
        throw InvalidInput("the mesh has too many edges for a distance graph: decimate it first");
    const std::size_t n = vertex_of_rank_.size();
    first_.assign(n + 1, 0);
    for (const UndirectedLink& link : links) {
        ++first_[static_cast<std::size_t>(link.a) + 1];
        ++first_[static_cast<std::size_t>(link.b) + 1];
    }
    for (std::size_t r = 0; r < n; ++r) first_[r + 1] += first_[r];
    to_.resize(2 * links.size());
    length_.resize(2 * links.size());
    std::vector<Index> next(first_.begin(), first_.end() - 1);
    const auto add = [&](Index from, Index to, double length) {
        const auto place = static_cast<std::size_t>(next[static_cast<std::size_t>(from)]++);
        to_[place] = to;
        length_[place] = length;
    };
    for (const UndirectedLink& link : links) {
        add(link.a, link.b, link.length);
        add(link.b, link.a, link.length);
    }
}

// A bucket half as wide as a short link holds few vertices that improve each other, so their order in it
// hardly matters. Where link lengths differ so much that this would take too many buckets, each is kept as a
// heap.
void DistanceGraph::choose_buckets() {
    constexpr std::size_t most_buckets = 1 << 14, sample_size = 4096;
    std::vector<double> sample;
    const std::size_t stride = length_.size() / sample_size + 1;
    for (std::size_t i = 0; i < length_.size(); i += stride) sample.push_back(length_[i]);
    if (sample.empty()) return;
    const auto low = sample.begin() + static_cast<std::ptrdiff_t>(sample.size() / 20);
    std::nth_element(sample.begin(), low, sample.end());
    const double longest = *std::max_element(length_.begin(), length_.end());
    const double wanted = *low / 2, least = longest / (most_buckets - 2);
    ordered_buckets_ = wanted < least;
    const double width = std::max(wanted, least);
    if (!(width > 0)) return;  // all links have length 0: one bucket does
    inverse_bucket_width_ = 1 / width;
    while (static_cast<double>(n_buckets_) < longest / width + 2) n_buckets_ *= 2;
}

std::vector<DistanceGraph::Link> DistanceGraph::links(Index vertex) const {
    const auto rank = static_cast<std::size_t>(rank_of_vertex_[static_cast<std::size_t>(vertex)]);
    std::vector<Link> result;
    for (auto i = static_cast<std::size_t>(first_[rank]); i < static_cast<std::size_t>(first_[rank + 1]); ++i)
        result.push_back({vertex_of_rank_[static_cast<std::size_t>(to_[i])], length_[i]});
    std::sort(result.begin(), result.end());
    return result;
}

}  // namespace counterpart
