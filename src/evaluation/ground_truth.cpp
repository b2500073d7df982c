// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include <counterpart/base/errors.hpp>
#include <counterpart/evaluation/evaluate.hpp>

#include <fmt/format.h>

namespace counterpart {

GroundTruth truth_from_map(const VertexMap& target_from_source) {
    return truth_from_template(identity_map(target_from_source.source_size()), target_from_source);
}

GroundTruth truth_from_template(const VertexMap& source_from_template,
                                const VertexMap& target_from_template) {
    if (source_from_template.source_size() != target_from_template.source_size()) {
        throw InvalidInput(fmt::format(
            "the source names {} template points and the target {}: they do not belong to the same template",
            source_from_template.source_size(), target_from_template.source_size()));
    }
    GroundTruth truth;
    for (Index k = 0; k < source_from_template.source_size(); ++k) {
        const Index source = source_from_template[k], target = target_from_template[k];
        if (source != VertexMap::unmatched && target != VertexMap::unmatched)
            truth.pairs.emplace_back(source, target);
    }
    return truth;
}

GroundTruth sampled(const GroundTruth& truth, Index count) {
    if (count < 2)
        throw InvalidInput(fmt::format("a sample of the ground truth needs at least 2 pairs, not {}", count));
    if (truth.pairs.size() <= static_cast<std::size_t>(count)) return truth;
    const double last = static_cast<double>(truth.pairs.size() - 1), step = last / (count - 1);
    GroundTruth sample;
    for (Index i = 0; i + 1 < count; ++i)
        sample.pairs.push_back(truth.pairs[static_cast<std::size_t>(i * step)]);
    sample.pairs.push_back(truth.pairs.back());
    return sample;
}

}  // namespace counterpart
