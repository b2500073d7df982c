// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include <counterpart/base/errors.hpp>
#include <counterpart/transfer/reorder.hpp>

#include <fmt/format.h>

namespace counterpart {

TriangleMesh reorder(const TriangleMesh& source, const TriangleMesh& target,
                     const VertexMap& target_from_source) {
    require_valid(target_from_source, source.n_vertices(), target.n_vertices());
    TriangleMesh result{Points(source.n_vertices(), 3), source.triangles};
    for (Index v = 0; v < source.n_vertices(); ++v) {
        if (target_from_source[v] == VertexMap::unmatched) {
            throw InvalidInput(
                fmt::format("source vertex {} is unmatched: only a complete map can bring the target into "
                            "the source's order",
                            v));
        }
        result.vertices.row(v) = target.vertices.row(target_from_source[v]);
    }
    return result;
}

}  // namespace counterpart
