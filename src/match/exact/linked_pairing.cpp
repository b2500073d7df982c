// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/exact/linked_pairing.hpp"

#include "match/exact/count.hpp"
#include "match/exact/symmetry_choice.hpp"

#include <counterpart/base/errors.hpp>

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>

namespace counterpart {
namespace {

// Which islands touch each vertex.
std::vector<std::vector<Index>> islands_at_vertices(const CombinatorialMap& map) {
    std::vector<std::vector<Index>> islands(static_cast<std::size_t>(map.n_vertices()));
    for (Index i = 0; i < map.n_islands(); ++i) {
        for (auto h = 3 * static_cast<std::size_t>(map.island_begin[static_cast<std::size_t>(i)]);
             h < 3 * static_cast<std::size_t>(map.island_begin[static_cast<std::size_t>(i) + 1]); ++h) {
            auto& at = islands[static_cast<std::size_t>(map.corner[h])];
            if (at.empty() || at.back() != i) at.push_back(i);
        }
    }
    return islands;
}

struct Option {
    const Member* target;
    std::size_t element;
    bool against;  // turns the island over where the others are not, or the other way round
    double distance = 0;
};

struct Frame {
    std::vector<Option> options;
    std::size_t next = 0;
    std::vector<Index> assigned;  // source vertices that this island was the first to place
    const Member* target = nullptr;
    std::size_t element = 0;
};

class Search {
  public:
    /// `self`: the source onto itself, every solution, by connectivity alone. `start`: the motion to assume
    /// until islands have fixed it; null: none is known.
    Search(const MatchedMaps& maps, bool turned, bool self, const Motion* start = nullptr)
        : maps_(maps),
          source_(maps.source),
          target_(self ? maps.source : maps.target),
          turned_(turned),
          self_(self),
          geometry_(maps, !self),
          source_islands_(islands_at_vertices(source_)),
          target_islands_(islands_at_vertices(target_)) {
        kind_of_.resize(static_cast<std::size_t>(source_.n_islands()));
        member_of_.resize(kind_of_.size());
        target_member_.resize(static_cast<std::size_t>(target_.n_islands()));
        target_kind_.resize(target_member_.size());
        for (std::size_t k = 0; k < maps.classes.size(); ++k) {
            for (const Member& member : maps.classes[k].source) {
                kind_of_[static_cast<std::size_t>(member.island)] = k;
                member_of_[static_cast<std::size_t>(member.island)] = &member;
            }
            for (const Member& member : targets(k)) {
                target_kind_[static_cast<std::size_t>(member.island)] = k;
                target_member_[static_cast<std::size_t>(member.island)] = &member;
            }
            add_elements(k);
        }
        image_.assign(static_cast<std::size_t>(source_.n_vertices()), -1);
        origin_.assign(static_cast<std::size_t>(target_.n_vertices()), -1);
        taken_.assign(target_member_.size(), false);
        if (start != nullptr) similarity_ = *start;
        fixed_ = start != nullptr;
        set_order();
    }

    /// Calls `solved` for each solution until it returns false. False if the search was cut short.
    template <class Solved>
    bool run(const Solved& solved) {
        frames_.assign(1, {});
        frames_[0].options = options(order_[0]);
        std::size_t steps = 100 * static_cast<std::size_t>(source_.n_triangles()) + 1'000'000;
        while (!frames_.empty()) {
            Frame& frame = frames_.back();
            const Index island = order_[frames_.size() - 1];
            undo(frame);
            if (frame.next == frame.options.size()) {
                frames_.pop_back();
                continue;
            }
            const Option option = frame.options[frame.next++];
            const auto cost = static_cast<std::size_t>(source_.island_size(island));
            if (steps < cost) return false;
            steps -= cost;
            if (!place(island, option, frame)) continue;
            if (frames_.size() == order_.size()) {
                if (!solved()) return true;
                continue;
            }
            update_similarity();
            Frame deeper;
            deeper.options = options(order_[frames_.size()]);
            frames_.push_back(std::move(deeper));
        }
        return !truncated_;
    }

    Pairing pairing() const {
        Pairing result;
        for (std::size_t i = 0; i < frames_.size(); ++i) {
            const auto island = static_cast<std::size_t>(order_[i]);
            const std::size_t k = kind_of_[island];
            result.pairs.push_back(
                {&maps_.classes[k], member_of_[island], frames_[i].target, elements_[k][frames_[i].element]});
        }
        return result;
    }

  private:
    const std::vector<Member>& targets(std::size_t k) const {
        return self_ ? maps_.classes[k].source : maps_.classes[k].target;
    }
    Index first(std::size_t k) const {
        return source_.island_begin[static_cast<std::size_t>(maps_.classes[k].island)];
    }

