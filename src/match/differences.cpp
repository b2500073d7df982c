// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "base/parallel.hpp"
#include "match/differences/edits.hpp"
#include "match/differences/growth.hpp"
#include "match/differences/regrowth.hpp"
#include "match/differences/regular_patches.hpp"
#include "match/differences/triangle_pairs.hpp"
#include "match/differences/verification.hpp"
#include "match/symmetry/choice.hpp"
#include "mesh/separate_faces.hpp"

#include <counterpart/match/differences.hpp>

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

namespace counterpart {
namespace {

using namespace isomorphism;
using differences::DartPair;

// Components that both meshes have whole: geometry says which of several equal ones is missing.
std::vector<DartPair> match_equal_components(MeshView source, MeshView target, const DartMap& a,
                                             const DartMap& b) {
    const Classification found = classify_components(a, b);
    std::vector<AutomorphismGroup> groups;
    for (const ComponentClass& kind : found.classes)
        groups.push_back(kind.source.empty() || kind.target.empty()
                             ? AutomorphismGroup{}
                             : find_automorphisms(a, found.source_colors, kind.component, kind.root));
    const symmetry::Choice choice =
        symmetry::choose_isomorphism({source, target, a, b, found.classes, groups}, false);
    std::vector<DartPair> triangles;
    for (const symmetry::ComponentPair& pair : choice.pairs)
        for (std::size_t k = 0; k < pair.size(); ++k)
            triangles.emplace_back(pair.on_source(k), pair.on_target(k));
    return triangles;
}

struct SharedPart {
    std::vector<Index> image;    // of the source vertices
    std::vector<Index> partner;  // of the source triangles
    std::vector<Index> untold;   // source vertices
    bool reversed = false, ambiguous = false;
    double agreement = 0;
};

SharedPart find_shared_part(MeshView source, MeshView target, const DartMap& a, const DartMap& b,
                            const Progress& progress) {
    const std::vector<DartPair> equal = match_equal_components(source, target, a, b);
    report_progress(progress, 0.2);
    const differences::PairSide source_side(source, a), target_side(target, b);
    const differences::GrownMatch match = differences::grow_from_seeds(
        source_side, target_side, equal, [&] { report_progress(progress, 0.3); });
    report_progress(progress, 0.6);

    std::vector<Index> map(to_size(source.n_vertices()), VertexMap::unmatched);
    for (std::size_t v = 0; v < match.image.size(); ++v)
        if (match.image[v] >= 0) map[to_size(a.input_vertex[v])] = b.input_vertex[to_size(match.image[v])];
    std::vector<bool> known(to_size(source.n_triangles()), false);
    for (const auto& [d, e] : equal) known[to_size(a.input_triangle[to_size(triangle_of(d))])] = true;

    differences::Prediction prediction(source, target, match.reversed);
    const std::vector<Index> partner = differences::match_triangles(source, target, map);
    differences::Verified found =
        differences::verified(source_side, target_side, map, partner, known, prediction);
    report_progress(progress, 0.7);
    map = differences::regrown(source_side, target_side, std::move(found.image), prediction,
                               [&] { report_progress(progress, 0.8); });
    std::vector<Index> partners = differences::match_triangles(source, target, map);
    std::vector<Index> untold = differences::untold_vertices(source_side, target, map, partners);
    return {std::move(map), std::move(partners), std::move(untold),
            match.reversed, match.ambiguous,     found.agreement};
}

void list_unmatched(MeshView source, MeshView target, const std::vector<Index>& partner,
                    MeshDifferences& differences) {
    std::vector<bool> has_vertex(to_size(target.n_vertices()), false),
        has_triangle(to_size(target.n_triangles()), false);
    for (Index v = 0; v < source.n_vertices(); ++v) {
        const Index w = differences.target_from_source[v];
        if (w < 0)
            differences.source_vertices.push_back(v);
        else
            has_vertex[to_size(w)] = true;
    }
    for (Index t = 0; t < source.n_triangles(); ++t) {
        if (partner[to_size(t)] < 0)
            differences.source_triangles.push_back(t);
        else
            has_triangle[to_size(partner[to_size(t)])] = true;
    }
    for (Index w = 0; w < target.n_vertices(); ++w)
        if (!has_vertex[to_size(w)]) differences.target_vertices.push_back(w);
    for (Index u = 0; u < target.n_triangles(); ++u)
        if (!has_triangle[to_size(u)]) differences.target_triangles.push_back(u);

    const double n_matched = count_matched(differences.target_from_source);
    differences.source_share = n_matched / source.n_vertices();
    differences.target_share = n_matched / target.n_vertices();
    differences.n_matched_triangles =
        source.n_triangles() - static_cast<Index>(differences.source_triangles.size());
}

std::vector<Index> matched_vertices(const VertexMap& map) {
    std::vector<Index> matched;
    for (Index v = 0; v < map.source_size(); ++v)
        if (map[v] >= 0) matched.push_back(v);
    return matched;
}

std::vector<Index> united(const std::vector<Index>& a, const std::vector<Index>& b) {
    std::vector<Index> both;
    std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
    return both;
}

std::string summarize(MeshView source, MeshView target, const MeshDifferences& differences) {
    if (differences.n_matched_triangles == 0)
        return "the two meshes share no part that chance would not explain: they do not come from one mesh";
    return fmt::format(
        "{} of {} source triangles and {} of {} target triangles have a counterpart, {} source vertices of "
        "{} are matched ({} uncertain); {}{}{}",
        differences.n_matched_triangles, source.n_triangles(), differences.n_matched_triangles,
        target.n_triangles(), count_matched(differences.target_from_source), source.n_vertices(),
        differences.uncertain.size(),
        differences.edits.size() == 1 ? "1 place differs"
                                      : fmt::format("{} places differ", differences.edits.size()),
        differences.winding_reversed ? "; the target's winding is reversed" : "",
        differences.is_ambiguous ? "; another way to match the meshes fits nearly as well" : "");
}

MeshDifferences find(MeshView source, MeshView target, const Progress& progress) {
    report_progress(progress, 0);
    DartMap a, b;
    parallel_invoke([&] { a = make_dart_map(source); }, [&] { b = make_dart_map(target); });
    report_progress(progress, 0.1);
    SharedPart shared = find_shared_part(source, target, a, b, progress);
    report_progress(progress, 0.9);

    MeshDifferences differences;
    differences.winding_reversed = shared.reversed;
    // One separate face is as good as another.
    differences.is_ambiguous =
        shared.ambiguous || mesh::has_separate_faces(source) || mesh::has_separate_faces(target);
    differences.agreement = shared.agreement;
    differences.target_from_source = VertexMap(std::move(shared.image), target.n_vertices());
    const std::vector<Index>& partner = shared.partner;
    differences.untold = std::move(shared.untold);
    differences.uncertain = differences.is_ambiguous
                                ? matched_vertices(differences.target_from_source)
                                : united(differences.untold, differences::weakly_supported(
                                                                 source, target, partner,
                                                                 differences.target_from_source.image()));
    list_unmatched(source, target, partner, differences);
    const auto regions = differences::matched_regions(a, partner);
    if (!regions.empty()) differences.largest_region = static_cast<Index>(regions[0].size());
    differences.edits = differences::find_edits(source, target, differences);
    differences.summary = summarize(source, target, differences);
    if (differences.is_ambiguous)
        differences.messages.push_back({MessageCode::close_runner_up, Severity::caution,
                                        "another way to match the meshes fits nearly as well"});
    report_progress(progress, 1);
    return differences;
}

}  // namespace

MeshDifferences find_differences(MeshView source, MeshView target, const DifferencesOptions& options) {
    require_valid(source);
    require_valid(target);
    return with_threads(options.n_threads, [&] { return find(source, target, options.progress); });
}

}  // namespace counterpart
