// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/isomorphism/first_difference.hpp"

#include <fmt/format.h>

namespace counterpart::isomorphism {

std::string first_difference(std::initializer_list<Property> properties) {
    for (const Property& property : properties)
        if (property.in_source != property.in_target)
            return fmt::format("the source has {} {}, the target {}", property.in_source, property.name,
                               property.in_target);
    return {};
}

std::string first_difference(const DartMap& a, const DartMap& b) {
    return first_difference(
        {{"triangles", a.input_triangle.size(), b.input_triangle.size()},
         {"vertices with triangles", a.input_vertex.size(), b.input_vertex.size()},
         {"isolated vertices", a.isolated.size(), b.isolated.size()},
         {"components", to_size(a.n_components()), to_size(b.n_components())},
         {"boundary edges", to_size(a.boundary_edges), to_size(b.boundary_edges)},
         {"non-manifold edges", to_size(a.non_manifold_edges), to_size(b.non_manifold_edges)},
         {"vertices in which components touch", to_size(a.non_manifold_vertices),
          to_size(b.non_manifold_vertices)}});
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

}  // namespace counterpart::isomorphism
