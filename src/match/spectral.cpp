// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "base/parallel.hpp"
#include "match/spectral/pipeline.hpp"
#include "match/spectral/stored_shape.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/match/spectral.hpp>

#include <map>

#include <fmt/format.h>

namespace counterpart {
namespace {

using namespace spectral_match;

PreparationOptions checked(const SpectralShapeOptions& options) {
    if (options.basis_size < 30 || options.basis_size > 500)
        throw InvalidInput(fmt::format("the basis size must be from 30 to 500, not {}", options.basis_size));
    if (options.n_samples < 200 || options.n_samples > 5000)
        throw InvalidInput(
            fmt::format("the number of samples must be from 200 to 5000, not {}", options.n_samples));
    return {.n_functions = options.basis_size, .n_samples = options.n_samples, .seed = options.seed};
}

void require_valid(const SpectralOptions& options, std::size_t n_source, std::size_t n_target) {
    if (options.n_alternatives < 0 || options.n_alternatives > 10)
        throw InvalidInput(
            fmt::format("the number of alternatives must be from 0 to 10, not {}", options.n_alternatives));
    const auto require_in_range = [&](const std::pair<Index, Index>& pair, const char* name) {
        if (pair.first < 0 || static_cast<std::size_t>(pair.first) >= n_source || pair.second < 0 ||
            static_cast<std::size_t>(pair.second) >= n_target)
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
    if (options.initial && (static_cast<std::size_t>(options.initial->source_size()) != n_source ||
                            static_cast<std::size_t>(options.initial->target_size()) != n_target))
        throw InvalidInput(
            fmt::format("the initial map goes from {} to {} vertices, but the meshes have {} and {}",
                        options.initial->source_size(), options.initial->target_size(), n_source, n_target));
    if (!options.up.allFinite() || !options.facing.allFinite())
        throw InvalidInput("the directions up and facing must be finite");
    if (options.aligned && options.symmetric)
        throw InvalidInput(
            "aligned says that left stays left, symmetric exchanges left and right: "
            "give up and facing instead of aligned");
    const bool has_up = !options.up.isZero(0), has_facing = !options.facing.isZero(0);
    if (has_facing && !has_up) throw InvalidInput("the direction facing needs the direction up");
    if (has_facing && options.up.normalized().cross(options.facing.normalized()).norm() < 0.1)
        throw InvalidInput("the directions up and facing must not be parallel");
}

}  // namespace

SpectralShape::SpectralShape(MeshView mesh, const SpectralShapeOptions& options) {
    shape_ = with_progress(options.progress, [&, shape = checked(options)](const ProgressRange& progress) {
        return with_threads(options.n_threads, [&] {
            return std::make_shared<const PreparedShape>(prepare(mesh, shape, {}, progress));
        });
    });
}

Index SpectralShape::n_vertices() const { return static_cast<Index>(shape_->origin.matched_of_input.size()); }

std::string SpectralShape::to_bytes() const { return spectral_match::to_bytes(*shape_); }

SpectralShape SpectralShape::from_bytes(std::string_view bytes) {
    return SpectralShape(std::make_shared<const PreparedShape>(shape_from_bytes(bytes)));
}

SpectralResult match_spectral(const SpectralShape& source, const SpectralShape& target,
                              const SpectralOptions& options) {
    const PreparedShape &a = *source.shape_, &b = *target.shape_;
    require_valid(options, a.origin.matched_of_input.size(), b.origin.matched_of_input.size());
    return with_progress(options.progress, [&](const ProgressRange& progress) {
        return with_threads(options.n_threads, [&] { return match(a, b, options, {}, progress); });
    });
}

SpectralResult match_spectral(MeshView source, MeshView target, const SpectralOptions& options,
                              const SpectralShapeOptions& shape_options) {
    const PreparationOptions preparation = checked(shape_options);
    require_valid(options, static_cast<std::size_t>(source.n_vertices()),
                  static_cast<std::size_t>(target.n_vertices()));
    return with_progress(options.progress, [&](const ProgressRange& progress) {
        return with_threads(options.n_threads,
                            [&] { return match(source, target, options, preparation, progress); });
    });
}

}  // namespace counterpart
