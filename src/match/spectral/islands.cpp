// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/islands.hpp"

#include <algorithm>

namespace counterpart::spectral_match {
namespace {

// Parts of the surface between which every edge is torn.
struct Parts {
    std::vector<Index> of_vertex;
    std::vector<double> area;
    std::vector<char> has_tear;
};

template <class IsTorn>
Parts parts_between_tears(const Adjacency& adjacency, const Vector& mass, const IsTorn& is_torn) {
    Parts parts{std::vector<Index>(at(adjacency.n_vertices()), -1), {}, {}};
    std::vector<Index> open;
    for (Index first = 0; first < adjacency.n_vertices(); ++first) {
        if (parts.of_vertex[at(first)] >= 0) continue;
        const auto part = static_cast<Index>(parts.area.size());
        parts.area.push_back(0);
        parts.has_tear.push_back(0);
        parts.of_vertex[at(first)] = part;
        for (open.push_back(first); !open.empty();) {
            const Index v = open.back();
            open.pop_back();
            parts.area.back() += mass[v];
            for (const Index w : adjacency.neighbors(v)) {
                if (is_torn(v, w)) {
                    parts.has_tear.back() = 1;
                } else if (parts.of_vertex[at(w)] < 0) {
                    parts.of_vertex[at(w)] = part;
                    open.push_back(w);
                }
            }
        }
    }
    return parts;
}

// How much longer edges of A get under a map.
class Growth {
  public:
    Growth(const PreparedShape& a, const PreparedShape& b, const std::vector<Index>& b_from_a)
        : before_(a.mesh.vertices), after_(b.mesh.vertices(b_from_a, Eigen::all)) {}

    double before(Index v, Index w) const { return (before_.row(v) - before_.row(w)).norm(); }
    double after(Index v, Index w) const { return (after_.row(v) - after_.row(w)).norm(); }

    // Of each vertex the median factor of the edges at its neighbors, 1 to `most`. A neighbor with very many
    // edges, most of them far away, says nothing, and would take their number squared.
    std::vector<double> usual(const Adjacency& adjacency, double most) const {
        std::vector<double> result(at(adjacency.n_vertices()), 1), factors;
        for (Index v = 0; v < adjacency.n_vertices(); ++v) {
            factors.clear();
            for (const Index w : adjacency.neighbors(v)) {
                if (adjacency.neighbors(w).size() > most_edges) continue;
                for (const Index u : adjacency.neighbors(w))
                    if (before(w, u) > 0) factors.push_back(after(w, u) / before(w, u));
            }
            if (factors.empty()) continue;
            const auto middle = factors.begin() + static_cast<std::ptrdiff_t>((factors.size() - 1) / 2);
            std::nth_element(factors.begin(), middle, factors.end());
            result[at(v)] = std::clamp(*middle, 1.0, most);
        }
        return result;
    }

  private:
    static constexpr std::size_t most_edges = 64;  // of a neighbor

    const Points& before_;
    const Points after_;
};

}  // namespace

Islands find_islands(const LevelShape& from, const LevelShape& to, const std::vector<Index>& b_from_a,
                     const IslandTuning& tuning) {
    const PreparedShape& a = from.shape;
    const Adjacency& adjacency = from.neighbors;
    const Growth growth(a, to.shape, b_from_a);
    const std::vector<double> usual = growth.usual(adjacency, tuning.most_growth);
    const auto is_torn = [&](Index v, Index w) {
        const double expected = (usual[at(v)] + usual[at(w)]) / 2 * growth.before(v, w);
        return growth.after(v, w) > expected + tuning.gap ||
               to.along(b_from_a[at(v)], b_from_a[at(w)]) > expected + tuning.jump;
    };
    const Parts parts = parts_between_tears(adjacency, a.basis.mass, is_torn);
    const double most = tuning.max_share * a.basis.mass.sum();
    Islands islands{std::vector<char>(at(a.mesh.n_vertices()), 0), {}, true};
    for (std::size_t v = 0; v < islands.inside.size(); ++v) {
        const auto part = static_cast<std::size_t>(parts.of_vertex[v]);
        islands.inside[v] = parts.has_tear[part] != 0 && parts.area[part] <= most ? 1 : 0;
        islands.empty = islands.empty && islands.inside[v] == 0;
    }
    islands.spoiled = islands.inside;
    for (Index v = 0; v < a.mesh.n_vertices(); ++v)
        if (islands.inside[at(v)] != 0)
            for (const Index w : adjacency.neighbors(v)) islands.spoiled[at(w)] = 1;
    return islands;
}

}  // namespace counterpart::spectral_match
