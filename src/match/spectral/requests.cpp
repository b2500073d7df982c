// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/requests.hpp"

#include <counterpart/base/errors.hpp>

#include <map>

#include <Eigen/Geometry>
#include <fmt/format.h>

namespace counterpart::spectral_match {

void require_valid(const SpectralOptions& options, Index n_source, Index n_target) {
    if (options.n_alternatives < 0 || options.n_alternatives > 10)
        throw InvalidInput(
            fmt::format("the number of alternatives must be from 0 to 10, not {}", options.n_alternatives));
    const auto require_in_range = [&](const std::pair<Index, Index>& pair, const char* name) {
        if (pair.first < 0 || pair.first >= n_source || pair.second < 0 || pair.second >= n_target)
            throw InvalidInput(fmt::format("{} ({}, {}) is out of range: the meshes have {} and {} vertices",
                                           name, pair.first, pair.second, n_source, n_target));
    };
    std::map<Index, Index> target_of_landmark;
    for (const auto& pair : options.landmarks) {
        require_in_range(pair, "landmark");
        const auto [known, is_new] = target_of_landmark.insert(pair);
        if (known->second != pair.second)
            throw InvalidInput(fmt::format(
                "landmarks contradict each other: source vertex {} is given two targets, {} and {}",
                pair.first, known->second, pair.second));
    }
    for (const auto& pair : options.excluded) {
        require_in_range(pair, "excluded pair");
        const auto known = target_of_landmark.find(pair.first);
        if (known != target_of_landmark.end() && known->second == pair.second)
            throw InvalidInput(
                fmt::format("the pair ({}, {}) is both a landmark and excluded", pair.first, pair.second));
    }
    if (options.initial &&
        (options.initial->source_size() != n_source || options.initial->target_size() != n_target))
        throw InvalidInput(
            fmt::format("the initial map goes from {} to {} vertices, but the meshes have {} and {}",
                        options.initial->source_size(), options.initial->target_size(), n_source, n_target));
    if (!options.up.allFinite() || !options.facing.allFinite())
        throw InvalidInput("the directions up and facing must be finite");
    if (options.symmetric && options.mirror == Mirror::never)
        throw InvalidInput("symmetric asks for the mirrored map, which mirror = never excludes");
    if (options.aligned && is_mirror_asked(options))
        throw InvalidInput(
            "aligned says that left stays left, symmetric exchanges left and right: "
            "give up and facing instead of aligned");
    const bool has_up = !options.up.isZero(0), has_facing = !options.facing.isZero(0);
    if (has_facing && !has_up) throw InvalidInput("the direction facing needs the direction up");
    if (has_facing && options.up.normalized().cross(options.facing.normalized()).norm() < 0.1)
        throw InvalidInput("the directions up and facing must not be parallel");
}

}  // namespace counterpart::spectral_match
