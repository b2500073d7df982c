// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/symmetry/confirmation.hpp"

#include "match/symmetry/tuning.hpp"
#include "numerics/median.hpp"
#include "numerics/rank_correlation.hpp"

#include <counterpart/descriptor/descriptors.hpp>
#include <counterpart/mesh/measure.hpp>
#include <counterpart/spectral/eigen_basis.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace counterpart::symmetry {

using namespace isomorphism;

namespace {

double spread(const std::vector<double>& values) {
    double sum = 0, squares = 0;
    for (const double value : values) {
        sum += value;
        squares += value * value;
    }
    const auto n = static_cast<double>(values.size());
    return std::sqrt(std::max(0.0, squares / n - sum * sum / (n * n)));
}

struct Side {
    const DartMap& map;
    MeshView mesh;
    Vector curvature;  // of the mesh's vertices; none without area

    Side(const DartMap& of, MeshView view) : map(of), mesh(view) {
        if (surface_area(mesh) > 0) curvature = mean_curvature(mesh, laplace_beltrami(mesh));
    }

    double length(Dart d) const {
        const auto at = [&](Dart f) { return mesh.vertices.row(map.input_vertex[to_size(map.origin(f))]); };
        return (at(next(d)) - at(d)).norm();
    }
};

// How unlike edges are in length, whatever the scale.
double deviation(const Side& a, const Side& b, const ComponentPair& pair) {
    std::vector<double> ratios;
    for (const std::size_t k : evenly_spread(pair.size(), exact_tuning.confirming_triangles)) {
        Dart d = pair.on_source(k), e = pair.on_target(k);
        for (int c = 0; c < 3; ++c, d = next(d), e = next(e)) {
            const double here = a.length(d), there = b.length(e);
            if (here > 0 && there > 0) ratios.push_back(std::log(there / here));
        }
    }
    return numerics::median_absolute_deviation(std::move(ratios));
}

// Whether both bulge and are hollow at the same places.
bool curve_alike(const Side& a, const Side& b, const ComponentPair& pair) {
    if (a.curvature.size() == 0 || b.curvature.size() == 0) return false;
    std::vector<double> here, there;
    for (const std::size_t k : evenly_spread(pair.size(), exact_tuning.confirming_triangles)) {
        here.push_back(a.curvature[a.map.input_vertex[to_size(a.map.origin(pair.on_source(k)))]]);
        there.push_back(b.curvature[b.map.input_vertex[to_size(b.map.origin(pair.on_target(k)))]]);
    }
    const auto n = static_cast<Eigen::Index>(here.size());
    return numerics::rank_correlation(Eigen::Map<Vector>(here.data(), n),
                                      Eigen::Map<Vector>(there.data(), n)) >= exact_tuning.curve_alike;
}

// The pair with a symmetry of the representative before its automorphism.
ComponentPair turned(ComponentPair pair, const Images& symmetry) {
    if (pair.automorphism.empty()) {
        pair.automorphism = symmetry;
        return pair;
    }
    Images images;
    for (const Dart d : symmetry) images.push_back(image_of(pair.automorphism, pair.kind->first, d));
    pair.automorphism = std::move(images);
    return pair;
}

// The representative of a class lies on one of both meshes.
std::vector<Images> some_symmetries(const MatchedMaps& maps, const ComponentClass& kind,
                                    const AutomorphismGroup& group) {
    const DartMap& map = kind.in_target ? maps.target : maps.source;
    SimultaneousTraversal traversal(map, map);
    std::vector<Images> result;
    for (const std::size_t e : evenly_spread(group.order() - 1, exact_tuning.n_compared))
        result.push_back(traversal.run(kind.component, kind.root, group.orbit[e + 1]));
    return result;
}

bool is_confirmed(const Side& source, const Side& target, const ComponentPair& pair,
                  const std::vector<Images>& symmetries, std::size_t order) {
    const double chosen = deviation(source, target, pair);
    std::vector<double> of_source, of_target, others;
    for (const Images& symmetry : symmetries) {
        of_source.push_back(deviation(source, source, {pair.kind, pair.source, pair.source, symmetry}));
        of_target.push_back(deviation(target, target, {pair.kind, pair.target, pair.target, symmetry}));
    }
    const double itself =
        std::min(numerics::median(std::move(of_source)), numerics::median(std::move(of_target)));
    if (itself <= std::max(exact_tuning.clear_share * chosen, exact_tuning.alike)) return true;
    for (const Images& symmetry : symmetries)
        others.push_back(deviation(source, target, turned(pair, symmetry)));
    // The best of so many ways is as much better than the middle by chance, in standard deviations.
    const double by_chance = std::sqrt(2 * std::log(static_cast<double>(order))) * spread(others);
    const double middle = numerics::median(std::move(others));
    const bool keeps_lengths = chosen <= std::max(exact_tuning.clear_share * middle, exact_tuning.alike) ||
                               chosen <= middle - exact_tuning.beyond_chance * by_chance;
    return keeps_lengths && curve_alike(source, target, pair);
}

}  // namespace

double confirmed_share(const MatchedMaps& maps, const Choice& choice) {
    std::vector<std::vector<const ComponentPair*>> of_class(maps.classes.size());
    for (const ComponentPair& pair : choice.pairs)
        of_class[to_size(pair.kind - maps.classes.data())].push_back(&pair);
    std::optional<Side> source, target;
    double confirmed = 0;
    for (std::size_t k = 0; k < of_class.size(); ++k) {
        const std::vector<const ComponentPair*>& pairs = of_class[k];
        if (pairs.empty()) continue;
        const auto size = static_cast<double>(pairs.size() * pairs.front()->size());
        const std::size_t order = maps.groups[k].order();
        if (order == 1) {
            confirmed += size;
            continue;
        }
        if (!source) source.emplace(maps.source, maps.source_mesh);
        if (!target) target.emplace(maps.target, maps.target_mesh);
        const std::vector<Images> symmetries = some_symmetries(maps, maps.classes[k], maps.groups[k]);
        const std::vector<std::size_t> some = evenly_spread(pairs.size(), exact_tuning.n_confirmed);
        const auto n = std::count_if(some.begin(), some.end(), [&](std::size_t i) {
            return is_confirmed(*source, *target, *pairs[i], symmetries, order);
        });
        confirmed += size * static_cast<double>(n) / static_cast<double>(some.size());
    }
    return confirmed / std::max(1, maps.source.n_triangles());
}

}  // namespace counterpart::symmetry
