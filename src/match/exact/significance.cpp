// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/exact/significance.hpp"

#include "mesh/disjoint_sets.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace counterpart {
namespace {

std::size_t place(Index i) { return static_cast<std::size_t>(i); }

// One mesh of the two: how many triangles each vertex has, and how many of them are matched.
struct Side {
    const TriangleMesh& mesh;
    std::vector<bool> is_matched;  // triangles
    std::vector<Index> valence, matched;

    Side(const TriangleMesh& m, std::vector<bool> matched_triangles)
        : mesh(m),
          is_matched(std::move(matched_triangles)),
          valence(place(m.n_vertices()), 0),
          matched(place(m.n_vertices()), 0) {
        for (Index t = 0; t < mesh.n_triangles(); ++t) {
            for (int c = 0; c < 3; ++c) {
                ++valence[place(mesh.triangles(t, c))];
                matched[place(mesh.triangles(t, c))] += is_matched[place(t)] ? 1 : 0;
            }
        }
    }

    // Of the triangles within two rings, those nearer by weighing more.
    std::vector<double> matched_share() const {
        std::vector<double> all(valence.begin(), valence.end()), some(matched.begin(), matched.end());
        for (int ring = 0; ring < 2; ++ring) {
            all = with_neighbors(all);
            some = with_neighbors(some);
        }
        for (std::size_t v = 0; v < all.size(); ++v) some[v] = all[v] > 0 ? some[v] / all[v] : 0;
        return some;
    }

    // -log2 of the frequency of each vertex's valence; the commonest valence says nothing, because growing
    // goes on for as long as it meets it.
    std::vector<double> information() const {
        std::map<Index, double> count;
        for (const Index k : valence) count[k] += 1;
        double most = 0;
        for (const auto& [k, n] : count) most = std::max(most, n);
        std::vector<double> bits(valence.size());
        for (std::size_t v = 0; v < bits.size(); ++v)
            bits[v] = count[valence[v]] == most
                          ? 0
                          : std::log2(static_cast<double>(valence.size()) / count[valence[v]]);
        return bits;
    }

  private:
    std::vector<double> with_neighbors(const std::vector<double>& values) const {
        std::vector<double> sums = values;
        for (Index t = 0; t < mesh.n_triangles(); ++t)
            for (int c = 0; c < 3; ++c)
                sums[place(mesh.triangles(t, c))] += values[place(mesh.triangles(t, (c + 1) % 3))] +
                                                     values[place(mesh.triangles(t, (c + 2) % 3))];
        return sums;
    }
};

class Significance {
  public:
    Significance(const TriangleMesh& source, const TriangleMesh& target, const VertexMap& map,
                 const std::vector<Index>& partner)
        : a_(source, matched_in_source(partner)),
          b_(target, matched_in_target(partner, target.n_triangles())),
          map_(map) {}

    std::vector<bool> kept(const std::vector<bool>& known) const {
        std::vector<bool> keep = significant(core());
        for (Index t = 0; t < a_.mesh.n_triangles(); ++t)
            for (int c = 0; c < 3 && known[place(t)]; ++c) keep[place(a_.mesh.triangles(t, c))] = true;
        for (int ring = 0; ring < 3; ++ring) keep = with_matched_neighbors(keep);
        return keep;
    }

  private:
    static std::vector<bool> matched_in_source(const std::vector<Index>& partner) {
        std::vector<bool> is_matched(partner.size());
        for (std::size_t t = 0; t < partner.size(); ++t) is_matched[t] = partner[t] >= 0;
        return is_matched;
    }
    static std::vector<bool> matched_in_target(const std::vector<Index>& partner, Index n) {
        std::vector<bool> is_matched(place(n), false);
        for (const Index u : partner)
            if (u >= 0) is_matched[place(u)] = true;
        return is_matched;
    }

    // A side may lack a part, but by chance both have misfits.
    std::vector<bool> core() const {
        constexpr double least_share = 0.75;
        const std::vector<double> share_a = a_.matched_share(), share_b = b_.matched_share();
        std::vector<bool> core(share_a.size(), false);
        for (std::size_t v = 0; v < core.size(); ++v) {
            const Index w = map_.image[v];
            core[v] = w >= 0 && std::max(share_a[v], share_b[place(w)]) >= least_share;
        }
        return core;
    }

    std::vector<bool> significant(std::vector<bool> core) const {
        const std::vector<double> information = b_.information();
        DisjointSets regions(a_.mesh.n_vertices());
        for_each_matched([&](Index, const std::array<Index, 3>& v) {
            for (std::size_t c = 0; c < 3; ++c)
                if (core[place(v[c])] && core[place(v[(c + 1) % 3])]) regions.join(v[c], v[(c + 1) % 3]);
        });
        std::vector<double> bits(core.size(), 0), triangles(core.size(), 0);
        for (std::size_t v = 0; v < core.size(); ++v) {
            if (!core[v]) continue;
            const auto w = place(map_.image[v]);
            const bool is_whole = a_.matched[v] == a_.valence[v] && b_.matched[w] == b_.valence[w] &&
                                  a_.valence[v] == b_.valence[w];
            if (is_whole) bits[place(regions.root(static_cast<Index>(v)))] += information[w];
        }
        for_each_matched([&](Index, const std::array<Index, 3>& v) {
            if (core[place(v[0])]) triangles[place(regions.root(v[0]))] += 1;
        });
        const auto n_a = static_cast<double>(a_.mesh.n_triangles()),
                   n_b = static_cast<double>(b_.mesh.n_triangles());
        const double needed = std::log2(3 * n_a * 6 * n_b) + 10;
        for (std::size_t v = 0; v < core.size(); ++v) {
            if (!core[v]) continue;
            const auto root = place(regions.root(static_cast<Index>(v)));
            core[v] = bits[root] >= needed || 2 * triangles[root] >= std::min(n_a, n_b);
        }
        return core;
    }

    std::vector<bool> with_matched_neighbors(const std::vector<bool>& keep) const {
        std::vector<bool> more = keep;
        for_each_matched([&](Index, const std::array<Index, 3>& v) {
            if (keep[place(v[0])] || keep[place(v[1])] || keep[place(v[2])])
                for (const Index w : v) more[place(w)] = true;
        });
        return more;
    }

    template <class Body>
    void for_each_matched(const Body& body) const {
        for (Index t = 0; t < a_.mesh.n_triangles(); ++t)
            if (a_.is_matched[place(t)])
                body(t, {a_.mesh.triangles(t, 0), a_.mesh.triangles(t, 1), a_.mesh.triangles(t, 2)});
    }

    Side a_, b_;
    const VertexMap& map_;
};

}  // namespace

VertexMap without_chance(const TriangleMesh& source, const TriangleMesh& target, const VertexMap& map,
                         const std::vector<Index>& partner, const std::vector<bool>& known) {
    const std::vector<bool> keep = Significance(source, target, map, partner).kept(known);
    VertexMap result = map;
    for (std::size_t v = 0; v < keep.size(); ++v)
        if (!keep[v]) result.image[v] = VertexMap::unmatched;
    return result;
}

}  // namespace counterpart
