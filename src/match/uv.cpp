// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "base/parallel.hpp"
#include "base/to_size.hpp"
#include "match/uv/locate.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/match/uv.hpp>
#include <counterpart/mesh/measure.hpp>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace counterpart {
namespace {

using uv::Layout;
using uv::Located;
using How = Located::How;

// As match_place has it, of a layout and of a surface: half a percent of the size, or a quarter of an edge,
// which is about what a coarse outline of a round chart lacks.
double reach_of(double edge_length, double size) {
    constexpr double of_size = 0.005, of_edge = 0.25, most_of_size = 0.02;
    return std::clamp(of_edge * edge_length, of_size * size, most_of_size * size);
}

double near_on(MeshView mesh) { return reach_of(mean_edge_length(mesh), std::sqrt(surface_area(mesh))); }

bool is_found(const Located& located) { return located.how == How::surely || located.how == How::by_place; }

// By vertex, the best first: the surest, then the one least outside.
std::vector<std::vector<Located>> by_vertex(const std::vector<Located>& all, Index n_vertices) {
    std::vector<std::vector<Located>> result(to_size(n_vertices));
    for (const Located& located : all) result[to_size(located.corner.vertex)].push_back(located);
    const auto rank = [](const Located& located) {
        return std::tuple(!is_found(located), located.outside, located.how == How::by_place,
                          located.point.triangle, located.corner);
    };
    for (auto& of_vertex : result)
        std::sort(of_vertex.begin(), of_vertex.end(),
                  [&](const Located& a, const Located& b) { return rank(a) < rank(b); });
    return result;
}

double share_located(const std::vector<std::vector<Located>>& vertices) {
    double n = 0, n_located = 0;
    for (const auto& of_vertex : vertices) {
        n += of_vertex.empty() ? 0 : 1;
        n_located += std::any_of(of_vertex.begin(), of_vertex.end(),
                                 [](const Located& located) { return located.how != How::nowhere; });
    }
    return n > 0 ? n_located / n : 0;
}

Eigen::RowVector3d position_on(MeshView mesh, const SurfacePoint& point) {
    Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
    for (int c = 0; c < 3; ++c)
        sum += point.weights[c] * mesh.vertices.row(mesh.triangles(point.triangle, c));
    return sum;
}

// Whether all coordinates of a vertex lead to one place.
bool closes(const std::vector<Located>& of_vertex, MeshView target, double near) {
    const Eigen::RowVector3d place = position_on(target, of_vertex[0].point);
    return std::all_of(of_vertex.begin(), of_vertex.end(), [&](const Located& other) {
        return !is_found(other) || (position_on(target, other.point) - place).norm() <= near;
    });
}

UvResult result_of(const std::vector<std::vector<Located>>& vertices, MeshView target, double reach) {
    constexpr double most = 0.95;  // what coordinates alone decide is never certain
    UvResult result;
    result.reach = reach;
    result.source_share = share_located(vertices);
    result.surface = {std::vector<SurfacePoint>(vertices.size()), target.n_triangles()};
    result.confidence = Vector::Zero(static_cast<Index>(vertices.size()));
    const double near = near_on(target);
    double n_seams = 0, n_closed = 0;
    for (std::size_t v = 0; v < vertices.size(); ++v) {
        if (vertices[v].empty()) continue;
        const Located& best = vertices[v][0];
        if (!is_found(best)) {
            result.n_undecided +=
                std::any_of(vertices[v].begin(), vertices[v].end(),
                            [](const Located& located) { return located.how == How::undecided; });
            continue;
        }
        result.surface.image[v] = best.point;
        result.n_by_place += best.how == How::by_place;
        const bool is_at_seam = vertices[v].size() > 1, is_closed = closes(vertices[v], target, near);
        n_seams += is_at_seam;
        n_closed += is_at_seam && is_closed;
        const double left = 1 - best.outside / reach;
        if (is_closed)
            result.confidence[static_cast<Index>(v)] =
                most * left * left * (best.how == How::by_place ? 0.5 : 1);
    }
    if (n_seams > 0) result.seam_agreement = n_closed / n_seams;
    result.target_from_source = nearest_corners(result.surface, target);
    return result;
}

std::string sentence_of(const UvResult& result) {
    return fmt::format(
        "the texture coordinates are laid out {}: {:.0f} % of the source's vertices lie in the target's "
        "charts, {:.0f} % of the target's in the source's, and seams close at {:.0f} % of the vertices there",
        laid_out_alike(result) ? "alike" : "differently", 100 * result.source_share,
        100 * result.target_share, 100 * result.seam_agreement);
}

}  // namespace

UvResult match_uv(MeshView source, MeshView target, const UvOptions& options) {
    require_valid(source);
    require_valid(target);
    report_progress(options.progress, 0);
    UvResult result = with_threads(options.n_threads, [&] {
        const Layout from(source, options.source, "source"), to(target, options.target, "target");
        const double reach =
            reach_of(std::max(from.edge_length(), to.edge_length()), std::min(from.size(), to.size()));
        UvResult found = result_of(
            by_vertex(uv::locate(from, to, reach, near_on(target)), source.n_vertices()), target, reach);
        if (count_matched(found.surface) == 0 && found.n_undecided == 0)
            throw InvalidInput(
                "none of the source's texture coordinates lies in a chart of the target that faces the same "
                "way: the meshes are laid out differently, or one of them is mirrored");
        report_progress(options.progress, 0.5);
        found.target_share =
            share_located(by_vertex(uv::locate(to, from, reach, near_on(source)), target.n_vertices()));
        return found;
    });
    result.sentence = sentence_of(result);
    report_progress(options.progress, 1);
    return result;
}

std::vector<Message> uv_messages(const UvResult& result) {
    std::vector<Message> messages;
    constexpr double hopeless_share = 0.75,
                     hopeless_seams = 0.5;  // what unlike layouts reach that fill the image
    const bool is_alike = laid_out_alike(result),
               is_hopeless = std::max(result.source_share, result.target_share) < hopeless_share ||
                             result.seam_agreement < hopeless_seams;
    messages.push_back({is_alike ? MessageCode::same_layout : MessageCode::misfit,
                        is_alike      ? Severity::notice
                        : is_hopeless ? Severity::do_not_use
                                      : Severity::caution,
                        result.sentence});
    if (result.n_by_place > 0)
        messages.push_back(
            {MessageCode::layout_overlaps,
             result.n_by_place == count_matched(result.surface) ? Severity::caution : Severity::notice,
             fmt::format("{} vertices lie in charts over one another: place chose the nearest",
                         result.n_by_place)});
    if (result.n_undecided > 0)
        messages.push_back(
            {MessageCode::layout_overlaps, Severity::caution,
             fmt::format(
                 "{} vertices have no partner: charts of the target lie over one another there, and place "
                 "does not tell them apart; lay the meshes over each other in one pose, or give the "
                 "charts places of their own",
                 result.n_undecided)});
    return messages;
}

}  // namespace counterpart
