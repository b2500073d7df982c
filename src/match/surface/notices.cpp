// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/surface/notices.hpp"

#include <utility>

#include <fmt/format.h>

namespace counterpart::surface_match {

std::string counted(Index n, const std::string& noun, const std::string& plural) {
    return fmt::format("{} {}", n, n == 1 ? noun : plural);
}

std::vector<Message> notices_on(const Preprocessed& mesh, Subject subject) {
    std::vector<Message> notices;
    const auto add = [&](bool holds, MessageCode code, const std::string& sentence,
                         std::vector<Index> vertices = {}) {
        if (holds) notices.push_back({code, Severity::notice, sentence, {subject, std::move(vertices)}});
    };
    add(mesh.n_merged > 0, MessageCode::merged_vertices,
        fmt::format("merged {}", counted(mesh.n_merged, "duplicate vertex", "duplicate vertices")));
    add(mesh.n_unreferenced > 0, MessageCode::isolated_vertices,
        fmt::format("{} in no triangle; each is matched like the nearest vertex",
                    counted(mesh.n_unreferenced, "vertex", "vertices")));
    add(mesh.n_duplicate_triangles > 0, MessageCode::duplicate_triangles,
        fmt::format("left out {}",
                    counted(mesh.n_duplicate_triangles, "duplicate triangle", "duplicate triangles")));
    add(mesh.n_disagreeing > 0, MessageCode::flipped_triangles,
        fmt::format("flipped {}", counted(mesh.n_disagreeing, "inconsistently oriented triangle",
                                          "inconsistently oriented triangles")));
    add(mesh.n_one_sided > 0, MessageCode::one_sided,
        "part of the surface is one-sided, like a Moebius band; left and right are undefined there");
    add(mesh.was_inside_out, MessageCode::inside_out, "inside out; its triangles were flipped for matching");
    add(mesh.n_nonmanifold_edges > 0, MessageCode::non_manifold,
        fmt::format("{} with more than two triangles; the surface is treated as cut there",
                    counted(mesh.n_nonmanifold_edges, "edge", "edges")));
    add(mesh.n_small_components > 0, MessageCode::small_components,
        fmt::format("left out {} ({:.2g} % of the area); each vertex is matched like the nearest one",
                    counted(mesh.n_small_components, "small component", "small components"),
                    100 * mesh.small_share),
        mesh.left_out);
    return notices;
}

}  // namespace counterpart::surface_match
