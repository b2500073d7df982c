// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include <counterpart/base/errors.hpp>
#include <counterpart/evaluation/evaluate.hpp>

#include <vector>

#include <fmt/format.h>

namespace counterpart {

OverlapReport evaluate_overlap(const VertexMap& target_from_source, const GroundTruth& truth) {
    std::vector<char> paired(static_cast<std::size_t>(target_from_source.source_size()), 0);
    for (const auto& [s, t] : truth.pairs) {
        if (s < 0 || s >= target_from_source.source_size())
            throw InvalidInput(
                fmt::format("the ground truth names source vertex {}, but the map has {} vertices", s,
                            target_from_source.source_size()));
        paired[static_cast<std::size_t>(s)] = 1;
    }
    OverlapReport report;
    for (Index v = 0; v < target_from_source.source_size(); ++v) {
        const bool is_matched = target_from_source[v] != VertexMap::unmatched;
        if (paired[static_cast<std::size_t>(v)] != 0) {
            ++report.n_paired;
            report.n_missed += is_matched ? 0 : 1;
        } else {
            ++report.n_unpaired;
            report.n_invented += is_matched ? 1 : 0;
        }
    }
    const auto share = [](Index part, Index all) { return all > 0 ? static_cast<double>(part) / all : 0.0; };
    report.missed = share(report.n_missed, report.n_paired);
    report.invented = share(report.n_invented, report.n_unpaired);
    const Index any = report.n_paired + report.n_invented;
    report.iou = any > 0 ? share(report.n_paired - report.n_missed, any) : 1;
    return report;
}

}  // namespace counterpart