    // Automorphisms written out: orientation-preserving ones first, then as many reversing ones.
    void add_elements(std::size_t k) {
        const AutomorphismGroup& group = maps_.groups[k];
        const auto size = static_cast<std::size_t>(source_.island_size(maps_.classes[k].island));
        const std::size_t most = std::max<std::size_t>(1, (1U << 22U) / size);
        const std::size_t n = std::min(group.order(), most);
        truncated_ = truncated_ || n < group.order() || !group.complete;
        std::vector<Images> even;
        for (std::size_t e = 0; e < n; ++e) {
            Images images(size);
            for (std::size_t t = 0; t < size; ++t)
                images[t] = e == 0 ? make_flag(first(k) + static_cast<Index>(t), 0)
                                   : image_of(group.generators[group.generator[e]], first(k),
                                              even[group.parent[e]][t]);
            even.push_back(std::move(images));
        }
        n_even_.push_back(n);
        for (std::size_t e = 0; e < n && !group.mirror.empty(); ++e) {
            Images images = group.mirror;
            for (Flag& f : images) f = image_of(even[e], first(k), f);
            even.push_back(std::move(images));
        }
        elements_.push_back(std::move(even));
    }

    // Islands with the fewest possible partners first, then their neighbours: whose place then nearly
    // follows.
    void set_order() {
        std::vector<Index> by_choice(kind_of_.size());
        std::iota(by_choice.begin(), by_choice.end(), 0);
        const auto choices = [&](Index i) {
            const std::size_t k = kind_of_[static_cast<std::size_t>(i)];
            return targets(k).size() * n_even_[k];
        };
        std::stable_sort(by_choice.begin(), by_choice.end(), [&](Index a, Index b) {
            return choices(a) != choices(b) ? choices(a) < choices(b)
                                            : source_.island_size(a) > source_.island_size(b);
        });
        std::vector<bool> seen(kind_of_.size(), false);
        for (const Index start : by_choice) {
            if (seen[static_cast<std::size_t>(start)]) continue;
            seen[static_cast<std::size_t>(start)] = true;
            std::size_t k = order_.size();
            for (order_.push_back(start); k < order_.size(); ++k) {
                for_each_vertex(source_, order_[k], [&](Index v) {
                    for (const Index i : source_islands_[static_cast<std::size_t>(v)]) {
                        if (seen[static_cast<std::size_t>(i)]) continue;
                        seen[static_cast<std::size_t>(i)] = true;
                        order_.push_back(i);
                    }
                });
            }
        }
    }

    template <class Body>
    static void for_each_vertex(const CombinatorialMap& map, Index island, const Body& body) {
        for (auto h = 3 * static_cast<std::size_t>(map.island_begin[static_cast<std::size_t>(island)]);
             h < 3 * static_cast<std::size_t>(map.island_begin[static_cast<std::size_t>(island) + 1]); ++h)
            body(map.corner[h]);
    }

    std::vector<Option> options(Index island) const {
        const std::size_t k = kind_of_[static_cast<std::size_t>(island)];
        // A vertex that is placed already leaves the islands around its image.
        const std::vector<Index>* around = nullptr;
        for_each_vertex(source_, island, [&](Index v) {
            const Index w = image_[static_cast<std::size_t>(v)];
            if (w < 0) return;
            const auto& at = target_islands_[static_cast<std::size_t>(w)];
            if (around == nullptr || at.size() < around->size()) around = &at;
        });
        std::vector<Option> found;
        const auto consider = [&](const Member& member) {
            if (taken_[static_cast<std::size_t>(member.island)]) return;
            const unsigned parity = member_of_[static_cast<std::size_t>(island)]->parity ^ member.parity;
            for (std::size_t e = 0; e < elements_[k].size(); ++e) {
                const bool turns = (parity ^ (e >= n_even_[k] ? 1U : 0U)) != 0;
                const bool against = turns != turned_ && !source_.is_one_sided(island);
                if (against && self_) continue;
                found.push_back({&member, e, against, self_ ? 0 : distance(k, island, member, e)});
            }
        };
        if (around != nullptr) {
            for (const Index i : *around)
                if (target_kind_[static_cast<std::size_t>(i)] == k)
                    consider(*target_member_[static_cast<std::size_t>(i)]);
        } else {
            for (const Member& member : targets(k)) consider(member);
        }
        std::stable_sort(found.begin(), found.end(), [](const Option& a, const Option& b) {
            return a.against != b.against ? b.against : a.distance < b.distance;
        });
        return found;
    }

    double distance(std::size_t k, Index island, const Member& member, std::size_t element) const {
        const IslandPair pair{&maps_.classes[k], member_of_[static_cast<std::size_t>(island)], &member,
                              elements_[k][element]};
        const double lengths = geometry_.length_disagreement(pair, 16);
        return similarity_ ? lengths + residual(*similarity_, geometry_.points(pair, 16)) : lengths;
    }

