// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/compare/geometry.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/match/compare.hpp>
#include <counterpart/match/exact.hpp>

#include <algorithm>

#include <fmt/format.h>

namespace counterpart {
namespace {

void compare_connectivity(MeshView source, MeshView target, MeshComparison& result) {
    const auto add = [&](MessageCode code, std::string sentence) {
        result.messages.push_back({code, Severity::notice, std::move(sentence)});
    };
    std::optional<Message> order = same_order(source, target);
    result.same_order = order.has_value();
    if (order) result.messages.push_back(*std::move(order));
    try {
        const ExactResult exact = match_exact(source, target, {.allow_mirror = true});
        result.same_connectivity = exact.identical;
        if (exact.identical) {
            add(MessageCode::same_connectivity,
                "the same connectivity: matching is exact, and reordering restores the order");
            result.mirrored = exact.mirrored;
            if (exact.mirrored) add(MessageCode::mirror_image, "the target is a mirror image of the source");
            return;
        }
        add(MessageCode::connectivity_differs, "connectivity differs: " + exact.difference);
        add(MessageCode::handedness_unknown,
            "whether one is a mirror image of the other does not show where connectivity differs: matching "
            "by shape looks at both readings");
    } catch (const NumericalError& error) {
        add(MessageCode::connectivity_undecided,
            fmt::format("the connectivity does not decide ({})", error.what()));
    }
    if (auto message = comparison::weldable(source, target)) result.messages.push_back(std::move(*message));
}

}  // namespace

MeshComparison compare(MeshView source, MeshView target) {
    require_valid(source);
    require_valid(target);
    MeshComparison result;
    compare_connectivity(source, target, result);
    comparison::compare_geometry(source, target, result);
    std::stable_sort(result.messages.begin(), result.messages.end(),
                     [](const Message& a, const Message& b) { return a.severity > b.severity; });
    return result;
}

}  // namespace counterpart
