// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/diagonals/diagonals.hpp"

#include "match/diagonals/walk.hpp"
#include "match/diagonals/with_quads.hpp"
#include "match/isomorphism/traversal.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace counterpart::diagonals {

using namespace isomorphism;

namespace {

// Whether more than half of the vertices have a partner of the same color, valences two edges around.
bool is_edit(const DartMap& a, const DartMap& b) {
    std::vector<Color> ours = vertex_colors(a, 2), theirs = vertex_colors(b, 2), common;
    std::sort(ours.begin(), ours.end());
    std::sort(theirs.begin(), theirs.end());
    std::set_intersection(ours.begin(), ours.end(), theirs.begin(), theirs.end(), std::back_inserter(common));
    return 2 * common.size() > ours.size();
}

class Search {
  public:
    Search(const Side& source, const Side& target, const Progress& progress)
        : a_(source), b_(target), walk_(source, target), progress_(progress) {}

    std::optional<std::vector<CutQuad>> run(unsigned parity) {
        std::vector<CutQuad> quads;
        std::vector<char> taken(to_size(b_.map.n_components()), 0);
        for (Index i = 0; i < a_.map.n_components(); ++i) {
            if (!match_component(i, parity, taken)) return std::nullopt;
            const std::vector<CutQuad> found = walk_.take_quads();
            quads.insert(quads.end(), found.begin(), found.end());
            report_progress(progress_, static_cast<double>(i + 1) / a_.map.n_components());
        }
        return quads;
    }

    /// Triangles of the walk that got farthest.
    std::size_t farthest() const { return farthest_; }

  private:
    struct Start {
        Dart f, g;
        Index component;  // of the target
        double mismatch = 0, offset = 0;
    };

    bool match_component(Index component, unsigned parity, std::vector<char>& taken) {
        for (const Dart f : roots(component)) {
            std::vector<Start> starts;
            for (Index j = 0; j < b_.map.n_components(); ++j)
                if (!taken[to_size(j)] && b_.map.component_size(j) == a_.map.component_size(component))
                    collect_starts(f, j, parity, starts);
            if (const Start* best = best_of(starts)) {
                taken[to_size(best->component)] = 1;
                walk_.run(best->f, best->g, whole());
                return true;
            }
        }
        return false;
    }

    // A border's dart; or those of the triangle at the sharpest edge, of which at most one is a diagonal.
    std::vector<Dart> roots(Index component) const {
        const Index begin = a_.map.component_begin[to_size(component)];
        Dart sharpest = make_dart(begin, 0);
        double least = 2;
        for (Index t = begin; t < begin + a_.map.component_size(component); ++t) {
            for (int c = 0; c < 3; ++c) {
                const Dart f = make_dart(t, c, a_.map.parity(make_dart(t, c)));
                if (a_.map.across(f) == no_dart) return {f};
                const double cosine = a_.normal(t).dot(a_.normal(triangle_of(a_.map.across(f)))) *
                                      (direction_of(a_.map.across(f)) == direction_of(f) ? 1 : -1);
                if (cosine < least) {
                    least = cosine;
                    sharpest = f;
                }
            }
        }
        return {sharpest, next(sharpest, 1), next(sharpest, 2)};
    }

    void collect_starts(Dart f, Index component, unsigned parity, std::vector<Start>& starts) const {
        const bool is_border = a_.map.across(f) == no_dart;
        const Index begin = b_.map.component_begin[to_size(component)];
        for (Index t = begin; t < begin + b_.map.component_size(component); ++t) {
            for (int c = 0; c < 3; ++c) {
                const Dart g = make_dart(t, c, b_.map.parity(make_dart(t, c)) ^ parity);
                if ((b_.map.across(g) == no_dart) == is_border) starts.push_back({f, g, component});
            }
        }
    }

    // A few steps from all of them; then more from those that fit best, of which as many stay as time allows:
    // where a mesh is flat or regular, wrong ones fit as well for long. Few are left for the whole way.
    // Of the complete ones that of least mismatch; among equals the one that lies closest.
    const Start* best_of(std::vector<Start>& starts) {
        constexpr std::size_t first_steps = 12, growth = 4, share = 8, max_complete = 16;
        const std::size_t most_steps = 50'000 + 10 * whole();  // of all, each time
        for (std::size_t n_steps = first_steps; starts.size() > max_complete; n_steps *= growth) {
            const bool is_last = n_steps >= whole();
            std::erase_if(starts, [&](Start& start) { return !goes(start, std::min(n_steps, whole())); });
            sort_by_fit(starts);
            const std::size_t affordable = most_steps / (growth * n_steps),
                              fewer = is_last ? max_complete
                                              : std::max({starts.size() / share, max_complete, affordable});
            if (starts.size() > fewer) starts.resize(fewer);
        }
        sort_by_fit(starts);
        const Start* best = nullptr;
        for (Start& start : starts) {
            if (best != nullptr && start.mismatch > growth * best->mismatch + rounding) break;
            if (goes(start, whole() + 1) && walk_.n_triangles() >= to_size(size_of(start)) &&
                (best == nullptr || is_better(start, *best)))
                best = &start;
        }
        return best;
    }

