// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/exact/isomorphism.hpp"

#include "base/parallel.hpp"
#include "match/isomorphism/counting.hpp"
#include "match/isomorphism/first_difference.hpp"
#include "match/non_manifold/matching.hpp"
#include "match/symmetry/choice.hpp"
#include "match/symmetry/component_assignment.hpp"
#include "match/symmetry/confirmation.hpp"

#include <counterpart/mesh/measure.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace counterpart::exact {
namespace {

using namespace isomorphism;
using symmetry::Choice;
using symmetry::ComponentPair;
using symmetry::MatchedMaps;

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

// Of a closed surface. Large shuffled meshes wait for memory: so positions are taken to the map's order once.
double signed_volume_of(const DartMap& map, MeshView mesh) {
    Points position(map.n_vertices(), 3);
    for (Index v = 0; v < map.n_vertices(); ++v)
        position.row(v) = mesh.vertices.row(map.input_vertex[to_size(v)]);
    return signed_volume({position, TrianglesView(map.corner.data(), map.n_triangles(), 3)});
}

// Of closed surfaces: whether one has its inside out and the other not. Nothing where that is not defined.
std::optional<bool> is_inside_out(const MatchedMaps& maps) {
    const auto is_closed = [](const DartMap& map) {
        return map.boundary_edges == 0 && map.non_manifold_edges == 0 && map.flipped.empty();
    };
    if (!is_closed(maps.source) || !is_closed(maps.target)) return std::nullopt;
    double source = 0, target = 0;
    parallel_invoke([&] { source = signed_volume_of(maps.source, maps.source_mesh); },
                    [&] { target = signed_volume_of(maps.target, maps.target_mesh); });
    const double product = source * target;
    return product == 0 ? std::nullopt : std::optional<bool>(product < 0);
}

// A target that is wound the other way is inside out or a mirror image: the volumes tell which.
bool is_mirror_image(const MatchedMaps& maps, const ExactResult& result) {
    if (result.reversed_triangles != 0 && !result.winding_reversed) return false;
    const std::optional<bool> inside_out = is_inside_out(maps);
    return inside_out && *inside_out != result.winding_reversed;
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

// Drawings have no other side: whether the target must be wound the other way not to be a mirror image.
// Nothing where the winding does not tell, and for flat sheets in space, which may be turned over: of
// drawings one at least has z = 0.
std::optional<bool> is_turned_over_in_plane(const MatchedMaps& maps) {
    if (maps.source_mesh.vertices(0, 2) != 0 && maps.target_mesh.vertices(0, 2) != 0) return std::nullopt;
    const auto ours = area_from_above(maps.source, maps.source_mesh),
               theirs = area_from_above(maps.target, maps.target_mesh);
    if (!ours || !theirs || *ours * *theirs == 0) return std::nullopt;
    return *ours * *theirs < 0;
}

// The corner, 0 to 2, of its triangle that the dart leaves.
Dart corner_at_origin(Dart f) { return (corner_of(f) + direction_of(f)) % 3; }

// Every dart of a triangle and its image, body(dart, image), of all pairs of components; of coned meshes only
// the one at corner 0, which is a polygon's: nothing else is asked of them.
template <class Body>
void for_each_corner(const MatchedMaps& maps, const std::vector<ComponentPair>& pairs, const Body& body) {
    const bool is_coned = maps.source.first_center != no_center;
    for (const ComponentPair& pair : pairs) {
        for (std::size_t k = 0; k < pair.size(); ++k) {
            Dart d = pair.on_source(k), e = pair.on_target(k);
            if (is_coned) {
                const Dart corner = corner_at_origin(d);
                const Dart steps = direction_of(d) == 0 ? (3 - corner) % 3 : corner;
                body(next(d, steps), next(e, steps));
                continue;
            }
            for (int c = 0; c < 3; ++c, d = next(d), e = next(e)) body(d, e);
        }
    }
}

void fill_maps(const MatchedMaps& maps, const std::vector<ComponentPair>& pairs, ExactResult& result) {
    std::vector<Index> image(to_size(maps.source.n_vertices()), -1);
    const auto map_vertices = [&] {
        for_each_corner(maps, pairs, [&](Dart d, Dart e) {
            image[to_size(maps.source.origin(d))] = maps.target.origin(e);
        });
    };
    result.target_corner_from_source.setConstant(maps.source.n_triangles(), 3, -1);
    Index* const corners = result.target_corner_from_source.data();
    Index reversed_corners = 0;
    const auto map_corners = [&] {
        for_each_corner(maps, pairs, [&](Dart d, Dart e) {
            corners[maps.source.input_corner(d)] = maps.target.input_corner(e);
            reversed_corners += static_cast<Index>(direction_of(d ^ e));
        });
    };
    parallel_invoke(map_vertices, map_corners);
    const bool is_coned = maps.source.first_center != no_center;
    result.reversed_triangles = is_coned ? reversed_corners : reversed_corners / 3;
    result.winding_reversed = result.reversed_triangles == maps.source.n_triangles();
    std::vector<Index> input_image(to_size(maps.source_mesh.n_vertices()), VertexMap::unmatched);
    for (std::size_t v = 0; v < image.size(); ++v)
        if (image[v] >= 0)
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

void list_by_place(const MatchedMaps& maps, const Choice& choice, bool reversed, ExactResult& result) {
    for (const std::size_t p : symmetry::decided_by_place(maps, choice, reversed)) {
        const auto component = to_size(choice.pairs[p].source->component);
        for (auto h = 3 * to_size(maps.source.component_begin[component]);
             h < 3 * to_size(maps.source.component_begin[component + 1]); ++h) {
            const Index v = maps.source.input_vertex[to_size(maps.source.corner[h])];
            if (v < maps.source.first_center) result.by_place.push_back(v);
        }
    }
    std::sort(result.by_place.begin(), result.by_place.end());
    result.by_place.erase(std::unique(result.by_place.begin(), result.by_place.end()), result.by_place.end());
}

// Chooses among the isomorphisms; the others asked for follow the best. None if nothing fits.
std::vector<Choice> choose(const MatchedMaps& maps, const ExactOptions& options, ExactResult& result) {
    const auto n_others = to_size(options.max_alternatives);
    const auto progress = [&](double share) {
        return !options.progress || options.progress(0.6 + 0.3 * share);
    };
    const bool preserves = is_feasible(maps, false), reverses = is_feasible(maps, true);
    // Where both orientations fit, the one that keeps the outside outside.
    bool reversed = reverses && (!preserves || is_inside_out(maps).value_or(false));
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
    list_by_place(maps, found[0], reversed, result);
    result.confirmed_share = symmetry::confirmed_share(maps, found[0]);
    if (n_others == 0) return found;
    for (Choice& other : other_choices(maps, found[0], reversed, n_others)) found.push_back(std::move(other));
    if (preserves && reverses && found.size() <= n_others)
        found.push_back(choose_isomorphism(maps, !reversed));
    return found;
}

}  // namespace

Isomorphism match_triangles(MeshView source, MeshView target, const ExactOptions& options,
                            Index source_center, Index target_center) {
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
    result.mirrored = result.mirrored || is_mirror_image(maps, result);
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

}  // namespace counterpart::exact
