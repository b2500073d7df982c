// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/messages.hpp"

#include "match/spectral/confidence.hpp"
#include "match/surface/notices.hpp"
#include "match/surface/openness.hpp"

#include <counterpart/mesh/analyze.hpp>

#include <cstdlib>
#include <optional>
#include <utility>

#include <fmt/format.h>

namespace counterpart::spectral_match {
namespace {

using Messages = std::vector<Message>;
using surface_match::counted;

void add_on_shape(const PreparedShape& shape, Subject subject, double sphere_ratio, Messages& messages) {
    if (shape.flat)
        messages.push_back({MessageCode::flat,
                            Severity::notice,
                            "flat; its two sides cannot be told apart, and mirrored maps are as good",
                            {subject}});
    if (shape.basis.size() <= 3) return;
    const double first = shape.basis.eigenvalues[1], third = shape.basis.eigenvalues[3];
    if (third < sphere_ratio * first)
        messages.push_back({MessageCode::sphere_like,
                            Severity::caution,
                            "nearly symmetric about every axis (sphere-like: its lowest eigenvalues repeat); "
                            "many maps are equally good, give landmarks to choose one",
                            {subject}});
}

const TriangleMesh& matched_mesh(const PreparedShape& shape) {
    return shape.full ? shape.full->mesh : shape.mesh;
}

// A boundary of no length, where vertices of the one lie at the place of others, is no opening.
void add_on_openness(const Level& whole, Messages& messages) {
    const Preprocessed &source = whole.a.shape.origin, &target = whole.b.shape.origin;
    if ((source.n_boundary_loops > 0) == (target.n_boundary_loops > 0)) return;
    const bool source_is_open = source.n_boundary_loops > 0;
    if (!surface_match::has_opening(matched_mesh(source_is_open ? whole.a.shape : whole.b.shape))) return;
    messages.push_back(
        {MessageCode::openness_differs, Severity::caution,
         fmt::format("the {} is open and the {} closed: what is missing in one is matched all "
                     "the same",
                     source_is_open ? "source" : "target", source_is_open ? "target" : "source")});
}

// Of all components; none where one is open or not manifold.
std::optional<Index> genus(const TriangleMesh& mesh) {
    Index sum = 0;
    for (const ComponentReport& component : analyze(mesh).components) {
        if (component.n_boundary_loops > 0 || !component.genus()) return std::nullopt;
        sum += *component.genus();
    }
    return sum;
}

// Where limbs touch and are fused in one mesh, an arm lies along the body, and the map may send both
// elsewhere.
void add_on_genus(const Level& whole, double score, Messages& messages) {
    if (score >= whole.tuning.confidence.doubtful_fused_score ||
        whole.a.shape.origin.n_components != whole.b.shape.origin.n_components)
        return;
    const std::optional<Index> of_source = genus(matched_mesh(whole.a.shape)),
                               of_target = genus(matched_mesh(whole.b.shape));
    if (!of_source || !of_target || *of_source == *of_target) return;
    const Index more = *of_target - *of_source;
    messages.push_back(
        {MessageCode::fused,
         Severity::caution,
         fmt::format("{} through it than the {} has: where limbs touch and are fused, the map may be wrong",
                     counted(std::abs(more), "more hole", "more holes"), more > 0 ? "source" : "target"),
         {more > 0 ? Subject::target : Subject::source}});
}

void add_on_score(const Level& whole, const Polished& found, Messages& messages) {
    const ConfidenceTuning& tuning = whole.tuning.confidence;
    const double score = found.best.rank();
    if (score < tuning.poor_score)
        messages.push_back(
            {MessageCode::poor_score, Severity::do_not_use,
             fmt::format(
                 "no map preserves relief and normals well (score {:.2f}): they may not be comparable "
                 "shapes, do not rely on this map",
                 score)});
    else if (score < tuning.doubtful_score)
        messages.push_back(
            {MessageCode::poor_score, Severity::caution,
             fmt::format("relief and normals are preserved less than by most right maps (score {:.2f}, those "
                         "have {:.2g} and more)",
                         score, tuning.doubtful_score)});
    if (found.runners_up.empty()) return;
    const RunnerUp& next = found.runners_up.front();
    if (next.behind >= tuning.close_margin) return;
    // A runner-up that only moves a tail or an ear lowers the confidence there, which says enough.
    const Departure differs = departure(whole, found.best, next.map);
    messages.push_back(
        {MessageCode::close_runner_up,
         differs.moved > tuning.much_moved || score < tuning.doubtful_close_score ? Severity::caution
                                                                                  : Severity::notice,
         fmt::format("the runner-up is nearly as good (score {:.3f} against {:.3f}; {}): inspect both, or "
                     "give landmarks",
                     score - next.behind, score, differs.words)});
}

}  // namespace

Messages messages_on(const Preprocessed& mesh, Subject subject, Index fragments_from) {
    Messages messages = surface_match::notices_on(mesh, subject);
    const auto add = [&](bool holds, MessageCode code, Severity severity, const std::string& sentence) {
        if (holds) messages.push_back({code, severity, sentence, {subject}});
    };
    add(mesh.n_boundary_loops > 0 && mesh.n_components < fragments_from, MessageCode::open_surface,
        Severity::notice,
        fmt::format("open surface with {}; the match is less reliable near the boundary",
                    counted(mesh.n_boundary_loops, "boundary loop", "boundary loops")));
    add(mesh.n_components > 1 && mesh.n_components < fragments_from, MessageCode::several_components,
        Severity::notice,
        fmt::format("{} components; the smaller ones are linked to the largest and matched only roughly",
                    mesh.n_components));
    add(mesh.n_components >= fragments_from, MessageCode::fragments, Severity::do_not_use,
        fmt::format("mostly disconnected fragments ({} components); the map is of little use unless they are "
                    "joined first",
                    mesh.n_components));
    return messages;
}

Messages messages_on(const Level& whole, const Polished& found) {
    const ConfidenceTuning& tuning = whole.tuning.confidence;
    const Preprocessed &source = whole.a.shape.origin, &target = whole.b.shape.origin;
    Messages messages = messages_on(source, Subject::source, tuning.many_components);
    const Messages of_target = messages_on(target, Subject::target, tuning.many_components);
    messages.insert(messages.end(), of_target.begin(), of_target.end());
    add_on_shape(whole.a.shape, Subject::source, tuning.sphere_ratio, messages);
    add_on_shape(whole.b.shape, Subject::target, tuning.sphere_ratio, messages);
    if (source.n_components != target.n_components)
        messages.push_back(
            {MessageCode::components_differ, Severity::caution,
             fmt::format("the source has {} and the target {}: some parts may have no counterpart",
                         counted(source.n_components, "component", "components"), target.n_components)});
    add_on_openness(whole, messages);
    add_on_genus(whole, found.best.rank(), messages);
    add_on_score(whole, found, messages);
    return messages;
}

}  // namespace counterpart::spectral_match