    bool goes(Start& start, std::size_t n_steps) {
        progress_check();
        const WalkEnd end = walk_.run(start.f, start.g, n_steps);
        farthest_ = std::max(farthest_, walk_.n_triangles());
        start.mismatch = walk_.mean_mismatch();
        start.offset = walk_.mean_squared_offset();
        return end != WalkEnd::contradiction;
    }

    static void sort_by_fit(std::vector<Start>& starts) {
        std::stable_sort(starts.begin(), starts.end(), [&](const Start& p, const Start& q) {
            return std::pair(std::llround(p.mismatch / 1e-6), p.offset) <
                   std::pair(std::llround(q.mismatch / 1e-6), q.offset);
        });
    }
    static bool is_better(const Start& p, const Start& q) {
        if (std::abs(p.mismatch - q.mismatch) > 0.01 * std::min(p.mismatch, q.mismatch) + rounding)
            return p.mismatch < q.mismatch;
        return p.offset < q.offset;
    }

    Index size_of(const Start& start) const { return b_.map.component_size(start.component); }
    std::size_t whole() const { return to_size(a_.map.n_triangles()) + 1; }
    void progress_check() {
        if (++n_walks_ % 4096 == 0) report_progress(progress_, 0);
    }

    static constexpr double rounding = 1e-12;
    const Side& a_;
    const Side& b_;
    Walk walk_;
    const Progress& progress_;
    std::size_t farthest_ = 0, n_walks_ = 0;
};

}  // namespace

RecutSearch find_recut_quads(MeshView source, MeshView target, const Progress& progress) {
    if (source.n_triangles() != target.n_triangles()) return {};
    Side a(source), b(target);
    if (a.map.n_vertices() != b.map.n_vertices() || a.map.n_components() != b.map.n_components() ||
        a.map.boundary_edges != b.map.boundary_edges)
        return {};
    if (!a.is_manifold() || !b.is_manifold())
        return {{}, "other diagonals of quads are not looked for, as the meshes are not manifold"};
    // A single quad that is bent far or not convex stops all walks of convex ones.
    constexpr std::array<std::pair<Quads, unsigned>, 4> readings{
        {{Quads::convex, 0}, {Quads::convex, 1}, {Quads::any, 0}, {Quads::any, 1}}};
    const bool have_polygons = source.polygons != nullptr || target.polygons != nullptr;
    if (!have_polygons && is_edit(a.map, b.map)) return {};
    std::size_t farthest = 0;
    for (const auto& [quads_sought, parity] : readings) {
        // Between unlike meshes every walk ends early: another search would be in vain.
        constexpr std::size_t least_part = 8;
        const bool is_near = least_part * farthest >= to_size(a.map.n_triangles());
        if (quads_sought == Quads::any && (have_polygons || !is_near)) break;
        a.find_diagonals(!have_polygons, quads_sought);
        b.find_diagonals(!have_polygons, quads_sought);
        Search search(a, b, progress);
        const auto quads = search.run(parity);
        farthest = std::max(farthest, search.farthest());
        if (!quads) continue;
        std::vector<std::array<Index, 2>> ours, theirs;
        const auto named = [](const Side& side, const std::array<Index, 2>& pair) {
            return std::array<Index, 2>{side.map.input_triangle[to_size(pair[0])],
                                        side.map.input_triangle[to_size(pair[1])]};
        };
        for (const CutQuad& quad : *quads) {
            ours.push_back(named(a, quad.source));
            theirs.push_back(named(b, quad.target));
        }
        return {Recut{with_quads(source, ours), with_quads(target, theirs)}, {}};
    }
    return {
        {},
        fmt::format("nor do only the diagonals of quads differ: of all ways to lay one mesh over the other, "
                    "the one that gets farthest ends after {} of {} triangles",
                    farthest, source.n_triangles())};
}

}  // namespace counterpart::diagonals
