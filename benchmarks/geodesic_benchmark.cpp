// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Graph construction, one search, and batches of searches on 1 and 2 threads, on tori with 16 thousand to 1
// million vertices whose vertices are in random order. One JSON line per measurement; seconds are medians of
// five.
#include "base/random.hpp"

#include <counterpart/geodesic/distances.hpp>
#include <counterpart/mesh/shapes.hpp>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <numeric>
#include <vector>

namespace {

using namespace counterpart;

template <class Work>
double median_seconds(const Work& work) {
    std::vector<double> seconds;
    for (int i = 0; i < 5; ++i) {
        const auto begin = std::chrono::steady_clock::now();
        work();
        seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    }
    std::nth_element(seconds.begin(), seconds.begin() + 2, seconds.end());
    return seconds[2];
}

TriangleMesh shuffled_torus(int rings, int segments) {
    const TriangleMesh torus = make_torus(rings, segments);
    std::vector<Index> place(static_cast<std::size_t>(torus.n_vertices()));
    std::iota(place.begin(), place.end(), 0);
    Random(1).shuffle(place);
    TriangleMesh mesh = torus;
    for (Index v = 0; v < torus.n_vertices(); ++v)
        mesh.vertices.row(place[static_cast<std::size_t>(v)]) = torus.vertices.row(v);
    for (Index& v : mesh.triangles.reshaped()) v = place[static_cast<std::size_t>(v)];
    return mesh;
}

void print(const char* what, Index n_vertices, int n_sources, int n_threads, double seconds) {
    std::printf(
        R"({"measurement": "%s", "vertices": %d, "sources": %d, "threads": %d, "median_seconds": %.5f})"
        "\n",
        what, n_vertices, n_sources, n_threads, seconds);
    std::fflush(stdout);
}

void measure(int rings, int segments) {
    const TriangleMesh mesh = shuffled_torus(rings, segments);
    const Index n = mesh.n_vertices();
    print("graph", n, 0, 1, median_seconds([&] { DistanceGraph graph(mesh); }));
    for (const bool shortcuts : {true, false}) {
        const DistanceGraph graph(mesh, {.shortcuts = shortcuts});
        const char* one = shortcuts ? "one source" : "one source, plain edges";
        print(one, n, 1, 1, median_seconds([&] { distances_from(graph, n / 3); }));
    }
    const DistanceGraph graph(mesh);
    std::vector<Index> sources;
    for (Index i = 0; i < 16; ++i) sources.push_back(n / 16 * i);
    for (const int n_threads : {1, 2}) {
        print("rows", n, 16, n_threads,
              median_seconds([&] { distance_rows(graph, sources, {.n_threads = n_threads}); }));
    }
}

}  // namespace

int main() {
    measure(200, 80);
    measure(400, 160);
    measure(800, 320);
    measure(1600, 640);
}
