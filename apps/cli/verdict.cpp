// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "verdict.hpp"

#include "compare_meshes.hpp"

#include <counterpart/mesh/adjacency.hpp>

#include <algorithm>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace counterpart::cli {
namespace {

// Below this a vertex's confidence means that it is not to be relied on (see SpectralResult).
constexpr double doubtful = 0.2;
// Share of doubtful vertices above which a map is worth a look, and above which it is not worth using.
constexpr double look_share = 0.05, reject_share = 0.5;

// Warnings that name one of the meshes are about what was read; the others are about the map.
bool is_about_map(const std::string& sentence) {
    return !sentence.starts_with("source: ") && !sentence.starts_with("target: ");
}

// The middle of the largest connected region of these vertices.
std::string place_of(const std::vector<char>& marked, const TriangleMesh& mesh) {
    const Adjacency adjacency(mesh);
    std::vector<char> seen(marked.size(), 0);
    std::vector<Index> largest;
    for (Index v = 0; v < mesh.n_vertices(); ++v) {
        if (!marked[static_cast<std::size_t>(v)] || seen[static_cast<std::size_t>(v)]) continue;
        std::vector<Index> region = {v};
        seen[static_cast<std::size_t>(v)] = 1;
        for (std::size_t i = 0; i < region.size(); ++i) {
            for (const Index w : adjacency.neighbors(region[i])) {
                if (!marked[static_cast<std::size_t>(w)] || seen[static_cast<std::size_t>(w)]) continue;
                seen[static_cast<std::size_t>(w)] = 1;
                region.push_back(w);
            }
        }
        if (region.size() > largest.size()) largest = std::move(region);
    }
    const Eigen::RowVector3d middle = Points(mesh.vertices(largest, Eigen::all)).colwise().mean();
    return fmt::format("most of them around ({:.4g}, {:.4g}, {:.4g})", middle[0], middle[1], middle[2]);
}

}  // namespace

Verdict verdict_on(const MatchOutcome& outcome, const TriangleMesh& source) {
    if (!outcome.failure.empty()) return {"do not use", outcome.failure};
    std::string why;
    for (const std::string& sentence : outcome.warnings)
        if (why.empty() && is_about_map(sentence)) why = sentence;
    const Vector& confidence = outcome.confidence;
    if (confidence.size() == 0 || confidence.maxCoeff() == 0)
        return {"check",
                why.empty() ? "this method does not tell how far to trust its map, so look at it" : why};

    std::vector<char> marked;
    for (Eigen::Index v = 0; v < confidence.size(); ++v)
        marked.push_back(outcome.target_from_source[static_cast<Index>(v)] != VertexMap::unmatched &&
                         confidence[v] < doubtful);
    const auto n_doubtful = std::count(marked.begin(), marked.end(), 1);
    const Index n = outcome.target_from_source.source_size(),
                n_unmatched = n - count_matched(outcome.target_from_source);
    if (n_unmatched > n / 2)
        why += fmt::format("{}{} of {} vertices have no partner", why.empty() ? "" : "; ", n_unmatched, n);
    const double share = static_cast<double>(n_doubtful) / static_cast<double>(marked.size());
    constexpr double nearly_all = 0.9;     // then no place says more than another
    constexpr double least_share = 0.005;  // that is not 0 % when rounded
    const std::string where = n_doubtful == 0 ? ""
                              : share > nearly_all
                                  ? "nearly all vertices are doubtful"
                                  : fmt::format("{} of the vertices {} doubtful, {}",
                                                share < least_share ? std::to_string(n_doubtful)
                                                                    : fmt::format("{:.0f} %", 100 * share),
                                                n_doubtful == 1 ? "is" : "are", place_of(marked, source));
    const auto with_where = [&](const std::string& reason) {
        return reason.empty() || where.empty() ? reason + where : reason + "; " + where;
    };
    const bool rejected = why.find("do not rely") != std::string::npos ||
                          why.find("little use") != std::string::npos || share > reject_share;
    if (rejected) return {"do not use", with_where(why)};
    if (!why.empty() || share > look_share) return {"check", with_where(why)};
    return {"use", ""};
}

Json Judgment::report() const {
    return {{"verdict", verdict.word}, {"verdict_reason", verdict.reason}, {"probable_causes", causes}};
}

Judgment judge(const MatchOutcome& outcome, const MeshPair& pair) {
    Judgment judgment{verdict_on(outcome, pair.source), {}};
    if (judgment.verdict.word != "use")
        judgment.causes =
            probable_causes(pair.source, pair.target, pair.source_file.string(), pair.target_file.string());
    return judgment;
}

void say(const CommonOptions& options, const Judgment& judgment) {
    say(options, judgment.verdict.sentence());
    if (!judgment.causes.empty())
        say(options,
            fmt::format("probable causes, the likeliest first: {}", fmt::join(judgment.causes, "; ")));
}

}  // namespace counterpart::cli
