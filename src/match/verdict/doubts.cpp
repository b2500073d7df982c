// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/verdict/doubts.hpp"

#include "base/to_size.hpp"

#include <counterpart/mesh/adjacency.hpp>

#include <algorithm>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace counterpart::judgment {
namespace {

// Below this a vertex's confidence means that it is not to be relied on (see SpectralResult).
constexpr double doubtful = 0.2;
// Share of doubtful vertices worth a word, above which a map is worth a look, and above which it is not worth
// using.
constexpr double word_share = 0.005, look_share = 0.1, reject_share = 0.5;

// The middle of the largest connected region of these vertices.
Eigen::RowVector3d middle_of(const std::vector<Index>& vertices, MeshView mesh) {
    std::vector<char> left(to_size(mesh.n_vertices()), 0);
    for (const Index v : vertices) left[to_size(v)] = 1;
    const Adjacency adjacency(mesh);
    std::vector<Index> largest;
    for (const Index v : vertices) {
        if (left[to_size(v)] == 0) continue;
        std::vector<Index> region = {v};
        left[to_size(v)] = 0;
        for (std::size_t i = 0; i < region.size(); ++i) {
            for (const Index w : adjacency.neighbors(region[i])) {
                if (left[to_size(w)] == 0) continue;
                left[to_size(w)] = 0;
                region.push_back(w);
            }
        }
        if (region.size() > largest.size()) largest = std::move(region);
    }
    return Points(mesh.vertices(largest, Eigen::all)).colwise().mean();
}

std::string place(const std::vector<Index>& vertices, double share, MeshView mesh) {
    constexpr double nearly_all = 0.9;  // then no place says more than another
    if (share > nearly_all) return "nearly all vertices are doubtful";
    const Eigen::RowVector3d middle = middle_of(vertices, mesh);
    return fmt::format(
        "{} of the vertices {} doubtful, most of them around ({:.4g}, {:.4g}, {:.4g})",
        share < word_share ? std::to_string(vertices.size()) : fmt::format("{:.0f} %", 100 * share),
        vertices.size() == 1 ? "is" : "are", middle[0], middle[1], middle[2]);
}

}  // namespace

std::vector<Message> doubts(const VertexMap& target_from_source, const Vector& confidence, MeshView source,
                            double target_share) {
    std::vector<Message> messages;
    const Index n = target_from_source.source_size(), n_matched = count_matched(target_from_source);
    if (n_matched == 0) {
        messages.push_back({MessageCode::no_partners, Severity::do_not_use, "no vertex has a partner"});
        return messages;
    }
    if (2 * n_matched < n)
        messages.push_back({MessageCode::few_partners,
                            target_share < 0.5 ? Severity::caution : Severity::notice,
                            fmt::format("{} of {} vertices have no partner", n - n_matched, n)});
    if (confidence.size() == 0 || confidence.maxCoeff() == 0) {
        messages.push_back({MessageCode::no_confidence, Severity::caution,
                            "this method does not tell how far to trust its map, so look at it"});
        return messages;
    }
    std::vector<Index> vertices;
    for (Index v = 0; v < n; ++v)
        if (target_from_source[v] != VertexMap::unmatched && confidence[v] < doubtful) vertices.push_back(v);
    const double share = static_cast<double>(vertices.size()) / n_matched;
    if (share < word_share) return messages;
    const Severity severity = share > reject_share ? Severity::do_not_use
                              : share > look_share ? Severity::caution
                                                   : Severity::notice;
    messages.push_back({MessageCode::doubtful_vertices, severity, place(vertices, share, source), {}});
    messages.back().where.vertices = std::move(vertices);
    return messages;
}

double share_of_images(const VertexMap& target_from_source) {
    std::vector<char> is_image(to_size(target_from_source.target_size()), 0);
    for (const Index image : target_from_source.image())
        if (image != VertexMap::unmatched) is_image[to_size(image)] = 1;
    const auto n = std::count(is_image.begin(), is_image.end(), 1);
    return is_image.empty() ? 0 : static_cast<double>(n) / static_cast<double>(is_image.size());
}

}  // namespace counterpart::judgment

namespace counterpart {

std::vector<Message> doubts(const VertexMap& target_from_source, const Vector& confidence, MeshView source) {
    return judgment::doubts(target_from_source, confidence, source,
                            judgment::share_of_images(target_from_source));
}

}  // namespace counterpart
