// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Writes a figure and a shuffled copy, reads them back, and matches them: every vertex must find its own.
#include <counterpart/io/mesh_file.hpp>
#include <counterpart/match/match.hpp>
#include <counterpart/mesh/shapes.hpp>
#include <counterpart/mesh/variants.hpp>

int main() {
    const counterpart::TriangleMesh body = counterpart::make_body();
    const counterpart::ShuffleResult shuffled = counterpart::shuffle(body, 3);
    counterpart::write_mesh(body, "a.obj");
    counterpart::write_mesh(shuffled.mesh, "b.obj");
    const counterpart::MatchResult result =
        counterpart::match(counterpart::read_mesh("a.obj").mesh, counterpart::read_mesh("b.obj").mesh);
    const counterpart::VertexMap truth(shuffled.shuffled_from_original, body.n_vertices());
    return result.target_from_source == truth ? 0 : 1;
}
