// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Matching small meshes that are made of the bytes: triangles of any kind, finite coordinates of any size.
#include "fuzz/require.hpp"
#include "fuzz/targets.hpp"
#include "match/spectral/stored_shape.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/match/differences.hpp>
#include <counterpart/match/exact.hpp>
#include <counterpart/match/partial.hpp>
#include <counterpart/match/spectral.hpp>
#include <counterpart/mesh/shapes.hpp>

#include <array>
#include <cmath>
#include <cstdint>

namespace counterpart::fuzz {
namespace {

// Numbers out of the bytes; zeros behind their end.
class Numbers {
  public:
    explicit Numbers(std::string_view bytes) : bytes_(bytes) {}
    bool empty() const { return bytes_.empty(); }
    int byte() {
        if (bytes_.empty()) return 0;
        const int value = static_cast<unsigned char>(bytes_.front());
        bytes_.remove_prefix(1);
        return value;
    }
    Index below(Index limit) { return static_cast<Index>((byte() | byte() << 8) % limit); }
    double coordinate() { return (byte() - 128) / 16.0; }

  private:
    std::string_view bytes_;
};

TriangleMesh base_mesh(Numbers& numbers) {
    const int size = numbers.byte() % 4;
    switch (numbers.byte() % 5) {
        case 0:
            return make_icosphere(size % 2);
        case 1:
            return make_grid(2 + size, 3);
        case 2:
            return make_torus(4 + size, 4);
        case 3: {  // two pieces
            const TriangleMesh one = make_grid(2, 2), two = make_icosphere(0);
            TriangleMesh both{Points(one.n_vertices() + two.n_vertices(), 3),
                              Triangles(one.n_triangles() + two.n_triangles(), 3)};
            both.vertices << one.vertices, two.vertices;
            both.triangles << one.triangles, (two.triangles.array() + one.n_vertices()).matrix();
            return both;
        }
        default: {  // any triangles at all
            const Index n_vertices = 3 + numbers.below(20), n_triangles = 1 + numbers.below(40);
            TriangleMesh mesh{Points(n_vertices, 3), Triangles(n_triangles, 3)};
            for (double& x : mesh.vertices.reshaped()) x = numbers.coordinate();
            for (Index& v : mesh.triangles.reshaped()) v = numbers.below(n_vertices);
            return mesh;
        }
    }
}

// Changes one thing: what meshes in use get wrong, and worse.
void edit(TriangleMesh& mesh, Numbers& numbers) {
    const int kind = numbers.byte() % 9;
    const Index v = numbers.below(mesh.n_vertices()), t = numbers.below(mesh.n_triangles());
    switch (kind) {
        case 0:
            for (int k = 0; k < 3; ++k) mesh.vertices(v, k) = numbers.coordinate();
            break;
        case 1:  // onto another vertex
            mesh.vertices.row(v) = mesh.vertices.row(numbers.below(mesh.n_vertices())).eval();
            break;
        case 2:  // another corner: a flip, a fan, a degenerate triangle
            mesh.triangles(t, numbers.byte() % 3) = v;
            break;
        case 3:  // turned over
            std::swap(mesh.triangles(t, 0), mesh.triangles(t, 1));
            break;
        case 4:  // a duplicate
            mesh.triangles.conservativeResize(mesh.n_triangles() + 1, 3);
            mesh.triangles.row(mesh.n_triangles() - 1) = mesh.triangles.row(t).eval();
            break;
        case 5:  // a hole
            if (mesh.n_triangles() < 2) break;
            mesh.triangles.row(t) = mesh.triangles.row(mesh.n_triangles() - 1).eval();
            mesh.triangles.conservativeResize(mesh.n_triangles() - 1, 3);
            break;
        case 6:  // a vertex in no triangle
            mesh.vertices.conservativeResize(mesh.n_vertices() + 1, 3);
            for (int k = 0; k < 3; ++k) mesh.vertices(mesh.n_vertices() - 1, k) = numbers.coordinate();
            break;
        case 7:  // a sliver, or all of it flat
            mesh.vertices.col(numbers.byte() % 3) *= std::ldexp(1.0, -(numbers.byte() % 64));
            break;
        default:  // huge or tiny, or far away
            if (numbers.byte() % 2 == 0)
                mesh.vertices *= std::ldexp(1.0, (numbers.byte() - 128) * 7);
            else
                mesh.vertices.array() += std::ldexp(1.0, numbers.byte() % 64);
    }
}

// Coordinates that left the range of double are no input.
void make_finite(TriangleMesh& mesh) {
    mesh.vertices = mesh.vertices.array().isFinite().select(mesh.vertices, 0.0);
}

struct Pair {
    TriangleMesh source, target;
};

// The target is the source with edits, or a mesh of its own.
Pair meshes_from(Numbers& numbers) {
    const int n_edits = numbers.byte() % 8, n_more = numbers.byte() % 8;
    const bool unrelated = numbers.byte() % 4 == 0;
    Pair pair;
    pair.source = base_mesh(numbers);
    for (int i = 0; i < n_edits; ++i) edit(pair.source, numbers);
    pair.target = unrelated ? base_mesh(numbers) : pair.source;
    for (int i = 0; i < n_more; ++i) edit(pair.target, numbers);
    make_finite(pair.source);
    make_finite(pair.target);
    return pair;
}

void require_map(const VertexMap& map, const Pair& pair) {
    require(map.source_size() == pair.source.n_vertices());
    for (const Index image : map.image()) require(image >= -1 && image < pair.target.n_vertices());
}

void exact(Numbers& numbers) {
    ExactOptions options;
    options.n_threads = 1;
    options.allow_mirror = numbers.byte() % 2 == 1;
    options.max_alternatives = numbers.byte() % 3;
    if (numbers.byte() % 4 == 0) options.weld_distance = (numbers.byte() % 8) / 16.0;
    const Pair pair = meshes_from(numbers);
    const ExactResult result = match_exact(pair.source, pair.target, options);
    if (result.identical)
        require_map(result.target_from_source, pair);
    else
        require(!result.difference.empty());
}

void differences(Numbers& numbers) {
    const Pair pair = meshes_from(numbers);
    const MeshDifferences result = find_differences(pair.source, pair.target, {.n_threads = 1});
    require_map(result.target_from_source, pair);
    require(!result.summary.empty());
}

void spectral(Numbers& numbers) {
    SpectralOptions options;
    options.n_threads = 1;
    options.symmetric = numbers.byte() % 8 == 0;
    const Pair pair = meshes_from(numbers);
    require_map(match_spectral(pair.source, pair.target, options).target_from_source, pair);
}

// A ball or a tube with parts cut off and other edits: 50 vertices are the least.
void partial(Numbers& numbers) {
    PartialOptions options;
    options.n_threads = 1;
    options.n_samples = 200;
    options.n_alternatives = numbers.byte() % 3;
    options.same_scale = numbers.byte() % 32 != 0;  // searching the scale takes long
    options.part = static_cast<Part>(numbers.byte() % 5);
    const int size = numbers.byte() % 4;
    Pair pair;
    pair.source = numbers.byte() % 2 == 0 ? make_icosphere(2) : make_torus(9 + size, 7);
    pair.target = numbers.byte() % 4 == 0 ? make_torus(9, 7 + size) : pair.source;
    for (TriangleMesh* mesh : {&pair.source, &pair.target}) {
        const Index n_kept = mesh->n_triangles() - numbers.below(mesh->n_triangles());
        mesh->triangles.conservativeResize(n_kept, 3);
        for (int i = numbers.byte() % 8; i > 0; --i) edit(*mesh, numbers);
        make_finite(*mesh);
    }
    const PartialResult result = match_partial(pair.source, pair.target, options);
    require_map(result.target_from_source, pair);
    require(result.part != Part::unknown && !(result.confidence.array() < 0).any());
}

template <void (*match)(Numbers&)>
void matched_or_refused(std::string_view bytes) {
    Numbers numbers(bytes);
    try {
        match(numbers);
    } catch (const InvalidInput&) {
    } catch (const NumericalError&) {
    }
}

// What `match --cache` keeps. Among the matchers, because shapes are made of most of the library.
void read_shape_or_refuse(std::string_view bytes) {
    try {
        require(spectral_match::to_bytes(spectral_match::shape_from_bytes(bytes)) == bytes);
    } catch (const InvalidInput&) {
    }
}

constexpr std::array<Target, 5> matchers = {{{"exact", matched_or_refused<exact>},
                                             {"differences", matched_or_refused<differences>},
                                             {"spectral", matched_or_refused<spectral>},
                                             {"partial", matched_or_refused<partial>},
                                             {"shape", read_shape_or_refuse}}};

}  // namespace

std::span<const Target> matcher_targets() { return matchers; }

}  // namespace counterpart::fuzz
