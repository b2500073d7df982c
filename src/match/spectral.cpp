// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "base/parallel.hpp"
#include "match/spectral/pipeline.hpp"
#include "match/spectral/requests.hpp"
#include "match/spectral/stored_shape.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/match/spectral.hpp>

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
    require_valid(options, static_cast<Index>(a.origin.matched_of_input.size()),
                  static_cast<Index>(b.origin.matched_of_input.size()));
    return with_progress(options.progress, [&](const ProgressRange& progress) {
        return with_threads(options.n_threads, [&] { return match(a, b, options, {}, progress); });
    });
}

SpectralResult match_spectral(MeshView source, MeshView target, const SpectralOptions& options,
                              const SpectralShapeOptions& shape_options) {
    const PreparationOptions preparation = checked(shape_options);
    require_valid(options, source.n_vertices(), target.n_vertices());
    return with_progress(options.progress, [&](const ProgressRange& progress) {
        return with_threads(options.n_threads,
                            [&] { return match(source, target, options, preparation, progress); });
    });
}

}  // namespace counterpart
