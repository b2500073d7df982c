// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/differences/chance.hpp"

#include "base/random.hpp"
#include "match/differences/triangle_pairs.hpp"
#include "match/differences/tuning.hpp"
#include "mesh/edge_table.hpp"
#include "numerics/median.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

namespace counterpart::differences {

using namespace isomorphism;

namespace {

std::vector<double> log_ratios(const PairSide& mesh, const std::vector<DartPair>& pairs) {
    std::vector<double> ratios;
    for (auto [d, e] : pairs)
        for (int c = 0; c < 3; ++c, d = next(d), e = next(e)) {
            const double here = mesh.length(d), there = mesh.length(e);
            if (here > 0 && there > 0) ratios.push_back(std::log(there / here));
        }
    return ratios;
}

// Pairs of darts with equal valences, drawn at random, in different triangles.
std::vector<DartPair> random_pairs(const std::vector<Index>& triangles, const PairSide& mesh) {
    std::vector<std::pair<Color, Dart>> darts;
    for (const Index t : triangles)
        for (int c = 0; c < 3; ++c) {
            const Dart d = make_dart(t, c, mesh.map.parity(make_dart(t, c)));
            darts.emplace_back(dart_color(mesh.map, mesh.colors[0], d), d);
        }
    std::sort(darts.begin(), darts.end());
    Random random(tuning.chance_seed);
    std::vector<DartPair> pairs;
    for (std::size_t trial = 0; trial < tuning.chance_trials && !darts.empty(); ++trial) {
        const auto [color, dart] = darts[static_cast<std::size_t>(random.below(darts.size()))];
        const auto first = std::lower_bound(darts.begin(), darts.end(), std::pair(color, Dart{0})),
                   last = std::upper_bound(first, darts.end(), std::pair(color, no_dart));
        const Dart other = first[static_cast<std::ptrdiff_t>(random.below(to_size(last - first)))].second;
        if (triangle_of(other) != triangle_of(dart)) pairs.emplace_back(dart, other);
    }
    return pairs;
}

// What the vertices say that a region has whole, on both sides.
double information_in(const std::vector<DartPair>& region, const PairSide& mesh,
                      const std::vector<Index>& valence, const std::vector<double>& bits) {
    std::map<Index, Index> here, there;
    std::map<Index, Index> image;
    for (auto [d, e] : region)
        for (int c = 0; c < 3; ++c, d = next(d), e = next(e)) {
            ++here[mesh.map.origin(d)];
            ++there[mesh.map.origin(e)];
            image[mesh.map.origin(d)] = mesh.map.origin(e);
        }
    const auto is_whole = [&](Index v, const std::map<Index, Index>& count) {
        return count.at(v) == valence[to_size(v)];
    };
    double sum = 0;
    for (const auto& [v, w] : image)
        if (is_whole(v, here) && is_whole(w, there)) sum += bits[to_size(v)];
    return sum;
}

}  // namespace

std::vector<double> information(MeshView mesh) {
    const std::vector<Index> valence = valences(mesh);
    std::map<Index, double> count;
    for (const Index k : valence) count[k] += 1;
    double most = 0;
    for (const auto& [k, n] : count) most = std::max(most, n);
    std::vector<double> bits;
    for (const Index k : valence)
        bits.push_back(count[k] == most ? 0 : std::log2(static_cast<double>(valence.size()) / count[k]));
    for (const auto& [v, w] : mesh::boundary_edges(mesh::EdgeTable(mesh)))
        bits[to_size(v)] = bits[to_size(w)] = 0;
    return bits;
}

double information_by_chance(const PairSide& mesh) {
    std::vector<Index> all(to_size(mesh.map.n_triangles()));
    std::iota(all.begin(), all.end(), 0);
    std::vector<Index> valence(to_size(mesh.map.n_vertices()), 0);
    for (const Index v : mesh.map.corner) ++valence[to_size(v)];
    const std::vector<double> of_input = information(mesh.mesh);
    std::vector<double> bits;
    for (const Index v : mesh.map.input_vertex) bits.push_back(of_input[to_size(v)]);
    Growth growth(mesh, mesh);
    double most = 0;
    std::size_t n_grown = 0;
    for (const DartPair& pair : random_pairs(all, mesh)) {
        if (n_grown == tuning.chance_regions) break;
        if (surroundings(mesh.map, mesh.map, pair).empty()) continue;
        ++n_grown;
        growth.add_seed(pair);
        growth.propagate(tuning.sure, tuning.chance_triangles);
        if (growth.matched().size() >= std::min(tuning.chance_triangles, all.size() / 2))
            return std::numeric_limits<double>::infinity();
        most = std::max(most, information_in(growth.matched(), mesh, valence, bits));
        growth.reset();
    }
    return most;
}

Chance chance_among(const std::vector<Index>& triangles, const PairSide& mesh) {
    const std::vector<DartPair> pairs = random_pairs(triangles, mesh);
    std::vector<double> deviations;
    for (const DartPair& pair : pairs) {
        const std::vector<DartPair> around = surroundings(mesh.map, mesh.map, pair);
        if (!around.empty()) deviations.push_back(length_deviation(log_ratios(mesh, around)));
    }
    if (deviations.empty()) return {};
    std::sort(deviations.begin(), deviations.end());
    return {static_cast<double>(deviations.size()) / static_cast<double>(pairs.size()),
            deviations[deviations.size() / 10]};
}

double length_deviation(std::vector<double> log_ratios) {
    return numerics::median_absolute_deviation(std::move(log_ratios));
}

}  // namespace counterpart::differences
