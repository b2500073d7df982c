// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include <counterpart/base/message.hpp>

#include <algorithm>

namespace counterpart {

std::string to_string(Severity severity) {
    switch (severity) {
        case Severity::notice:
            return "notice";
        case Severity::caution:
            return "caution";
        case Severity::do_not_use:
            return "do not use";
    }
    return "unknown";
}

std::string to_string(MessageCode code) {
    switch (code) {
        case MessageCode::merged_vertices:
            return "merged_vertices";
        case MessageCode::isolated_vertices:
            return "isolated_vertices";
        case MessageCode::duplicate_triangles:
            return "duplicate_triangles";
        case MessageCode::flipped_triangles:
            return "flipped_triangles";
        case MessageCode::one_sided:
            return "one_sided";
        case MessageCode::inside_out:
            return "inside_out";
        case MessageCode::non_manifold:
            return "non_manifold";
        case MessageCode::open_surface:
            return "open_surface";
        case MessageCode::several_components:
            return "several_components";
        case MessageCode::fragments:
            return "fragments";
        case MessageCode::small_components:
            return "small_components";
        case MessageCode::flat:
            return "flat";
        case MessageCode::sphere_like:
            return "sphere_like";
        case MessageCode::fused:
            return "fused";
        case MessageCode::welded:
            return "welded";
        case MessageCode::recut_polygons:
            return "recut_polygons";
        case MessageCode::reversed_triangles:
            return "reversed_triangles";
        case MessageCode::same_connectivity:
            return "same_connectivity";
        case MessageCode::connectivity_differs:
            return "connectivity_differs";
        case MessageCode::connectivity_undecided:
            return "connectivity_undecided";
        case MessageCode::same_order:
            return "same_order";
        case MessageCode::same_places:
            return "same_places";
        case MessageCode::same_layout:
            return "same_layout";
        case MessageCode::layout_overlaps:
            return "layout_overlaps";
        case MessageCode::components_differ:
            return "components_differ";
        case MessageCode::openness_differs:
            return "openness_differs";
        case MessageCode::scale_differs:
            return "scale_differs";
        case MessageCode::axes_differ:
            return "axes_differ";
        case MessageCode::mirror_image:
            return "mirror_image";
        case MessageCode::handedness_unknown:
            return "handedness_unknown";
        case MessageCode::self_similar:
            return "self_similar";
        case MessageCode::unlike_shapes:
            return "unlike_shapes";
        case MessageCode::weldable:
            return "weldable";
        case MessageCode::symmetric_connectivity:
            return "symmetric_connectivity";
        case MessageCode::mirrored_connectivity:
            return "mirrored_connectivity";
        case MessageCode::alike_parts:
            return "alike_parts";
        case MessageCode::interchangeable_components:
            return "interchangeable_components";
        case MessageCode::poor_score:
            return "poor_score";
        case MessageCode::close_runner_up:
            return "close_runner_up";
        case MessageCode::misfit:
            return "misfit";
        case MessageCode::unsure:
            return "unsure";
        case MessageCode::no_partners:
            return "no_partners";
        case MessageCode::few_partners:
            return "few_partners";
        case MessageCode::filled_vertices:
            return "filled_vertices";
        case MessageCode::doubtful_vertices:
            return "doubtful_vertices";
        case MessageCode::no_confidence:
            return "no_confidence";
        case MessageCode::by_position:
            return "by_position";
        case MessageCode::refined:
            return "refined";
        case MessageCode::against_request:
            return "against_request";
        case MessageCode::option_not_used:
            return "option_not_used";
        case MessageCode::shaded_flat:
            return "shaded_flat";
        case MessageCode::skeleton_stays:
            return "skeleton_stays";
        case MessageCode::turned_inside_out:
            return "turned_inside_out";
    }
    return "unknown";
}

std::string to_string(Subject subject) {
    switch (subject) {
        case Subject::map:
            return "map";
        case Subject::source:
            return "source";
        case Subject::target:
            return "target";
    }
    return "unknown";
}

std::string to_string(const Message& message) {
    const Subject subject = message.where.subject;
    return subject == Subject::map ? message.sentence : to_string(subject) + ": " + message.sentence;
}

Severity gravest(const std::vector<Message>& messages) {
    Severity result = Severity::notice;
    for (const Message& message : messages) result = std::max(result, message.severity);
    return result;
}

bool contains(const std::vector<Message>& messages, MessageCode code) {
    return std::any_of(messages.begin(), messages.end(),
                       [code](const Message& message) { return message.code == code; });
}

}  // namespace counterpart
