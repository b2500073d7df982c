// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/non_manifold/matching.hpp"

#include "match/isomorphism/counting.hpp"
#include "match/symmetry/tuning.hpp"

#include <counterpart/base/errors.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace counterpart::non_manifold {
namespace {

using namespace isomorphism;
using symmetry::Alignment;
using symmetry::Choice;
using symmetry::ComponentPair;
using symmetry::exact_tuning;
using symmetry::MatchedMaps;
using symmetry::PairGeometry;
using symmetry::PointPair;

// One of the two meshes, cut into patches (its components).
struct Patches {
    Patches(const DartMap& map_of_patches, const std::vector<ComponentClass>& classes,
            std::vector<Member> ComponentClass::*side)
        : map(map_of_patches),
          at_vertex(to_size(map.n_vertices())),
          kind(to_size(map.n_components())),
          member(kind.size()) {
        for (Index i = 0; i < map.n_components(); ++i) {
            for_each_vertex(i, [&](Index v) {
                auto& at = at_vertex[to_size(v)];
                if (at.empty() || at.back() != i) at.push_back(i);
            });
        }
        for (std::size_t k = 0; k < classes.size(); ++k) {
            for (const Member& one : classes[k].*side) {
                kind[to_size(one.component)] = k;
                member[to_size(one.component)] = &one;
            }
        }
    }
    template <class Body>
    void for_each_vertex(Index patch, const Body& body) const {
        for (std::size_t h = 3 * to_size(map.component_begin[to_size(patch)]);
             h < 3 * to_size(map.component_begin[to_size(patch) + 1]); ++h)
            body(map.corner[h]);
    }

    const DartMap& map;
    std::vector<std::vector<Index>> at_vertex;  // patches that touch each vertex
    std::vector<std::size_t> kind;              // class of each patch
    std::vector<const Member*> member;
};

// One way to place a patch: on which patch of the target, and by which automorphism.
struct Option {
    const Member* target = nullptr;
    std::size_t element = 0;
    bool against = false;  // reverses the orientation where the others keep it, or the other way round
    double error = 0;
};

struct Frame {
    std::vector<Option> options;
    std::size_t next = 0;
    std::optional<Option> chosen;
    std::vector<Index> assigned;  // source vertices that this patch was the first to place
};

class Search {
  public:
    /// `geometry`: orders the options of each patch; null for the source onto itself, every isomorphism.
    /// `start`: the alignment to assume until patches have fixed it.
    Search(const MatchedMaps& maps, bool reversed, const PairGeometry* geometry,
           std::optional<Alignment> start = std::nullopt)
        : maps_(maps),
          source_(maps.source, maps.classes, &ComponentClass::source),
          target_(geometry != nullptr ? maps.target : maps.source, maps.classes,
                  geometry != nullptr ? &ComponentClass::target : &ComponentClass::source),
          reversed_(reversed),
          geometry_(geometry),
          alignment_(std::move(start)),
          image_(to_size(source_.map.n_vertices()), -1),
          origin_(to_size(target_.map.n_vertices()), -1),
          taken_(to_size(target_.map.n_components()), false) {
        for (std::size_t k = 0; k < maps.classes.size(); ++k) write_out_automorphisms(k);
        set_order();
    }

    /// Calls `found` for each isomorphism until it returns false. False if the search was cut short.
    template <class Found>
    bool run(const Found& found) {
        frames_.assign(1, {});
        frames_[0].options = options(order_[0]);
        std::size_t steps = exact_tuning.search_steps_per_triangle * to_size(source_.map.n_triangles()) +
                            exact_tuning.min_search_steps;
        while (!frames_.empty()) {
            Frame& frame = frames_.back();
            const Index patch = order_[frames_.size() - 1];
            undo(frame);
            if (frame.next == frame.options.size()) {
                frames_.pop_back();
                continue;
            }
            const Option option = frame.options[frame.next++];
            const std::size_t cost = to_size(source_.map.component_size(patch));
            if (steps < cost) return false;
            steps -= cost;
            if (!place(patch, option, frame)) continue;
            if (frames_.size() == order_.size()) {
                if (!found()) return true;
                continue;
            }
            update_alignment();
            Frame deeper;
            deeper.options = options(order_[frames_.size()]);
            frames_.push_back(std::move(deeper));
        }
        return !truncated_;
    }

    Choice isomorphism() const {
        Choice choice;
        for (std::size_t i = 0; i < frames_.size(); ++i)
            choice.pairs.push_back(pair(order_[i], *frames_[i].chosen));
        return choice;
    }

  private:
    const ComponentClass& kind_of(Index patch) const { return maps_.classes[source_.kind[to_size(patch)]]; }
    ComponentPair pair(Index patch, const Option& option) const {
        return {&kind_of(patch), source_.member[to_size(patch)], option.target,
                elements_[source_.kind[to_size(patch)]][option.element]};
    }

