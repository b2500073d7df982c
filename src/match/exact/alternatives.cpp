// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/exact/alternatives.hpp"

#include "match/exact/symmetry_choice.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

namespace counterpart {
namespace {

class Enumeration {
  public:
    Enumeration(const MatchedMaps& maps, const Pairing& pairing, bool turned, std::size_t most)
        : maps_(maps),
          geometry_(maps, true),
          best_(pairing),
          current_(pairing),
          turned_(turned),
          most_(most) {
        // Equal islands that keep, or all turn, their orientation can be exchanged.
        std::map<std::tuple<const IslandClass*, unsigned, unsigned>, std::vector<std::size_t>> alike;
        for (std::size_t p = 0; p < pairing.pairs.size(); ++p) {
            const IslandPair& pair = pairing.pairs[p];
            alike[{pair.kind, pair.source->parity, pair.target->parity}].push_back(p);
        }
        for (auto& [key, pairs] : alike)
            if (pairs.size() > 1 || group(pairs[0]).order() > 1) exchangeable_.push_back(std::move(pairs));
        std::stable_sort(exchangeable_.begin(), exchangeable_.end(), [](const auto& a, const auto& b) {
            return a.size() > b.size();  // the last vary first
        });
    }

    std::vector<Pairing> run() {
        exchange(0);
        return std::move(found_);
    }

  private:
    const AutomorphismGroup& group(std::size_t p) const {
        return maps_.groups[static_cast<std::size_t>(best_.pairs[p].kind - maps_.classes.data())];
    }

    // Every order of the targets of exchangeable pairs `e`, and every turn of each; false when there are
    // enough.
    bool exchange(std::size_t e) {
        if (e == exchangeable_.size()) return emit();
        const std::vector<std::size_t>& pairs = exchangeable_[e];
        std::vector<std::size_t> order(pairs.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        do {
            for (std::size_t i = 0; i < pairs.size(); ++i)
                current_.pairs[pairs[i]].target = best_.pairs[pairs[order[i]]].target;
            if (!turn(e, 0)) return false;
        } while (std::next_permutation(order.begin(), order.end()));
        return true;
    }

    bool turn(std::size_t e, std::size_t i) {
        if (i == exchangeable_[e].size()) return exchange(e + 1);
        const std::size_t p = exchangeable_[e][i];
        for (const Images& images : turns(p)) {
            current_.pairs[p].automorphism = images;
            if (!turn(e, i + 1)) return false;
        }
        return true;
    }

    // The automorphisms of pair p as it is now, best first; where it is as in the best pairing, that one.
    const std::vector<Images>& turns(std::size_t p) {
        const IslandPair& pair = current_.pairs[p];
        const auto [at, is_new] = turns_.try_emplace({p, pair.target});
        std::vector<Images>& ranked = at->second;
        if (!is_new) return ranked;
        const bool mirror = turned_ && !group(p).mirror.empty();
        if (group(p).order() == 1)
            ranked.push_back(mirror ? group(p).mirror : Images{});
        else
            ranked = rank_automorphisms(maps_, group(p), geometry_, pair, mirror, nullptr, most_ + 1);
        if (pair.target == best_.pairs[p].target) {
            std::erase(ranked, best_.pairs[p].automorphism);
            ranked.insert(ranked.begin(), best_.pairs[p].automorphism);
        }
        return ranked;
    }

    bool emit() {
        if (std::exchange(is_first_, false)) return true;  // the best pairing itself
        found_.push_back(current_);
        measure(maps_, turned_, found_.back());
        return found_.size() < most_;
    }

    const MatchedMaps& maps_;
    PairGeometry geometry_;
    const Pairing& best_;
    Pairing current_;
    bool turned_, is_first_ = true;
    std::size_t most_;
    std::vector<std::vector<std::size_t>> exchangeable_;  // pair numbers
    std::map<std::pair<std::size_t, const Member*>, std::vector<Images>> turns_;
    std::vector<Pairing> found_;
};

}  // namespace

std::vector<Pairing> other_pairings(const MatchedMaps& maps, const Pairing& pairing, bool turned,
                                    std::size_t most) {
    if (most == 0) return {};
    std::vector<Pairing> found = Enumeration(maps, pairing, turned, most).run();
    std::stable_sort(found.begin(), found.end(), [](const Pairing& a, const Pairing& b) {
        return a.length_disagreement + a.residual < b.length_disagreement + b.residual;
    });
    return found;
}

}  // namespace counterpart
