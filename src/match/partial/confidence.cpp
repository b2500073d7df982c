// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/partial/confidence.hpp"

#include "match/surface/notices.hpp"
#include "match/surface/trust.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

namespace counterpart::partial_match {
namespace {

bool agree(const BentSource& a, const BentSource& b, std::size_t v, const Surface& whole, double distance) {
    return (whole.mesh.vertices.row(a.image[v]) - whole.mesh.vertices.row(b.image[v])).norm() < distance;
}

using Messages = std::vector<Message>;

void add_on_mesh(const surface_match::Preprocessed& mesh, Subject subject, Messages& messages) {
    for (Message& notice : surface_match::notices_on(mesh, subject)) messages.push_back(std::move(notice));
    if (mesh.n_components > 1)
        messages.push_back(
            {MessageCode::several_components,
             Severity::notice,
             fmt::format("{} components; little is known of the distances between them", mesh.n_components),
             {subject}});
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

// How much a runner-up counts, against 1 for the map that was taken.
double likelihood_of(const Fit& fit, const Fit& best, const ConfidenceTuning& tuning) {
    const double by_total = std::exp((fit.total - best.total) / tuning.temperature);
    if (tuning.likeness_temperature == 0) return by_total;
    const double by_likeness = std::exp((fit.score - best.score) / tuning.likeness_temperature);
    return std::max(by_total, std::min(by_likeness, 1.0));
}

}  // namespace

double whole_confidence(const Fit& fit, const Finish& finish, const ConfidenceTuning& tuning) {
    using surface_match::trust;
    return trust(fit.score, tuning.half_score, tuning.score_width) *
           trust(-finish.misfit, -tuning.half_misfit, tuning.misfit_width) *
           trust(finish.share, tuning.half_share, tuning.share_width);
}

double share_moved(const BentSource& a, const BentSource& b, const Surface& whole,
                   const ConfidenceTuning& tuning) {
    std::size_t moved = 0;
    for (std::size_t v = 0; v < a.image.size(); ++v)
        moved += agree(a, b, v, whole, tuning.same_place) ? 0U : 1U;
    return static_cast<double>(moved) / static_cast<double>(a.image.size());
}

Vector confidence(const Surface& part, const Surface& whole, const std::vector<Fit>& found,
                  const Finish& finish, const ConfidenceTuning& tuning) {
    const Fit& best = found.front();
    const double all = whole_confidence(best, finish, tuning);
    Vector result(part.mesh.n_vertices());
    for (Index v = 0; v < part.mesh.n_vertices(); ++v) {
        const auto i = static_cast<std::size_t>(v);
        double agreeing = 0, likelihoods = 0;
        for (const Fit& fit : found) {
            const double likelihood = likelihood_of(fit, best, tuning);
            likelihoods += likelihood;
            if (agree(best.bent, fit.bent, i, whole, tuning.same_place)) agreeing += likelihood;
        }
        const double gap = (best.bent.positions.row(v) - whole.mesh.vertices.row(best.bent.image[i])).norm();
        result[v] = all * agreeing / likelihoods * surface_match::trust_at(gap, tuning.gap_length);
    }
    return result;
}

std::optional<Elsewhere> best_elsewhere(const std::vector<Fit>& found, const Surface& whole,
                                        const ConfidenceTuning& tuning) {
    for (std::size_t i = 1; i < found.size(); ++i) {
        const double moved = share_moved(found[0].bent, found[i].bent, whole, tuning);
        if (moved >= tuning.least_moved)
            return Elsewhere{found[i].score, found[0].total - found[i].total, moved};
    }
    return std::nullopt;
}

std::vector<Message> messages_on(const PartialResult& result, const surface_match::Preprocessed& source,
                                 const surface_match::Preprocessed& target, double misfit,
                                 const std::optional<Elsewhere>& elsewhere, const ConfidenceTuning& tuning) {
    Messages messages;
    add_on_mesh(source, Subject::source, messages);
    add_on_mesh(target, Subject::target, messages);
    const auto add = [&](bool holds, MessageCode code, Severity severity, const std::string& sentence) {
        if (holds) messages.push_back({code, severity, sentence});
    };
    add(result.score < tuning.poor_score, MessageCode::poor_score, Severity::do_not_use,
        fmt::format("the surfaces look little alike where they are matched (score {:.2f}): they may not show "
                    "the same thing, or their scales differ; do not rely on this map",
                    result.score));
    // Where all of one mesh has partners, it is the other that has more there.
    const bool one_fits = std::max(result.source_share, result.target_share) >= tuning.all_fits;
    add(misfit > tuning.much_misfit, MessageCode::misfit, one_fits ? Severity::notice : Severity::caution,
        fmt::format("{:.0f} % of a mesh lies where the other goes on and yet fits nothing there{}",
                    100 * misfit,
                    one_fits ? "" : ": the parts may not overlap, or not as they were matched"));
    if (elsewhere && elsewhere->behind < tuning.close_margin)
        add(true, MessageCode::close_runner_up, Severity::caution,
            fmt::format("the part fits elsewhere nearly as well (score {:.3f} against {:.3f}; {:.0f} % of it "
                        "goes elsewhere): inspect both, or give landmarks",
                        elsewhere->score, result.score, 100 * elsewhere->moved));
    const double mean = mean_of_matched(result);
    add(gravest(messages) == Severity::notice && mean < tuning.unsure, MessageCode::unsure, Severity::caution,
        fmt::format("the map as a whole is unsure (mean confidence {:.2f} where it matches): the meshes may "
                    "not show the same thing, or too little of it",
                    mean));
    add(result.target_from_source.source_size() > 0 && count_matched(result.target_from_source) == 0,
        MessageCode::no_partners, Severity::do_not_use,
        "nothing of the source has a partner on the target: the meshes do not overlap");
    return messages;
}

}  // namespace counterpart::partial_match
