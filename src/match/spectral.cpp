// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "base/parallel.hpp"
#include "match/spectral/pipeline.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/match/spectral.hpp>

#include <optional>

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
    if (!options.landmarks.empty() && options.landmarks.size() < 3)
        throw InvalidInput(fmt::format("at least 3 landmarks are needed, not {}", options.landmarks.size()));
    for (const auto& [s, t] : options.landmarks)
        if (s < 0 || static_cast<std::size_t>(s) >= n_source || t < 0 ||
            static_cast<std::size_t>(t) >= n_target)
            throw InvalidInput(
                fmt::format("landmark ({}, {}) is out of range: the meshes have {} and {} vertices", s, t,
                            n_source, n_target));
}

}  // namespace

SpectralShape::SpectralShape(MeshView mesh, const SpectralShapeOptions& options) {
    shape_ = with_threads(options.n_threads, [&, shape = checked(options)] {
        return std::make_shared<const PreparedShape>(prepare(mesh, shape));
    });
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
        return with_threads(options.n_threads, [&] {
            Stopwatch watch;
            std::optional<PreparedShape> a, b;
            const ProgressRange preparing = progress.part(0, 0.4);
            parallel_invoke([&] { a = prepare(source, preparation, {}, preparing); },
                            [&] { b = prepare(target, preparation, {}, preparing); });
            watch.lap("prepare");
            return match(*a, *b, options, {}, progress.part(0.4, 1), watch);
        });
    });
}

}  // namespace counterpart