    bool place(Index island, const Option& option, Frame& frame) {
        const std::size_t k = kind_of_[static_cast<std::size_t>(island)];
        const Images& from = member_of_[static_cast<std::size_t>(island)]->from_representative;
        for (std::size_t t = 0; t < from.size(); ++t) {
            Flag f = from[t],
                 g = image_of(option.target->from_representative, first(k), elements_[k][option.element][t]);
            for (int c = 0; c < 3; ++c, f = next(f), g = next(g)) {
                const Index v = source_.origin(f), w = target_.origin(g);
                Index& image = image_[static_cast<std::size_t>(v)];
                Index& origin = origin_[static_cast<std::size_t>(w)];
                if (image == w && origin == v) continue;
                // Its islands must be as many on both sides, or one will be left without a place.
                if (image >= 0 || origin >= 0 ||
                    source_islands_[static_cast<std::size_t>(v)].size() !=
                        target_islands_[static_cast<std::size_t>(w)].size()) {
                    undo(frame);
                    return false;
                }
                image = w;
                origin = v;
                frame.assigned.push_back(v);
            }
        }
        frame.target = option.target;
        frame.element = option.element;
        taken_[static_cast<std::size_t>(option.target->island)] = true;
        return true;
    }

    void undo(Frame& frame) {
        for (const Index v : frame.assigned) {
            Index& image = image_[static_cast<std::size_t>(v)];
            origin_[static_cast<std::size_t>(image)] = -1;
            image = -1;
        }
        frame.assigned.clear();
        if (frame.target != nullptr) taken_[static_cast<std::size_t>(frame.target->island)] = false;
        frame.target = nullptr;
    }

    // Refitted whenever twice as many vertices are placed as at the last fit.
    void update_similarity() {
        if (self_ || fixed_) return;
        placed_ += frames_.back().assigned.size();
        if (placed_ < 2 * placed_at_fit_ || placed_ < 3) return;
        placed_at_fit_ = placed_;
        std::vector<PointPair> points;
        const std::size_t step = std::max<std::size_t>(1, placed_ / 5000);
        std::size_t i = 0;
        for (std::size_t v = 0; v < image_.size(); ++v) {
            if (image_[v] < 0 || i++ % step != 0) continue;
            points.push_back(
                {maps_.source_mesh.vertices.row(source_.input_vertex[v]),
                 maps_.target_mesh.vertices.row(target_.input_vertex[static_cast<std::size_t>(image_[v])])});
        }
        similarity_ = fit_similarity(points, turned_);
    }

    const MatchedMaps& maps_;
    const CombinatorialMap& source_;
    const CombinatorialMap& target_;
    bool turned_, self_, fixed_ = false, truncated_ = false;
    PairGeometry geometry_;
    std::vector<std::vector<Index>> source_islands_, target_islands_;
    std::vector<std::size_t> kind_of_, target_kind_;
    std::vector<const Member*> member_of_, target_member_;
    std::vector<std::vector<Images>> elements_;
    std::vector<std::size_t> n_even_;
    std::vector<Index> order_, image_, origin_;
    std::vector<bool> taken_;
    std::vector<Frame> frames_;
    std::optional<Motion> similarity_;
    std::size_t placed_ = 0, placed_at_fit_ = 0;
};

void put_best_first(std::vector<Pairing>& pairings) {
    // Not an order to sort by: what is alike need not be transitive. So the best is found, then the rest is
    // ranked by the same figures in turn.
    std::size_t best = 0;
    for (std::size_t i = 1; i < pairings.size(); ++i)
        if (fits_better(pairings[i], pairings[best])) best = i;
    std::swap(pairings[0], pairings[best]);
    std::stable_sort(pairings.begin() + 1, pairings.end(), [](const Pairing& a, const Pairing& b) {
        return a.length_disagreement + a.residual < b.length_disagreement + b.residual;
    });
}

}  // namespace

std::vector<Pairing> pair_linked_islands(const MatchedMaps& maps, bool turned, std::size_t most) {
    // As many as a second or so allows to be measured.
    const std::size_t most_measured =
        std::clamp<std::size_t>(20'000'000 / static_cast<std::size_t>(maps.source.n_triangles()), 1, 1000);
    std::vector<Pairing> found;
    Search search(maps, turned, false);
    const bool complete = search.run([&] {
        found.push_back(search.pairing());
        measure(maps, turned, found.back());
        return found.size() < std::max(most, most_measured);
    });
    if (!complete && found.empty()) {
        throw NumericalError(
            "the patches of this non-manifold mesh are too much alike to search all the ways in which "
            "they could fit; weld duplicates or remove duplicate faces");
    }
    if (found.size() > 1) {
        put_best_first(found);
        // The best so far shows where the patches belong, or they lie there already: what comes first then
        // may be better still.
        for (const bool as_they_lie : {true, false, false}) {
            const Motion motion = as_they_lie ? Motion{} : found[0].similarity;
            Search again(maps, turned, false, &motion);
            again.run([&] {
                found.push_back(again.pairing());
                measure(maps, turned, found.back());
                return false;
            });
            if (fits_better(found.back(), found[0]))
                std::rotate(found.begin(), found.end() - 1, found.end());
            else
                found.pop_back();
        }
    }
    if (found.size() > most) found.resize(most);
    return found;
}

Count count_linked_automorphisms(const MatchedMaps& maps, bool turned) {
    constexpr std::uint64_t most = 1000;
    std::uint64_t found = 0;
    Search search(maps, turned, true);
    const bool complete = search.run([&] { return ++found < most; });
    Count count = count_of(found);
    count.is_lower_bound = !complete || found == most;
    return count;
}

}  // namespace counterpart