    // Orientation-preserving ones first, then as many reversing ones.
    void write_out_automorphisms(std::size_t k) {
        const AutomorphismGroup& group = maps_.groups[k];
        const Index first = maps_.classes[k].first;
        const auto size = to_size(source_.map.component_size(maps_.classes[k].component));
        const std::size_t n =
            std::min(group.order(), std::max<std::size_t>(1, exact_tuning.max_written_out / size));
        truncated_ = truncated_ || n < group.order();
        std::vector<Images> elements(1, Images(size));
        for (std::size_t t = 0; t < size; ++t) elements[0][t] = make_dart(first + static_cast<Index>(t), 0);
        const auto after = [&](const Images& step, Images images) {
            for (Dart& d : images) d = image_of(step, first, d);
            return images;
        };
        for (std::size_t e = 1; e < n; ++e)
            elements.push_back(after(group.generators[group.generator[e]], elements[group.parent[e]]));
        for (std::size_t e = 0; e < n && !group.mirror.empty(); ++e)
            elements.push_back(after(elements[e], group.mirror));
        n_preserving_.push_back(n);
        elements_.push_back(std::move(elements));
    }

    // Patches with the fewest possible partners first, then their neighbors: their place nearly follows.
    void set_order() {
        std::vector<Index> by_choice(source_.kind.size());
        std::iota(by_choice.begin(), by_choice.end(), 0);
        const auto n_choices = [&](Index i) {
            const std::size_t k = source_.kind[to_size(i)];
            return maps_.classes[k].source.size() * n_preserving_[k];
        };
        std::stable_sort(by_choice.begin(), by_choice.end(), [&](Index a, Index b) {
            return n_choices(a) != n_choices(b)
                       ? n_choices(a) < n_choices(b)
                       : source_.map.component_size(a) > source_.map.component_size(b);
        });
        std::vector<bool> seen(source_.kind.size(), false);
        const auto add = [&](Index patch) {
            if (!seen[to_size(patch)]) order_.push_back(patch);
            seen[to_size(patch)] = true;
        };
        for (const Index start : by_choice) {
            std::size_t k = order_.size();
            for (add(start); k < order_.size(); ++k)
                source_.for_each_vertex(order_[k], [&](Index v) {
                    for (const Index neighbor : source_.at_vertex[to_size(v)]) add(neighbor);
                });
        }
    }

    std::vector<Option> options(Index patch) const {
        const std::size_t k = source_.kind[to_size(patch)];
        // A vertex that is placed already leaves the patches around its image.
        const std::vector<Index>* around = nullptr;
        source_.for_each_vertex(patch, [&](Index v) {
            const Index w = image_[to_size(v)];
            if (w < 0) return;
            const auto& at = target_.at_vertex[to_size(w)];
            if (around == nullptr || at.size() < around->size()) around = &at;
        });
        std::vector<Option> found;
        const auto consider = [&](Index candidate) {
            if (target_.kind[to_size(candidate)] != k || taken_[to_size(candidate)]) return;
            const Member* const member = target_.member[to_size(candidate)];
            const unsigned parity = source_.member[to_size(patch)]->parity ^ member->parity;
            for (std::size_t e = 0; e < elements_[k].size(); ++e) {
                const bool reverses = (parity ^ (e >= n_preserving_[k] ? 1U : 0U)) != 0;
                const bool against = reverses != reversed_ && !source_.map.is_one_sided(patch);
                if (against && geometry_ == nullptr) continue;
                Option option{member, e, against, 0};
                if (geometry_ != nullptr) option.error = error(pair(patch, option));
                found.push_back(option);
            }
        };
        if (around != nullptr)
            std::for_each(around->begin(), around->end(), consider);
        else
            for (Index i = 0; i < target_.map.n_components(); ++i) consider(i);
        std::stable_sort(found.begin(), found.end(), [](const Option& a, const Option& b) {
            return a.against != b.against ? b.against : a.error < b.error;
        });
        return found;
    }

    double error(const ComponentPair& pair) const {
        constexpr std::size_t max_triangles = 16;
        const double lengths = geometry_->edge_length_error(pair, max_triangles);
        return alignment_ ? lengths + squared_error(*alignment_, geometry_->points(pair, max_triangles))
                          : lengths;
    }

