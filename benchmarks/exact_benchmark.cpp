// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Exact matching of a mesh, and of its subdivisions, against themselves shuffled; and the canonical labeling
// of bliss on the same meshes: of their faces and vertices, which like ours finds partners for both, and of
// their vertices and edges alone, which does not know the faces (neither knows the winding). One JSON line
// per measurement.
//
//   exact [MESH] [--subdivisions N] [--repeats N] [--threads N] [--bliss-up-to V]
#include <counterpart/io/mesh_file.hpp>
#include <counterpart/match/exact.hpp>
#include <counterpart/mesh/adjacency.hpp>
#include <counterpart/mesh/shapes.hpp>
#include <counterpart/mesh/variants.hpp>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <fstream>
#include <string>
#include <vector>

#include <bliss/graph.hh>
#include <fmt/format.h>

namespace counterpart {
namespace {

using Clock = std::chrono::steady_clock;

struct Seconds {
    double wall, cpu;
};

double cpu_seconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

template <class Work>
Seconds median_seconds(int repeats, const Work& work) {
    std::vector<double> wall, cpu;
    for (int i = 0; i < repeats; ++i) {
        const auto start = Clock::now();
        const double cpu_start = cpu_seconds();
        work();
        wall.push_back(std::chrono::duration<double>(Clock::now() - start).count());
        cpu.push_back(cpu_seconds() - cpu_start);
    }
    std::sort(wall.begin(), wall.end());
    std::sort(cpu.begin(), cpu.end());
    return {wall[wall.size() / 2], cpu[cpu.size() / 2]};
}

// In MiB; Linux lets a process set its peak back to what it holds now.
double memory(const char* field) {
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;)
        if (word == field && status >> word) return std::stod(word) / 1024;
    return 0;
}
void reset_peak() { std::ofstream("/proc/self/clear_refs") << 5; }

bliss::Graph vertices_and_edges(const TriangleMesh& mesh) {
    bliss::Graph graph(static_cast<unsigned>(mesh.n_vertices()));
    const Adjacency adjacency(mesh);
    for (Index v = 0; v < mesh.n_vertices(); ++v)
        for (const Index w : adjacency.neighbors(v))
            if (v < w) graph.add_edge(static_cast<unsigned>(v), static_cast<unsigned>(w));
    return graph;
}

bliss::Graph faces_and_vertices(const TriangleMesh& mesh) {
    const auto n_vertices = static_cast<unsigned>(mesh.n_vertices());
    bliss::Graph graph(n_vertices);
    for (Index t = 0; t < mesh.n_triangles(); ++t) {
        const unsigned face = graph.add_vertex(1);
        for (int c = 0; c < 3; ++c) graph.add_edge(face, static_cast<unsigned>(mesh.triangles(t, c)));
    }
    return graph;
}

// The peer's whole job: a labeling of each mesh's graph; equal labels are partners.
void measure_bliss(const std::string& name, const TriangleMesh& mesh, const TriangleMesh& target, int repeats,
                   const char* graph_name, bliss::Graph (*make_graph)(const TriangleMesh&), double our_cpu) {
    const Seconds peer = median_seconds(repeats, [&] {
        for (const TriangleMesh* side : {&mesh, &target}) {
            bliss::Graph graph = make_graph(*side);
            bliss::Stats stats;
            graph.canonical_form(stats, nullptr, nullptr);
        }
    });
    fmt::print(
        "{{\"benchmark\": \"exact\", \"peer\": \"bliss, {}\", \"mesh\": \"{}\", \"vertices\": {}, "
        "\"threads\": 1, \"repeats\": {}, \"median_seconds\": {:.6f}, \"median_cpu_seconds\": {:.6f}, "
        "\"times_ours\": {:.1f}}}\n",
        graph_name, name, mesh.n_vertices(), repeats, peer.wall, peer.cpu, peer.cpu / our_cpu);
}

void measure(const std::string& name, const TriangleMesh& mesh, int repeats, int threads, Index bliss_up_to) {
    const ShuffleResult target = shuffle(mesh, 1);
    const double before = memory("VmRSS:");
    reset_peak();
    const ExactOptions options{.n_threads = threads};
    ExactResult result = match_exact(mesh, target.mesh, options);
    const double peak = memory("VmHWM:") - before;
    const bool right = result.identical && result.target_from_source.image() == target.shuffled_from_original;
    const Seconds ours = median_seconds(repeats, [&] { result = match_exact(mesh, target.mesh, options); });
    fmt::print(
        "{{\"benchmark\": \"exact\", \"mesh\": \"{}\", \"vertices\": {}, \"triangles\": {}, \"threads\": {}, "
        "\"repeats\": {}, \"median_seconds\": {:.6f}, \"median_cpu_seconds\": {:.6f}, "
        "\"nanoseconds_per_triangle\": {:.1f}, "
        "\"mebibytes_beyond_meshes\": {:.1f}, \"all_right\": {}, \"automorphisms\": \"{}\"}}\n",
        name, mesh.n_vertices(), mesh.n_triangles(), threads, repeats, ours.wall, ours.cpu,
        1e9 * ours.cpu / mesh.n_triangles(), peak, right, to_string(result.automorphisms));
    if (mesh.n_vertices() > bliss_up_to) return;
    measure_bliss(name, mesh, target.mesh, repeats, "faces and vertices", faces_and_vertices, ours.cpu);
    measure_bliss(name, mesh, target.mesh, repeats, "vertices and edges", vertices_and_edges, ours.cpu);
}

}  // namespace
}  // namespace counterpart

int main(int argc, char** argv) {
    using namespace counterpart;
    std::string file;
    int subdivisions = 3, repeats = 5, threads = 2;
    Index bliss_up_to = 100'000;
    for (int i = 1; i < argc; ++i) {
        const std::string argument = argv[i];
        if (argument == "--subdivisions" && i + 1 < argc)
            subdivisions = std::stoi(argv[++i]);
        else if (argument == "--repeats" && i + 1 < argc)
            repeats = std::stoi(argv[++i]);
        else if (argument == "--threads" && i + 1 < argc)
            threads = std::stoi(argv[++i]);
        else if (argument == "--bliss-up-to" && i + 1 < argc)
            bliss_up_to = std::stoi(argv[++i]);
        else
            file = argument;
    }
    TriangleMesh mesh = file.empty() ? make_icosphere(5) : read_mesh(file).mesh;
    const std::string name = file.empty() ? "icosphere" : file;
    for (int level = 0; level <= subdivisions; ++level) {
        if (level > 0) mesh = subdivide(mesh);
        measure(name, mesh, repeats, threads, bliss_up_to);
    }
}
