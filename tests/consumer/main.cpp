// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include <counterpart/counterpart.hpp>

#include <cstdio>

int main() {
    const counterpart::TriangleMesh mesh = counterpart::make_icosphere(2);
    const auto target_from_source = counterpart::match_nearest(mesh, mesh).target_from_source;
    const counterpart::Index matched = counterpart::count_matched(target_from_source);
    std::printf("%d of %d vertices matched\n", matched, mesh.n_vertices());
    return matched == mesh.n_vertices() ? 0 : 1;
}
