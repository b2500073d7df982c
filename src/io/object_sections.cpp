// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "io/object_sections.hpp"

#include <algorithm>
#include <cstddef>
#include <unordered_map>

namespace counterpart::io {
namespace {

void fill(std::vector<Index>& items, std::int64_t begin, std::int64_t end, Index value) {
    std::fill(items.begin() + static_cast<std::ptrdiff_t>(begin),
              items.begin() + static_cast<std::ptrdiff_t>(end), value);
}

}  // namespace

void ObjectSections::begin(std::string_view name, std::int64_t n_vertices, std::int64_t n_triangles) {
    if (sections_.empty() && (n_vertices > 0 || n_triangles > 0)) sections_.push_back({});
    // A section of nothing is none: many short lines take no memory.
    if (!sections_.empty() && sections_.back().first_vertex == n_vertices &&
        sections_.back().first_triangle == n_triangles)
        sections_.back().name = name;
    else
        sections_.push_back({std::string(name), n_vertices, n_triangles});
}

MeshObjects ObjectSections::objects(Index n_vertices, Index n_triangles, SameName same_name) const {
    MeshObjects found;
    if (sections_.empty()) return found;
    found.of_triangle.resize(static_cast<std::size_t>(n_triangles));
    found.of_vertex.assign(static_cast<std::size_t>(n_vertices), -1);
    std::unordered_map<std::string_view, Index> known;
    std::vector<Index> of_section(sections_.size(), -1);
    for (std::size_t i = 0; i < sections_.size(); ++i) {
        const auto& [name, first_vertex, first] = sections_[i];
        const std::int64_t end = i + 1 < sections_.size() ? sections_[i + 1].first_triangle : n_triangles;
        if (first == end) continue;
        const auto next = static_cast<Index>(found.names.size());
        of_section[i] = same_name == SameName::one ? known.emplace(name, next).first->second : next;
        if (of_section[i] == next) found.names.push_back(name);
        fill(found.of_triangle, first, end, of_section[i]);
    }
    for (std::size_t i = 0; i < sections_.size(); ++i) {
        const auto& [name, first, first_triangle] = sections_[i];
        const std::int64_t end = i + 1 < sections_.size() ? sections_[i + 1].first_vertex : n_vertices;
        const auto other = known.find(name);  // a section of this name that has triangles
        const Index object = of_section[i] < 0 && other != known.end() ? other->second : of_section[i];
        fill(found.of_vertex, first, end, object);
    }
    return found;
}

}  // namespace counterpart::io
