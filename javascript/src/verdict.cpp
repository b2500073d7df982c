// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "verdict.hpp"

#include <fmt/format.h>

namespace counterpart::javascript {
namespace {

// Below this a vertex's confidence means that it is not to be relied on (see SpectralResult).
constexpr double doubtful = 0.2;
// Share of doubtful vertices above which a map is worth a look, and above which it is not worth using.
constexpr double look_share = 0.05, reject_share = 0.5;

}  // namespace

Verdict verdict_on(const MatchResult& result, MeshView source) {
    std::string why = result.warnings.empty() ? "" : result.warnings.front();
    if (result.confidence.maxCoeff() == 0)
        return {"check", why.empty() ? "this method does not tell how far to trust its map, so look at it" : why};
    const Index n = source.n_vertices(), n_unmatched = n - count_matched(result.target_from_source);
    if (n_unmatched > n / 2)
        why += fmt::format("{}{} of {} vertices have no partner", why.empty() ? "" : "; ", n_unmatched, n);
    Index n_doubtful = 0;
    for (Index v = 0; v < n; ++v)
        if (result.target_from_source[v] != VertexMap::unmatched && result.confidence[v] < doubtful) ++n_doubtful;
    const double share = static_cast<double>(n_doubtful) / n;
    if (share > look_share)
        why += fmt::format("{}{:.0f} % of the vertices are doubtful", why.empty() ? "" : "; ", 100 * share);
    const bool rejected = why.find("do not rely") != std::string::npos ||
                          why.find("little use") != std::string::npos || share > reject_share;
    return {rejected ? "do not use" : why.empty() ? "use" : "check", why};
}

}  // namespace counterpart::javascript
