// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// The frontier method, without reading files: by default, by positions only and as published, on 1 and 2
// threads.
//
//     frontiers [--stages] [SOURCE TARGET]...
//
// Each pair of mesh files (one connectivity) is measured in all three ways; --stages adds the seconds of each
// stage. Without files: a generated surface bent into another pose and shuffled, at four sizes from 5 to 42
// thousand vertices, and the exponent p of seconds ~ V^p fitted to them. One JSON line per measurement;
// seconds are medians of five.
#include <counterpart/io/mesh_file.hpp>
#include <counterpart/match/frontiers.hpp>
#include <counterpart/mesh/shapes.hpp>
#include <counterpart/mesh/variants.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

namespace {

using namespace counterpart;
using Json = nlohmann::ordered_json;

enum class Variant { sequence, positions_only, paper };

const char* name_of(Variant variant) {
    switch (variant) {
        case Variant::sequence:
            return "default";
        case Variant::positions_only:
            return "positions only";
        case Variant::paper:
            break;
    }
    return "as published";
}

double median(std::vector<double> values) {
    std::nth_element(values.begin(), values.begin() + 2, values.end());
    return values[2];
}

// Median seconds of five runs.
double measure(const std::string& pair, const TriangleMesh& source, const TriangleMesh& target,
               Variant variant, int n_threads, bool stages) {
    FrontiersOptions options;
    options.n_threads = n_threads;
    options.vertex_hashes = variant != Variant::positions_only;
    options.paper = variant == Variant::paper;
    if (options.paper) options.pairing = Pairing::closest;
    std::vector<double> seconds;
    std::map<std::string, std::vector<double>> stage_seconds;
    Index n_frontiers = 0;
    for (int run = 0; run < 5; ++run) {
        const auto begin = std::chrono::steady_clock::now();
        const FrontiersResult result = match_frontiers(source, target, options);
        seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
        for (const StageTime& stage : result.stages) stage_seconds[stage.stage].push_back(stage.seconds);
        n_frontiers = result.components.front().n_frontiers;
    }
    Json line{{"pair", pair},
              {"method", name_of(variant)},
              {"vertices", source.n_vertices()},
              {"frontiers", n_frontiers},
              {"threads", n_threads},
              {"median_seconds", median(seconds)}};
    if (stages)
        for (auto& [stage, values] : stage_seconds) line["stage_seconds"][stage] = median(values);
    std::puts(line.dump().c_str());
    std::fflush(stdout);
    return median(seconds);
}

// Least squares through the logarithms.
double growth_exponent(const std::vector<std::pair<double, double>>& size_and_seconds) {
    const auto n = static_cast<double>(size_and_seconds.size());
    double x = 0, y = 0, xx = 0, xy = 0;
    for (const auto& [size, seconds] : size_and_seconds) {
        const double u = std::log(size), v = std::log(seconds);
        x += u / n;
        y += v / n;
        xx += u * u / n;
        xy += u * v / n;
    }
    return (xy - x * y) / (xx - x * x);
}

// A torus with bumps, so that no two parts are alike, and every seventh cell cut the other way.
TriangleMesh generated(int rings, int segments) {
    TriangleMesh mesh = make_torus(rings, segments);
    for (Index t = 0; t < mesh.n_triangles(); t += 2) {
        if ((t / 2 * 2654435761U) % 7 != 0) continue;
        const Index a = mesh.triangles(t, 0), b = mesh.triangles(t, 1), c = mesh.triangles(t, 2),
                    d = mesh.triangles(t + 1, 2);
        mesh.triangles.row(t) << a, b, d;
        mesh.triangles.row(t + 1) << b, c, d;
    }
    return deform(mesh, {.warp = 0.1, .seed = 3});
}

void measure_growth() {
    const std::vector<std::pair<int, int>> sizes{{126, 40}, {180, 57}, {252, 80}, {365, 115}};
    for (const Variant variant : {Variant::sequence, Variant::positions_only, Variant::paper}) {
        for (const int n_threads : {1, 2}) {
            std::vector<std::pair<double, double>> times;
            for (const auto& [rings, segments] : sizes) {
                const TriangleMesh source = generated(rings, segments);
                const TriangleMesh target = shuffle(deform(source, {.bend = 1, .twist = 0.5}), 1).mesh;
                times.emplace_back(source.n_vertices(),
                                   measure("generated", source, target, variant, n_threads, false));
            }
            std::puts(Json{{"measurement", "growth from 5 to 42 thousand vertices"},
                           {"method", name_of(variant)},
                           {"threads", n_threads},
                           {"exponent", growth_exponent(times)}}
                          .dump()
                          .c_str());
        }
    }
}

}  // namespace

int main(int argc, char** argv) {
    std::vector<std::string> files(argv + 1, argv + argc);
    const bool stages = !files.empty() && files.front() == "--stages";
    if (stages) files.erase(files.begin());
    if (files.size() % 2 != 0) {
        std::fputs("usage: frontiers [--stages] [SOURCE TARGET]...\n", stderr);
        return 2;
    }
    if (files.empty()) measure_growth();
    for (std::size_t i = 0; i + 1 < files.size(); i += 2) {
        const TriangleMesh source = read_mesh(files[i]).mesh, target = read_mesh(files[i + 1]).mesh;
        for (const Variant variant : {Variant::sequence, Variant::positions_only, Variant::paper})
            for (const int n_threads : {1, 2}) measure(files[i], source, target, variant, n_threads, stages);
    }
    return 0;
}
