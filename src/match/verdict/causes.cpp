// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/compare/geometry.hpp"

#include <counterpart/match/verdict.hpp>

#include <algorithm>

namespace counterpart {
namespace {

// Unlike shapes, where nothing fits; a symmetry, where two maps fit.
void add_of_shapes(const std::vector<Message>& messages, std::vector<Message>& causes) {
    const bool nothing_fits =
        contains(messages, MessageCode::poor_score) || contains(messages, MessageCode::misfit) ||
        contains(messages, MessageCode::unsure) ||
        std::any_of(messages.begin(), messages.end(), [](const Message& message) {
            return message.code == MessageCode::doubtful_vertices && message.severity == Severity::do_not_use;
        });
    if (nothing_fits)
        causes.push_back({MessageCode::unlike_shapes, Severity::caution, "the two are unlike shapes"});
    if (contains(messages, MessageCode::close_runner_up))
        causes.push_back({MessageCode::self_similar, Severity::caution,
                          "the shape is alike in itself (a symmetry, or parts that resemble each other)"});
}

}  // namespace

std::vector<Message> probable_causes(MeshView source, MeshView target, const std::vector<Message>& messages) {
    if (gravest(messages) == Severity::notice) return {};
    MeshComparison comparison;
    comparison::compare_geometry(source, target, comparison);
    std::vector<Message> causes;
    const auto take = [&](bool parts) {
        for (const Message& message : comparison.messages) {
            const bool is_part = message.code == MessageCode::openness_differs ||
                                 message.code == MessageCode::components_differ;
            if (message.severity != Severity::notice && is_part == parts) causes.push_back(message);
        }
    };
    take(true);
    add_of_shapes(messages, causes);
    take(false);
    return causes;
}

}  // namespace counterpart
