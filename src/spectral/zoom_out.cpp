// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "base/parallel.hpp"
#include "spectral/bijective_zoom_out.hpp"
#include "spectral/require_valid.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/spectral/zoom_out.hpp>

#include <algorithm>
#include <cmath>

namespace counterpart {
namespace {

// At unit area.
spectral::SpectralPoints spectral_points(const EigenBasis& basis) {
    const double area = basis.mass.sum();
    return {(basis.eigenfunctions * std::sqrt(area)).cast<float>(),
            (basis.eigenvalues.cwiseMax(0.0) * area).cwiseSqrt().cast<float>()};
}

void require_whole(const VertexMap& map, const EigenBasis& from, const EigenBasis& to) {
    if (map.source_size() != from.mass.size() || map.target_size() != to.mass.size())
        throw InvalidInput("zoom_out: the map and the bases belong to different meshes");
    if (count_matched(map) < map.source_size()) throw InvalidInput("zoom_out: every vertex must be matched");
}

std::vector<int> sizes(const ZoomOutOptions& options, int most) {
    const int last = std::min(options.last, most);
    std::vector<int> result;
    for (int k = std::min(options.first, last); k < last; k += std::min(options.step, last - k))
        result.push_back(k);
    result.push_back(last);
    return result;
}

}  // namespace

ZoomOutResult zoom_out(const VertexMap& target_from_source, const EigenBasis& source,
                       const EigenBasis& target, const ZoomOutOptions& options,
                       const VertexMap& source_from_target) {
    if (options.first < 2 || options.last < options.first || options.step < 1)
        throw InvalidInput("zoom_out: needs 2 <= first <= last and a step of at least 1");
    spectral::require_valid(source);
    spectral::require_valid(target);
    require_whole(target_from_source, source, target);
    if (source_from_target.source_size() > 0) require_whole(source_from_target, target, source);
    return with_threads(options.n_threads, [&] {
        ZoomOutResult result{target_from_source, source_from_target, {}};
        const std::vector<int> steps = sizes(options, std::min(source.size(), target.size()));
        if (result.source_from_target.source_size() == 0)
            result.source_from_target =
                vertex_map(functional_map(target_from_source, source, target, steps.front()).transpose(),
                           target, source);
        const auto report_step = [&](std::size_t i) {
            report_progress(options.progress, static_cast<double>(i + 1) / static_cast<double>(steps.size()));
        };
        if (options.bijective) {
            spectral::PairedMaps maps{result.target_from_source.image(), result.source_from_target.image()};
            const spectral::SpectralPoints a = spectral_points(source), b = spectral_points(target);
            for (std::size_t i = 0; i < steps.size(); ++i) {
                maps = spectral::zoom_out(a, b, std::move(maps), {steps[i]}, options.masked);
                report_step(i);
            }
            result.target_from_source = VertexMap(std::move(maps.b_from_a), target_from_source.target_size());
            result.source_from_target = VertexMap(std::move(maps.a_from_b), target_from_source.source_size());
        } else {
            for (std::size_t i = 0; i < steps.size(); ++i) {
                const int k = steps[i];
                result.target_from_source =
                    vertex_map(functional_map(result.target_from_source, source, target, k), source, target);
                result.source_from_target =
                    vertex_map(functional_map(result.source_from_target, target, source, k), target, source);
                report_step(i);
            }
        }
        result.source_functions_from_target =
            functional_map(result.target_from_source, source, target, steps.back());
        return result;
    });
}

}  // namespace counterpart
