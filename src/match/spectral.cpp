// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "base/parallel.hpp"
#include "match/spectral/choice.hpp"
#include "match/spectral/doubts.hpp"
#include "match/spectral/judgement.hpp"
#include "match/spectral/local_search.hpp"
#include "match/spectral/refinement.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/base/stopwatch.hpp>
#include <counterpart/match/spectral.hpp>

#include <algorithm>
#include <limits>
#include <optional>

#include <fmt/format.h>
#include <tbb/parallel_invoke.h>

namespace counterpart {
namespace {

using namespace spectral_match;

constexpr double close_margin = 0.05, poor_score = 0.2, mirror_margin = 0.1;

ShapeOptions checked(const SpectralShapeOptions& options) {
    if (options.basis_size < 30 || options.basis_size > 500)
        throw InvalidInput("the basis size must be from 30 to 500");
    if (options.n_samples < 200 || options.n_samples > 5000)
        throw InvalidInput("the number of samples must be from 200 to 5000");
    return {.n_functions = options.basis_size, .n_samples = options.n_samples, .seed = options.seed};
}

// The options with their landmarks as vertices of the cores.
SpectralOptions checked(SpectralOptions options, const Core& source, const Core& target) {
    if (options.n_alternatives < 0 || options.n_alternatives > 10)
        throw InvalidInput("the number of alternatives must be from 0 to 10");
    if (!options.landmarks.empty() && options.landmarks.size() < 3)
        throw InvalidInput(fmt::format("at least 3 landmarks are needed, not {}", options.landmarks.size()));
    const auto n_source = static_cast<Index>(source.core_of_input.size()),
               n_target = static_cast<Index>(target.core_of_input.size());
    for (auto& [s, t] : options.landmarks) {
        if (s < 0 || s >= n_source || t < 0 || t >= n_target)
            throw InvalidInput(
                fmt::format("landmark ({}, {}) is out of range: the meshes have {} and {} vertices", s, t,
                            n_source, n_target));
        s = source.core_of_input[static_cast<std::size_t>(s)];
        t = target.core_of_input[static_cast<std::size_t>(t)];
    }
    return options;
}

VertexMap vertex_map(std::vector<Index> image, const Shape& target) {
    return {std::move(image), target.mesh.n_vertices()};
}

void add_alternatives(SpectralResult& result, const SampledPair& pair,
                      const std::vector<Candidate>& candidates, int count) {
    for (std::size_t i = 1; i < candidates.size() && i <= static_cast<std::size_t>(count); ++i) {
        const PairedMaps maps = match_points_nearby(pair.a, pair.b, candidates[i].functional,
                                                    spread(pair.a, pair.b, candidates[i].maps), 1);
        result.alternatives.push_back({vertex_map(maps.b_from_a, pair.b), candidates[i].scores.total,
                                       describe(pair, candidates[0], candidates[i])});
    }
}

void add_warnings(SpectralResult& result, const SampledPair& pair, const std::vector<Candidate>& candidates) {
    result.warnings = doubts(pair.a, pair.b);
    if (result.score < poor_score)
        result.warnings.push_back(
            fmt::format("no map keeps the shapes' distances and curvature well (score {:.2f}): they may not "
                        "be the same kind of thing, do not rely on this map",
                        result.score));
    if (result.margin < close_margin)
        result.warnings.push_back(fmt::format(
            "the runner-up is nearly as good (score {:.3f} against {:.3f}; {}): look at both, or "
            "give landmarks",
            candidates[1].scores.total, result.score, describe(pair, candidates[0], candidates[1])));
}

SpectralResult match_shapes(const Shape& source, const Shape& target, const SpectralOptions& options,
                            Stopwatch watch) {
    constexpr std::size_t n_coarse_samples = 300, n_candidates = 24, n_finalists = 5;
    constexpr double coarse_radius = 0.3;
    const SampledPair coarse(source, target, n_coarse_samples, coarse_radius);
    std::vector<Candidate> candidates = find_candidates(coarse, options.landmarks, n_candidates);
    watch.lap("candidates");
    report(options.progress, 0.6);
    const auto n_asked = static_cast<std::size_t>(options.n_alternatives) + 1;
    candidates = choose(source, target, std::move(candidates), std::max(n_finalists, n_asked));
    const SampledPair pair(source, target, std::max(source.samples.size(), target.samples.size()), 0);
    watch.lap("choose");
    report(options.progress, 0.75);

    SpectralResult result;
    const Candidate& best = candidates.front();
    PairedMaps maps = refine(source, target, best).maps;
    watch.lap("refine");
    report(options.progress, 0.95);
    result.score = best.scores.total;
    result.margin = candidates.size() > 1 ? result.score - candidates[1].scores.total
                                          : std::numeric_limits<double>::infinity();
    result.confidence = confidence(pair, maps, candidates);
    add_alternatives(result, pair, candidates, options.n_alternatives);
    result.target_from_source = vertex_map(std::move(maps.b_from_a), target);
    result.source_from_target = vertex_map(std::move(maps.a_from_b), source);
    add_warnings(result, pair, candidates);
    watch.lap("judge");
    result.stages = watch.stages();
    report(options.progress, 1);
    return result;
}

// The matched parts' result as one of the whole inputs.
SpectralResult between_inputs(SpectralResult result, const Core& source, const Core& target) {
    result.target_from_source = between_inputs(result.target_from_source, source, target);
    result.source_from_target = between_inputs(result.source_from_target, target, source);
    for (SpectralAlternative& other : result.alternatives)
        other.target_from_source = between_inputs(other.target_from_source, source, target);
    result.confidence = Vector(result.confidence(source.core_of_input));
    for (const Index v : source.left_out) result.confidence[v] = 0;
    return result;
}

SpectralResult match_either_side(const Shape& source, const Shape& target, const SpectralOptions& given,
                                 const Stopwatch& watch) {
    const SpectralOptions options = checked(given, source.core, target.core);
    if (options.symmetric)
        return between_inputs(match_shapes(source, mirrored(target), options, watch), source.core,
                              target.core);
    SpectralResult result = match_shapes(source, target, options, watch);
    // One inside out: wound the wrong way, or the mirror image of what it was. The better map tells.
    if (source.core.was_inside_out != target.core.was_inside_out) {
        SpectralResult other = match_shapes(source, mirrored(target), options, watch);
        if (other.score > result.score + mirror_margin) {
            other.warnings.push_back(fmt::format(
                "one mesh is the mirror image of the other (score {:.2f} against {:.2f} as it is): "
                "left is matched with what was left",
                other.score, result.score));
            result = std::move(other);
        }
    }
    return between_inputs(std::move(result), source.core, target.core);
}

}  // namespace

SpectralShape::SpectralShape(const TriangleMesh& mesh, const SpectralShapeOptions& options) {
    data_ = with_threads(options.n_threads, [&, shape = checked(options)] {
        return std::make_shared<const Shape>(prepare(mesh, shape));
    });
}

SpectralResult match_spectral(const SpectralShape& source, const SpectralShape& target,
                              const SpectralOptions& options) {
    return with_threads(options.n_threads, [&] {
        return match_either_side(source.data(), target.data(), options, Stopwatch());
    });
}

SpectralResult match_spectral(const TriangleMesh& source, const TriangleMesh& target,
                              const SpectralOptions& options, const SpectralShapeOptions& shape_options) {
    Stopwatch watch;
    const ShapeOptions shape = checked(shape_options);
    return with_threads(options.n_threads, [&] {
        std::optional<Shape> a, b;
        tbb::parallel_invoke([&] { a = prepare(source, shape); }, [&] { b = prepare(target, shape); });
        watch.lap("prepare");
        report(options.progress, 0.4);
        return match_either_side(*a, *b, options, watch);
    });
}

}  // namespace counterpart
