// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "content.hpp"
#include "guarded.hpp"

#include <counterpart/mesh/shapes.hpp>
#include <counterpart/mesh/variants.hpp>

#include <utility>

#include <emscripten/bind.h>

namespace counterpart::javascript {
namespace {

constexpr std::uint64_t seed = 7;

Content content_of(TriangleMesh mesh) {
    Content content;
    content.content.mesh = std::move(mesh);
    return content;
}

// The second mesh of an example; the first is the body.
TriangleMesh partner_of(const TriangleMesh& body, const std::string& kind) {
    const TriangleMesh posed = deform(body, {.bend = 1.0, .twist = 0.4});
    if (kind == "shuffled") return shuffle(posed, seed).mesh;
    const TriangleMesh remeshed = retriangulate(posed, {.seed = seed}).mesh;
    if (kind == "remeshed") return shuffle(remeshed, seed).mesh;
    if (kind == "part") {
        const auto heights = remeshed.vertices.col(1);
        const double knee = heights.minCoeff() + 0.35 * (heights.maxCoeff() - heights.minCoeff());
        return shuffle(cut_by_plane(remeshed, {0, 1, 0}, knee).mesh, seed).mesh;
    }
    throw InvalidInput("there is no example '" + kind + "': shuffled, remeshed or part");
}

val example(const std::string& kind) {
    return guarded([&] {
        TriangleMesh body = make_body({.subdivisions = 2});
        TriangleMesh partner = partner_of(body, kind);
        val pair = val::array();
        pair.set(0, content_of(std::move(body)));
        pair.set(1, content_of(std::move(partner)));
        return pair;
    });
}

}  // namespace

EMSCRIPTEN_BINDINGS(examples) { emscripten::function("example", &example); }

}  // namespace counterpart::javascript
