// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "fill_map.hpp"

#include <counterpart/map/complete.hpp>

#include <fmt/format.h>

namespace counterpart::cli {

void fill_map(MatchOutcome& outcome, const MatchInput& input, const FillArguments& arguments) {
    if (!arguments.all && !arguments.max_edges) return;
    const VertexMap found = outcome.target_from_source;
    if (!outcome.source_from_target) outcome.source_from_target = invert(found);
    const Index n_found = count_matched(found);
    if (n_found == found.source_size()) return;
    if (count_matched(surface_map_of(found, input.target)) == 0) {
        outcome.summary.push_back("nothing to fill from: no vertex has a partner");
        return;
    }
    outcome.target_from_source =
        complete_map(found, input.source, input.target, {.max_edges = arguments.max_edges});
    const Index n_filled = count_matched(outcome.target_from_source) - n_found;
    outcome.summary.push_back(fmt::format("{} unmatched vertices filled from their neighbors", n_filled));
    const Index n_before = outcome.details.value("filled_vertices", 0);  // by auto, between those it found
    outcome.details["filled_vertices"] = n_before + n_filled;
}

}  // namespace counterpart::cli
