// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include <counterpart/match/exact.hpp>
#include <counterpart/mesh/shapes.hpp>

int main() {
    const counterpart::TriangleMesh mesh = counterpart::make_torus(8, 12);
    return counterpart::match_exact(mesh, mesh).identical ? 0 : 1;
}
