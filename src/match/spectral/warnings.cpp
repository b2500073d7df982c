// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/warnings.hpp"

#include "match/spectral/confidence.hpp"

#include <fmt/format.h>

namespace counterpart::spectral_match {
namespace {

using Sentences = std::vector<std::string>;

std::string counted(Index n, const std::string& noun, const std::string& plural) {
    return fmt::format("{} {}", n, n == 1 ? noun : plural);
}

void add_input_warnings(const Preprocessed& input, const std::string& name, Index many_components,
                        Sentences& sentences) {
    const auto add = [&](bool holds, const std::string& sentence) {
        if (holds) sentences.push_back(name + ": " + sentence);
    };
    add(input.n_merged > 0,
        fmt::format("merged {}", counted(input.n_merged, "duplicate vertex", "duplicate vertices")));
    add(input.n_unreferenced > 0, fmt::format("{} in no triangle; each is matched like the nearest vertex",
                                              counted(input.n_unreferenced, "vertex", "vertices")));
    add(input.n_duplicate_triangles > 0,
        fmt::format("left out {}",
                    counted(input.n_duplicate_triangles, "duplicate triangle", "duplicate triangles")));
    add(input.n_disagreeing > 0,
        fmt::format("flipped {}", counted(input.n_disagreeing, "inconsistently oriented triangle",
                                          "inconsistently oriented triangles")));
    add(input.n_one_sided > 0,
        "part of the surface is one-sided, like a Moebius band; left and right are undefined there");
    add(input.was_inside_out, "inside out; its triangles were flipped for matching");
    add(input.n_nonmanifold_edges > 0,
        fmt::format("{} with more than two triangles; the surface is treated as cut there",
                    counted(input.n_nonmanifold_edges, "edge", "edges")));
    add(input.n_boundary_loops > 0 && input.n_components < many_components,
        fmt::format("open surface with {}; the match is less reliable near the boundary",
                    counted(input.n_boundary_loops, "boundary loop", "boundary loops")));
    add(input.n_components > 1 && input.n_components < many_components,
        fmt::format("{} components; the smaller ones are linked to the largest and matched only roughly",
                    input.n_components));
    add(input.n_components >= many_components,
        fmt::format("mostly disconnected fragments ({} components); the map is of little use unless they are "
                    "joined first",
                    input.n_components));
    add(input.n_small_components > 0,
        fmt::format("left out {} ({:.2g} % of the area); each vertex is matched like the nearest one",
                    counted(input.n_small_components, "small component", "small components"),
                    100 * input.small_share));
}

void add_shape_warnings(const PreparedShape& shape, const std::string& name, double sphere_ratio,
                        Sentences& sentences) {
    if (shape.flat)
        sentences.push_back(
            fmt::format("{}: flat; its two sides cannot be told apart, and mirrored maps are as good", name));
    if (shape.basis.size() <= 3) return;
    const double first = shape.basis.eigenvalues[1], third = shape.basis.eigenvalues[3];
    if (third < sphere_ratio * first)
        sentences.push_back(
            fmt::format("{}: nearly symmetric about every axis (sphere-like: its lowest eigenvalues repeat); "
                        "many maps are equally good, give landmarks to choose one",
                        name));
}

void add_score_warnings(const Level& whole, const Polished& found, Sentences& sentences) {
    const ConfidenceTuning& tuning = whole.tuning.confidence;
    const double score = found.best.rank();
    if (score < tuning.poor_score)
        sentences.push_back(
            fmt::format("no map preserves relief and normals well (score {:.2f}): they may not be comparable "
                        "shapes, do not rely on this map",
                        score));
    if (found.runners_up.empty()) return;
    const RunnerUp& next = found.runners_up.front();
    if (next.behind < tuning.close_margin)
        sentences.push_back(
            fmt::format("the runner-up is nearly as good (score {:.3f} against {:.3f}; {}): inspect both, or "
                        "give landmarks",
                        score - next.behind, score, describe(whole, found.best, next.map)));
}

}  // namespace

Sentences warnings(const Level& whole, const Polished& found) {
    const ConfidenceTuning& tuning = whole.tuning.confidence;
    Sentences sentences;
    const Preprocessed &source = whole.a.shape.origin, &target = whole.b.shape.origin;
    add_input_warnings(source, "source", tuning.many_components, sentences);
    add_input_warnings(target, "target", tuning.many_components, sentences);
    add_shape_warnings(whole.a.shape, "source", tuning.sphere_ratio, sentences);
    add_shape_warnings(whole.b.shape, "target", tuning.sphere_ratio, sentences);
    if (source.n_components != target.n_components)
        sentences.push_back(
            fmt::format("the source has {} and the target {}: some parts may have no counterpart",
                        counted(source.n_components, "component", "components"), target.n_components));
    if ((source.n_boundary_loops > 0) != (target.n_boundary_loops > 0))
        sentences.push_back(
            fmt::format("the {} is open and the {} closed: what is missing in one is matched all the same",
                        source.n_boundary_loops > 0 ? "source" : "target",
                        source.n_boundary_loops > 0 ? "target" : "source"));
    add_score_warnings(whole, found, sentences);
    return sentences;
}

}  // namespace counterpart::spectral_match
