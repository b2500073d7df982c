// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "base/parallel.hpp"
#include "match/isomorphism/component_classes.hpp"
#include "match/isomorphism/counting.hpp"
#include "match/non_manifold/matching.hpp"
#include "match/symmetry/choice.hpp"
#include "match/symmetry/component_assignment.hpp"
#include "mesh/polygons.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/match/exact.hpp>
#include <counterpart/mesh/measure.hpp>
#include <counterpart/mesh/weld.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>

namespace counterpart {
namespace {

using namespace isomorphism;
using symmetry::Choice;
using symmetry::ComponentPair;
using symmetry::MatchedMaps;

// What two maps with one connectivity have in common at a glance; empty if nothing differs.
std::string first_difference(const DartMap& a, const DartMap& b) {
    struct Property {
        const char* name;
        std::size_t in_source, in_target;
    };
    for (const Property& property :
         {Property{"triangles", a.input_triangle.size(), b.input_triangle.size()},
          Property{"vertices with triangles", a.input_vertex.size(), b.input_vertex.size()},
          Property{"isolated vertices", a.isolated.size(), b.isolated.size()},
          Property{"components", to_size(a.n_components()), to_size(b.n_components())},
          Property{"boundary edges", to_size(a.boundary_edges), to_size(b.boundary_edges)},
          Property{"non-manifold edges", to_size(a.non_manifold_edges), to_size(b.non_manifold_edges)},
          Property{"vertices in which components touch", to_size(a.non_manifold_vertices),
                   to_size(b.non_manifold_vertices)}})
        if (property.in_source != property.in_target)
            return fmt::format("the source has {} {}, the target {}", property.in_source, property.name,
                               property.in_target);
    return {};
}

std::string first_difference(const DartMap& a, const DartMap& b, const std::vector<ComponentClass>& classes) {
    for (const ComponentClass& kind : classes) {
        if (kind.source.size() == kind.target.size()) continue;
        const bool more = kind.source.size() > kind.target.size();
        const DartMap& map = more ? a : b;
        const Index component = (more ? kind.source : kind.target).back().component;
        const Index vertex =
            map.input_vertex[to_size(map.corner[3 * to_size(map.component_begin[to_size(component)])])];
        const char *here = more ? "source" : "target", *there = more ? "target" : "source";
        if (kind.source.empty() || kind.target.empty())
            return fmt::format(
                "no {} component has the connectivity of the {} component with vertex {} ({} triangles)",
                there, here, vertex, map.component_size(component));
        return fmt::format(
            "the {} has {} components with the connectivity of that with vertex {} ({} triangles), the {} {}",
            here, (more ? kind.source : kind.target).size(), vertex, map.component_size(component), there,
            (more ? kind.target : kind.source).size());
    }
    return {};
}

struct Parities {
    std::size_t even = 0, odd = 0;
};
Parities count_parities(const std::vector<Member>& members) {
    Parities count;
    for (const Member& member : members) ++(member.parity == 0 ? count.even : count.odd);
    return count;
}

// Whether every component can be matched with its orientation kept, or with every one reversed.
bool is_feasible(const MatchedMaps& maps, bool reversed) {
    for (std::size_t k = 0; k < maps.classes.size(); ++k) {
        const ComponentClass& kind = maps.classes[k];
        const Parities source = count_parities(kind.source), target = count_parities(kind.target);
        if (reversed && maps.source.is_one_sided(kind.component)) continue;
        const bool exchange = reversed && maps.groups[k].mirror.empty();
        if (source.even != (exchange ? target.odd : target.even)) return false;
    }
    return true;
}

// Equal components multiply: k! |Aut|^k for k of a class.
void count_automorphisms(const MatchedMaps& maps, ExactResult& result) {
    double log10 = 0;
    bool has_mirror = false, all_mirror = true;
    for (std::size_t k = 0; k < maps.classes.size(); ++k) {
        const AutomorphismGroup& group = maps.groups[k];
        const Parities count = count_parities(maps.classes[k].source);
        log10 += log10_factorial(count.even) + log10_factorial(count.odd) +
                 static_cast<double>(count.even + count.odd) * std::log10(static_cast<double>(group.order()));
        if (maps.source.is_one_sided(maps.classes[k].component)) continue;
        has_mirror = true;
        all_mirror = all_mirror && (!group.mirror.empty() || count.even == count.odd);
    }
    result.automorphisms = count_from_log10(log10);
    result.mirror_automorphisms =
        count_from_log10(has_mirror && all_mirror ? log10 : -std::numeric_limits<double>::infinity());
}

// Where both orientations fit, the one that keeps the outside outside: winding alone cannot tell a reversed
// mesh from its mirror image.
bool is_inside_out(const MatchedMaps& maps) {
    const auto is_closed = [](const DartMap& map) {
        return map.boundary_edges == 0 && map.non_manifold_edges == 0 && map.flipped.empty();
    };
    return is_closed(maps.source) && is_closed(maps.target) &&
           signed_volume(maps.source_mesh) * signed_volume(maps.target_mesh) < 0;
}

// Twice the area as seen from above, negative if most triangles are clockwise; nothing unless the mesh lies
// in a plane of constant z. (The middles of polygons are there but for rounding.)
std::optional<double> area_from_above(const DartMap& map, MeshView mesh) {
    const auto z = mesh.vertices.col(2);
    constexpr double rounding = 1e-12;
    const double extent =
        (mesh.vertices.colwise().maxCoeff() - mesh.vertices.colwise().minCoeff()).maxCoeff();
    if (z.maxCoeff() - z.minCoeff() > rounding * (extent + std::abs(z[0]))) return std::nullopt;
    double area = 0;
    for (Index t = 0; t < map.n_triangles(); ++t) {
        const auto at = [&](std::size_t c) -> Eigen::Vector2d {
            const Index v = map.input_vertex[to_size(map.corner[3 * to_size(t) + c])];
            return mesh.vertices.row(v).head<2>().transpose();
        };
        const Eigen::Vector2d u = at(1) - at(0), v = at(2) - at(0);
        area += (map.parity(make_dart(t, 0)) == 0 ? 1 : -1) * (u[0] * v[1] - u[1] * v[0]);
    }
    return area;
}

// Two meshes in the plane have no other side: whether the target must be wound the other way not to be a
// mirror image. Nothing where the winding does not tell.
std::optional<bool> is_turned_over_in_plane(const MatchedMaps& maps) {
    const auto ours = area_from_above(maps.source, maps.source_mesh),
               theirs = area_from_above(maps.target, maps.target_mesh);
    if (!ours || !theirs || *ours * *theirs == 0) return std::nullopt;
    return *ours * *theirs < 0;
}

void fill_maps(const MatchedMaps& maps, const std::vector<ComponentPair>& pairs, ExactResult& result) {
    std::vector<Index> image(to_size(maps.source.n_vertices()), -1);
    result.target_corner_from_source.setConstant(maps.source.n_triangles(), 3, -1);
    Index* const corners = result.target_corner_from_source.data();
    Index reversed_triangles = 0;
    for (const ComponentPair& pair : pairs) {
        for (std::size_t k = 0; k < pair.size(); ++k) {
            Dart d = pair.on_source(k), e = pair.on_target(k);
            reversed_triangles += static_cast<Index>(direction_of(d ^ e));
            for (int c = 0; c < 3; ++c, d = next(d), e = next(e)) {
                corners[maps.source.input_corner(d)] = maps.target.input_corner(e);
                image[to_size(maps.source.origin(d))] = maps.target.origin(e);
            }
        }
    }
    result.reversed_triangles = reversed_triangles;
    result.winding_reversed = reversed_triangles == maps.source.n_triangles();
    std::vector<Index> input_image(to_size(maps.source_mesh.n_vertices()), VertexMap::unmatched);
    for (std::size_t v = 0; v < image.size(); ++v)
        input_image[to_size(maps.source.input_vertex[v])] = maps.target.input_vertex[to_size(image[v])];
    result.target_from_source = VertexMap(std::move(input_image), maps.target_mesh.n_vertices());
}

// The map with the isolated vertices paired too, by position.
VertexMap with_isolated(const MatchedMaps& maps, const symmetry::Alignment& alignment, const VertexMap& map) {
    std::vector<symmetry::Moments> from, to;
    for (const Index v : maps.source.isolated)
        from.push_back(
            symmetry::moments_of(alignment(maps.source_mesh.vertices.row(v)), Eigen::Matrix3d::Zero()));
    for (const Index w : maps.target.isolated)
        to.push_back(symmetry::moments_of(maps.target_mesh.vertices.row(w), Eigen::Matrix3d::Zero()));
    if (from.empty() || to.empty()) return map;
    const std::vector<Index> chosen = symmetry::assign_components(from, to);
    std::vector<Index> image = map.image();
    for (std::size_t i = 0; i < from.size(); ++i)
        if (chosen[i] >= 0)
            image[to_size(maps.source.isolated[i])] = maps.target.isolated[to_size(chosen[i])];
    return {std::move(image), map.target_size()};
}

Index smallest_vertex(const DartMap& map, Index component) {
    Index smallest = std::numeric_limits<Index>::max();
    for (auto h = 3 * to_size(map.component_begin[to_size(component)]);
         h < 3 * to_size(map.component_begin[to_size(component) + 1]); ++h)
        smallest = std::min(smallest, map.input_vertex[to_size(map.corner[h])]);
    return smallest;
}

// Of a polygon mesh those that its polygons were cut into.
Index n_input_triangles(const DartMap& map, Index component) {
    const Index size = map.component_size(component);
    if (map.first_center == no_center) return size;
    std::vector<Index> centers;
    for (auto t = to_size(map.component_begin[to_size(component)]);
         t < to_size(map.component_begin[to_size(component) + 1]); ++t)
        centers.push_back(map.corner[3 * t + 2]);
    std::sort(centers.begin(), centers.end());
    return size - 2 * static_cast<Index>(std::unique(centers.begin(), centers.end()) - centers.begin());
}

void list_interchangeable(const MatchedMaps& maps, const Choice& choice, ExactResult& result) {
    std::vector<Index> place(maps.classes.size(), -1);
    for (const ComponentPair& pair : choice.pairs) {
        if (pair.kind->source.size() < 2) continue;
        Index& at = place[to_size(pair.kind - maps.classes.data())];
        if (at < 0) {
            at = static_cast<Index>(result.interchangeable.size());
            result.interchangeable.push_back(
                {n_input_triangles(maps.source, pair.source->component), {}, {}});
        }
        EqualComponents& equal = result.interchangeable[to_size(at)];
        equal.source.push_back(smallest_vertex(maps.source, pair.source->component));
        equal.target.push_back(smallest_vertex(maps.target, pair.target->component));
    }
}

void describe_equal_components(const std::vector<EqualComponents>& classes,
                               std::vector<std::string>& notices) {
    if (classes.empty()) return;
    std::size_t n_components = 0;
    for (const EqualComponents& equal : classes) n_components += equal.source.size();
    const EqualComponents& largest = *std::max_element(
        classes.begin(), classes.end(),
        [](const EqualComponents& a, const EqualComponents& b) { return a.source.size() < b.source.size(); });
    notices.push_back(
        classes.size() == 1
            ? fmt::format("{} components of {} triangles are interchangeable; they were paired by position",
                          n_components, largest.n_triangles)
            : fmt::format("{} components are interchangeable within {} classes, the largest of {} components "
                          "of {} triangles; they were paired by position",
                          n_components, classes.size(), largest.source.size(), largest.n_triangles));
}

// What the notices tell of the source, besides what the result holds.
struct Described {
    const char* faces = "triangles";
    Index n_faces = 0, n_reversed = 0;
    Index non_manifold_edges = 0, non_manifold_vertices = 0;
    std::size_t n_isolated = 0;
};

void describe(const Described& source, ExactResult& result) {
    auto& notices = result.notices;
    const auto is_many = [](const Count& count) { return !count.number || *count.number > 1; };
    if (result.path == ExactPath::patches)
        notices.push_back(fmt::format(
            "non-manifold: {} edges with more than two {}, {} vertices in several "
            "patches; matched patch by patch ({} patches)",
            source.non_manifold_edges, source.faces, source.non_manifold_vertices, result.n_components));
    if (result.mirrored)
        notices.push_back(fmt::format("an orientation-reversing match was chosen"));
    else if (result.winding_reversed)
        notices.push_back(
            fmt::format("the target's winding is reversed: all {} have the opposite winding", source.faces));
    else if (source.n_reversed > 0)
        notices.push_back(fmt::format("{} of {} {} have the opposite winding in the target",
                                      source.n_reversed, source.n_faces, source.faces));
    if (is_many(result.automorphisms))
        notices.push_back(
            fmt::format("the connectivity is symmetric: {} orientation-preserving matches are possible, the "
                        "choice was made by geometry",
                        to_string(result.automorphisms)));
    if (is_many(result.mirror_automorphisms) || *result.mirror_automorphisms.number > 0)
        notices.push_back(fmt::format("{} orientation-reversing matches are possible too",
                                      to_string(result.mirror_automorphisms)));
    describe_equal_components(result.interchangeable, notices);
    if (source.n_isolated > 0)
        notices.push_back(fmt::format("{} isolated vertices were paired by position", source.n_isolated));
}

// Chooses among the isomorphisms; the others asked for follow the best. None if nothing fits.
std::vector<Choice> choose(const MatchedMaps& maps, const ExactOptions& options, ExactResult& result) {
    const auto n_others = to_size(options.max_alternatives);
    const auto progress = [&](double share) {
        return !options.progress || options.progress(0.6 + 0.3 * share);
    };
    const bool preserves = is_feasible(maps, false), reverses = is_feasible(maps, true);
    bool reversed = reverses && (!preserves || is_inside_out(maps));
    const std::optional<bool> turned = is_turned_over_in_plane(maps);
    if (turned && (preserves || reverses)) {
        result.mirrored = !(*turned ? reverses : preserves);
        if (result.mirrored && !options.allow_mirror) {
            result.difference =
                "the target is a mirror image of the source in the plane, which must be allowed";
            return {};
        }
        reversed = *turned != result.mirrored;
    }
    if (maps.source.non_manifold_vertices > 0) {
        result.path = ExactPath::patches;
        std::vector<Choice> found = non_manifold::match_patches(maps, reversed, 1 + n_others, progress);
        result.automorphisms = non_manifold::count_automorphisms(maps, false);
        result.mirror_automorphisms =
            reverses ? non_manifold::count_automorphisms(maps, true) : Count{-INFINITY, 0, false};
        return found;
    }
    count_automorphisms(maps, result);
    std::vector<Choice> found{choose_isomorphism(maps, reversed, progress)};
    const bool compares = preserves && reverses && options.allow_mirror;
    if (compares || !maps.source.isolated.empty()) {
        const symmetry::PairGeometry geometry(maps);
        measure(maps, geometry, reversed, found[0]);
        if (compares) {
            Choice other = choose_isomorphism(maps, !reversed);
            measure(maps, geometry, !reversed, other);
            other.fit.offset = found[0].fit.offset;  // where only that differs, the orientation is kept
            result.mirrored = geometry.is_better(other.fit, found[0].fit);
            if (result.mirrored) {
                found[0] = std::move(other);
                reversed = !reversed;
            }
        }
    }
    if (n_others == 0) return found;
    for (Choice& other : other_choices(maps, found[0], reversed, n_others)) found.push_back(std::move(other));
    if (preserves && reverses && found.size() <= n_others)
        found.push_back(choose_isomorphism(maps, !reversed));
    return found;
}

struct Isomorphism {
    ExactResult result;
    Described source;
};

// Of meshes of triangles, or of coned ones, whose middles of polygons are the vertices from these on.
Isomorphism match_connectivity(MeshView source, MeshView target, const ExactOptions& options,
                               Index source_center = no_center, Index target_center = no_center) {
    Isomorphism isomorphism;
    ExactResult& result = isomorphism.result;
    report_progress(options.progress, 0);
    DartMap a, b;
    parallel_invoke([&] { a = make_dart_map(source, source_center); },
                    [&] { b = make_dart_map(target, target_center); });
    report_progress(options.progress, 0.3);
    result.n_components = a.n_components();
    result.difference = first_difference(a, b);
    if (!result.difference.empty()) return isomorphism;
    const Classification found = classify_components(a, b);
    report_progress(options.progress, 0.5);
    result.difference = first_difference(a, b, found.classes);
    if (!result.difference.empty()) return isomorphism;

    std::vector<AutomorphismGroup> groups;
    for (const ComponentClass& kind : found.classes)
        groups.push_back(find_automorphisms(a, found.source_colors, kind.component, kind.root));
    report_progress(options.progress, 0.6);
    const MatchedMaps maps{source, target, a, b, found.classes, groups};
    const std::vector<Choice> choices = choose(maps, options, result);
    report_progress(options.progress, 0.9);
    if (choices.empty()) {
        if (result.difference.empty())
            result.difference =
                "the patches between non-manifold edges and vertices are equal, but join differently";
        return isomorphism;
    }
    result.identical = true;
    fill_maps(maps, choices[0].pairs, result);
    result.target_from_source = with_isolated(maps, choices[0].alignment, result.target_from_source);
    for (std::size_t i = 1; i < choices.size(); ++i) {
        ExactResult other;
        fill_maps(maps, choices[i].pairs, other);
        other.target_from_source = with_isolated(maps, choices[0].alignment, other.target_from_source);
        result.alternatives.push_back(std::move(other.target_from_source));
    }
    list_interchangeable(maps, choices[0], result);
    isomorphism.source = {.n_faces = a.n_triangles(),
                          .n_reversed = result.reversed_triangles,
                          .non_manifold_edges = a.non_manifold_edges,
                          .non_manifold_vertices = a.non_manifold_vertices,
                          .n_isolated = a.isolated.size()};
    report_progress(options.progress, 1);
    return isomorphism;
}

// For each corner of a triangle of the source one of the target that stands for the same corner of a polygon;
// the result's are those of coned meshes, whose triangle j begins at polygon corner j.
Triangles uncut_corners(const Polygons& source, const Polygons& target, TrianglesView coned) {
    const std::vector<Index> stands_for = target.triangle_corners();
    std::vector<Index> next(to_size(target.n_corners()));
    for (Index p = 0; p < target.count(); ++p)
        for (Index j = target.first[to_size(p)]; j < target.first[to_size(p) + 1]; ++j)
            next[to_size(j)] = j + 1 < target.first[to_size(p) + 1] ? j + 1 : target.first[to_size(p)];
    return source.corners.unaryExpr([&](Index j) {
        const Index corner = coned(j, 0);
        return stands_for[to_size(corner % 3 == 0 ? corner / 3 : next[to_size(corner / 3)])];
    });
}

// How many of the source's polygons are cut into other triangles in the target.
Index count_cut_differently(const Polygons& source, const Triangles& target_corners, const Polygons& target) {
    const auto cut_of = [](const Triangles& triangles, Index begin, Index end, const auto& corner) {
        std::vector<std::array<Index, 3>> cut;
        for (Index t = begin; t < end; ++t) {
            cut.push_back({corner(triangles(t, 0)), corner(triangles(t, 1)), corner(triangles(t, 2))});
            std::sort(cut.back().begin(), cut.back().end());
        }
        std::sort(cut.begin(), cut.end());
        return cut;
    };
    Index count = 0;
    for (Index p = 0; p < source.count(); ++p) {
        const Index n = source.size(p), begin = source.first_triangle(p);
        if (n == 3) continue;
        const auto of_target = [&](Index corner) { return target.corners.data()[corner]; };
        const Index image = of_target(target_corners(begin, 0));
        const auto q = static_cast<Index>(std::upper_bound(target.first.begin(), target.first.end(), image) -
                                          target.first.begin() - 1);
        const Index there = target.first_triangle(q);
        const auto itself = [](Index corner) { return corner; };
        if (cut_of(target_corners, begin, begin + n - 2, of_target) !=
            cut_of(target.corners, there, there + n - 2, itself))
            ++count;
    }
    return count;
}

VertexMap without_centers(const VertexMap& map, Index n_source, Index n_target) {
    return {{map.image().begin(), map.image().begin() + n_source}, n_target};
}

// By polygons, wherever they begin and however they were cut.
ExactResult match_polygons(MeshView source, MeshView target, const ExactOptions& options) {
    const Polygons &from = *source.polygons, &to = *target.polygons;
    ExactResult differing;
    differing.difference = mesh::first_difference(from, to);
    if (!differing.difference.empty()) return differing;
    const TriangleMesh a = mesh::coned(source), b = mesh::coned(target);
    Isomorphism found = match_connectivity(a, b, options, source.n_vertices(), target.n_vertices());
    ExactResult& result = found.result;
    Described& described = found.source;
    if (!result.identical) return std::move(result);
    result.target_from_source =
        without_centers(result.target_from_source, source.n_vertices(), target.n_vertices());
    for (VertexMap& other : result.alternatives)
        other = without_centers(other, source.n_vertices(), target.n_vertices());
    described.faces = "polygons";
    described.n_faces = from.count();
    described.n_reversed = result.reversed_triangles = 0;
    for (Index p = 0; p < from.count(); ++p) {
        const Index j = from.first[to_size(p)];
        if (result.target_corner_from_source(j, 0) % 3 == 0) continue;
        ++described.n_reversed;
        result.reversed_triangles += from.size(p) - 2;
    }
    result.target_corner_from_source = uncut_corners(from, to, result.target_corner_from_source);
    result.recut_polygons = count_cut_differently(from, result.target_corner_from_source, to);
    describe(described, result);
    if (result.recut_polygons > 0)
        result.notices.push_back(fmt::format("{} of {} polygons are cut into other triangles in the target",
                                             result.recut_polygons, from.count()));
    return std::move(result);
}

ExactResult match_unwelded(MeshView source, MeshView target, const ExactOptions& options) {
    std::string difference;
    ExactOptions triangles = options;
    if (source.polygons != nullptr && target.polygons != nullptr) {
        ExactOptions polygons = options;
        polygons.progress = part_of(options.progress, 0, 0.5);
        triangles.progress = part_of(options.progress, 0.5, 1);
        ExactResult result = match_polygons(source, target, polygons);
        if (result.identical) return result;
        difference = std::move(result.difference);
    }
    Isomorphism found = match_connectivity(source, target, triangles);
    ExactResult& result = found.result;
    if (result.identical)
        describe(found.source, result);
    else if (!difference.empty())
        result.difference = std::move(difference);
    return std::move(result);
}

// The map between the welded meshes taken back to all duplicates, corner by corner: so each gets the
// duplicate on its own side of the seam.
VertexMap unwelded(const VertexMap& welded_map, TrianglesView corners, MeshView source, MeshView target,
                   const WeldResult& welded_source, const WeldResult& welded_target) {
    std::vector<Index> map(to_size(source.n_vertices()), VertexMap::unmatched);
    for (Index t = 0; t < source.n_triangles(); ++t) {
        for (int c = 0; c < 3; ++c) {
            Index& image = map[to_size(source.triangles(t, c))];
            if (image < 0) image = target.triangles(corners(t, c) / 3, corners(t, c) % 3);
        }
    }
    std::vector<Index> any(to_size(welded_target.mesh.n_vertices()), VertexMap::unmatched);
    for (Index w = target.n_vertices(); w-- > 0;)
        any[to_size(welded_target.welded_from_original[to_size(w)])] = w;
    for (std::size_t v = 0; v < map.size(); ++v) {
        if (map[v] >= 0) continue;
        const Index partner = welded_map[welded_source.welded_from_original[v]];
        if (partner >= 0) map[v] = any[to_size(partner)];
    }
    return {std::move(map), target.n_vertices()};
}

ExactResult match_welded(MeshView source, MeshView target, const ExactOptions& options) {
    const WeldResult welded_source = weld(source, {options.weld_distance}),
                     welded_target = weld(target, {options.weld_distance});
    ExactResult result = match_unwelded(welded_source.mesh, welded_target.mesh, options);
    if (!result.identical) return result;
    result.notices.push_back(fmt::format("welded for the match: {} -> {} and {} -> {} vertices",
                                         source.n_vertices(), welded_source.mesh.n_vertices(),
                                         target.n_vertices(), welded_target.mesh.n_vertices()));
    result.target_from_source = unwelded(result.target_from_source, result.target_corner_from_source, source,
                                         target, welded_source, welded_target);
    // Other matches are known by vertex only; their duplicates all take the first one.
    const Triangles none;
    for (VertexMap& alternative : result.alternatives)
        alternative =
            unwelded(alternative, none, {source.vertices, none}, target, welded_source, welded_target);
    return result;
}

}  // namespace

ExactResult match_exact(MeshView source, MeshView target, const ExactOptions& options) {
    require_valid(source);
    require_valid(target);
    if (options.max_alternatives < 0) throw InvalidInput("max_alternatives must be 0 or more");
    return with_threads(options.n_threads, [&] {
        return options.weld_distance < 0 ? match_unwelded(source, target, options)
                                         : match_welded(source, target, options);
    });
}

}  // namespace counterpart
