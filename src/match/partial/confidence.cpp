// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/partial/confidence.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace counterpart::partial_match {
namespace {

bool agree(const BentSource& a, const BentSource& b, std::size_t v, const Surface& whole, double distance) {
    return (whole.mesh.vertices.row(a.image[v]) - whole.mesh.vertices.row(b.image[v])).norm() < distance;
}

void add_mesh_warnings(const spectral_match::Preprocessed& mesh, const std::string& name,
                       std::vector<std::string>& sentences) {
    const auto add = [&](bool holds, const std::string& sentence) {
        if (holds) sentences.push_back(name + ": " + sentence);
    };
    add(mesh.was_inside_out, "inside out; its triangles were flipped for matching");
    add(mesh.n_one_sided > 0,
        "a part of the surface is one-sided, like a Moebius band; left and right are undefined there");
    add(mesh.n_components > 1,
        fmt::format("{} components; little is known of the distances between them", mesh.n_components));
    add(mesh.n_small_components > 0,
        fmt::format(
            "left out {} small components ({:.2g} % of the area); each of their vertices is matched like the "
            "nearest one",
            mesh.n_small_components, 100 * mesh.small_share));
}

// Infinite if nothing is matched.
double mean_of_matched(const PartialResult& result) {
    double sum = 0;
    Index n = 0;
    for (Index v = 0; v < result.confidence.size(); ++v) {
        if (result.target_from_source[v] == VertexMap::unmatched) continue;
        sum += result.confidence[v];
        ++n;
    }
    return n > 0 ? sum / n : std::numeric_limits<double>::infinity();
}

}  // namespace

double whole_confidence(const Fit& fit, double misfit, const ConfidenceTuning& tuning) {
    const double alike = 1 / (1 + std::exp(-(fit.score - tuning.half_score) / tuning.score_width));
    return alike / (1 + std::exp((misfit - tuning.half_misfit) / tuning.misfit_width));
}

double share_moved(const BentSource& a, const BentSource& b, const Surface& whole,
                   const ConfidenceTuning& tuning) {
    std::size_t moved = 0;
    for (std::size_t v = 0; v < a.image.size(); ++v)
        moved += agree(a, b, v, whole, tuning.same_place) ? 0U : 1U;
    return static_cast<double>(moved) / static_cast<double>(a.image.size());
}

Vector confidence(const Surface& part, const Surface& whole, const std::vector<Fit>& found, double misfit,
                  const ConfidenceTuning& tuning) {
    const Fit& best = found.front();
    const double all = whole_confidence(best, misfit, tuning);
    Vector result(part.mesh.n_vertices());
    for (Index v = 0; v < part.mesh.n_vertices(); ++v) {
        const auto i = static_cast<std::size_t>(v);
        double agreeing = 0, likelihoods = 0;
        for (const Fit& fit : found) {
            const double likelihood = std::exp((fit.total - best.total) / tuning.temperature);
            likelihoods += likelihood;
            if (agree(best.bent, fit.bent, i, whole, tuning.same_place)) agreeing += likelihood;
        }
        const double gap = (best.bent.positions.row(v) - whole.mesh.vertices.row(best.bent.image[i])).norm() /
                           tuning.gap_length;
        result[v] = all * agreeing / likelihoods * std::exp(-gap * gap);
    }
    return result;
}

std::vector<std::string> warnings(const PartialResult& result, const spectral_match::Preprocessed& source,
                                  const spectral_match::Preprocessed& target, double misfit,
                                  const ConfidenceTuning& tuning) {
    std::vector<std::string> sentences;
    add_mesh_warnings(source, "source", sentences);
    add_mesh_warnings(target, "target", sentences);
    const std::size_t n_of_meshes = sentences.size();
    if (result.score < tuning.poor_score)
        sentences.push_back(
            fmt::format("the surfaces look little alike where they are matched (score {:.2f}): they may not "
                        "show the same thing, or "
                        "their scales differ; do not rely on this map",
                        result.score));
    if (misfit > tuning.much_misfit)
        sentences.push_back(fmt::format(
            "{:.0f} % of a mesh lies where the other goes on and yet fits nothing there: the parts "
            "may not overlap, or not as they were matched; do not rely on this map without a look",
            100 * misfit));
    if (result.margin < tuning.close_margin)
        sentences.push_back(fmt::format(
            "the part fits elsewhere nearly as well (score {:.3f} against {:.3f}; {:.0f} % of it goes "
            "elsewhere): inspect both, or give landmarks",
            result.alternatives.empty() ? result.score - result.margin : result.alternatives[0].score,
            result.score, result.alternatives.empty() ? 100 : 100 * result.alternatives[0].moved));
    const double mean = mean_of_matched(result);
    if (sentences.size() == n_of_meshes && mean < tuning.unsure)
        sentences.push_back(
            fmt::format("the map as a whole is unsure (mean confidence {:.2f} where it matches): the meshes "
                        "may not show the "
                        "same thing, or "
                        "too little of it; do not rely on this map without a look",
                        mean));
    if (result.target_from_source.source_size() > 0 && count_matched(result.target_from_source) == 0)
        sentences.push_back("nothing of the source has a partner on the target: the meshes do not overlap");
    return sentences;
}

}  // namespace counterpart::partial_match