    bool place(Index patch, const Option& option, Frame& frame) {
        const ComponentPair placed = pair(patch, option);
        for (std::size_t t = 0; t < placed.size(); ++t) {
            Dart d = placed.on_source(t), e = placed.on_target(t);
            for (int c = 0; c < 3; ++c, d = next(d), e = next(e)) {
                const Index v = source_.map.origin(d), w = target_.map.origin(e);
                Index& image = image_[to_size(v)];
                Index& origin = origin_[to_size(w)];
                if (image == w && origin == v) continue;
                // Its patches must be as many on both sides, or one will be left without a place.
                if (image >= 0 || origin >= 0 ||
                    source_.at_vertex[to_size(v)].size() != target_.at_vertex[to_size(w)].size()) {
                    undo(frame);
                    return false;
                }
                image = w;
                origin = v;
                frame.assigned.push_back(v);
            }
        }
        frame.chosen = option;
        taken_[to_size(option.target->component)] = true;
        return true;
    }

    void undo(Frame& frame) {
        for (const Index v : frame.assigned) {
            Index& image = image_[to_size(v)];
            origin_[to_size(image)] = -1;
            image = -1;
        }
        frame.assigned.clear();
        if (frame.chosen) taken_[to_size(frame.chosen->target->component)] = false;
        frame.chosen.reset();
    }

    // Fitted again whenever twice as many vertices are placed as at the last fit.
    void update_alignment() {
        if (geometry_ == nullptr) return;
        n_placed_ += frames_.back().assigned.size();
        if (n_placed_ < 2 * n_fitted_ || n_placed_ < 3) return;
        n_fitted_ = n_placed_;
        std::vector<PointPair> points;
        for (const std::size_t v : symmetry::evenly_spread(image_.size(), max_fitted_vertices))
            if (image_[v] >= 0)
                points.push_back(
                    {maps_.source_mesh.vertices.row(source_.map.input_vertex[v]),
                     maps_.target_mesh.vertices.row(target_.map.input_vertex[to_size(image_[v])])});
        if (points.size() >= 3) alignment_ = fit_alignment(points, reversed_);
    }

    static constexpr std::size_t max_fitted_vertices = 5000;
    const MatchedMaps& maps_;
    Patches source_, target_;
    bool reversed_, truncated_ = false;
    const PairGeometry* geometry_;
    std::optional<Alignment> alignment_;
    std::vector<std::vector<Images>> elements_;  // of each class
    std::vector<std::size_t> n_preserving_;
    std::vector<Index> order_, image_, origin_;
    std::vector<bool> taken_;  // target patches
    std::vector<Frame> frames_;
    std::size_t n_placed_ = 0, n_fitted_ = 0;
};

}  // namespace

std::vector<Choice> match_patches(const MatchedMaps& maps, bool reversed, std::size_t max,
                                  const Progress& progress) {
    const std::size_t max_compared =
        std::clamp<std::size_t>(exact_tuning.max_measured_triangles / to_size(maps.source.n_triangles()), 1,
                                exact_tuning.max_isomorphisms);
    const PairGeometry geometry(maps);
    std::vector<Choice> found;
    const auto search = [&](const std::optional<Alignment>& start, std::size_t most) {
        Search patches(maps, reversed, &geometry, start);
        return patches.run([&] {
            found.push_back(patches.isomorphism());
            measure(maps, geometry, reversed, found.back());
            report_progress(progress, static_cast<double>(found.size()) / static_cast<double>(most + 1));
            return found.size() < most;
        });
    };
    const bool complete = search(std::nullopt, std::max(max, max_compared));
    if (!complete && found.empty())
        throw NumericalError(
            "the patches of this non-manifold mesh are too much alike to search all the ways in which they "
            "could fit; weld duplicates or remove duplicate faces");
    // Ties are not transitive, so this is no order to sort by: the best is found, then the rest is ranked.
    for (std::size_t i = 1; i < found.size(); ++i)
        if (geometry.is_better(found[i].fit, found[0].fit)) std::swap(found[0], found[i]);
    if (found.size() > 1) {
        // Where there are more than are compared, the one that leaves all patches as they lie may be missing.
        search(Alignment{}, found.size() + 1);
        if (geometry.is_better(found.back().fit, found[0].fit)) std::swap(found[0], found.back());
        found.pop_back();
        std::stable_sort(found.begin() + 1, found.end(), [](const Choice& a, const Choice& b) {
            return a.fit.edge_length_error + a.fit.rigid_error < b.fit.edge_length_error + b.fit.rigid_error;
        });
    }
    if (found.size() > max) found.resize(max);
    return found;
}

Count count_automorphisms(const MatchedMaps& maps, bool reversed) {
    std::size_t n = 0;
    Search search(maps, reversed, nullptr);
    const bool complete = search.run([&] { return ++n < exact_tuning.max_isomorphisms; });
    return count_from_log10(std::log10(static_cast<double>(n)),
                            !complete || n == exact_tuning.max_isomorphisms);
}

}  // namespace counterpart::non_manifold
