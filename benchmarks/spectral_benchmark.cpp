// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Time, memory and error of the spectral method by size:
//
//     spectral [MESH POSED_MESH] [--subdivisions N] [--repeats N] [--threads N]
//
// The two meshes are poses of one, with the same triangles (default: a figure that the program makes); both
// are subdivided N times (0). The posed one is then triangulated anew, by flipping edges at random, and its
// vertices and triangles are shuffled, so that connectivity tells nothing; both are written to files. Timed
// is what `counterpart match --method spectral` does: read, match, write. One JSON line: medians in seconds,
// of each stage too, MiB at the peak
// (the meshes as they were made are in it too), and the mean error at 2000 vertices x 100 / sqrt(area).
#include "base/random.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/evaluation/evaluate.hpp>
#include <counterpart/io/map_file.hpp>
#include <counterpart/io/mesh_file.hpp>
#include <counterpart/match/spectral.hpp>
#include <counterpart/mesh/shapes.hpp>
#include <counterpart/mesh/variants.hpp>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>
#include <unistd.h>

namespace {

using namespace counterpart;
using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

// In MiB; Linux lets a process set its peak back to what it holds now.
void reset_peak() { std::ofstream("/proc/self/clear_refs") << 5; }
double peak_memory() {
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;)
        if (word == "VmHWM:" && status >> word) return std::stod(word) / 1024;
    return 0;
}

// Half of the edges, at random, flipped where the two triangles stay turned alike and no edge is doubled. An
// edge is its two vertices, smaller first.
class Retriangulation {
  public:
    explicit Retriangulation(TriangleMesh mesh) : mesh_(std::move(mesh)) {
        for (Index t = 0; t < mesh_.n_triangles(); ++t)
            for (int c = 0; c < 3; ++c) triangles_[edge(t, c)].push_back(t);
    }

    TriangleMesh flipped(std::uint64_t seed) {
        Random random(seed);
        for (Index t = 0; t < mesh_.n_triangles(); ++t)
            if (random.below(4) < 3) flip(t, static_cast<int>(random.below(3)));
        return std::move(mesh_);
    }

  private:
    using Edge = std::pair<Index, Index>;

    Edge edge(Index t, int c) const {
        return std::minmax(Index(mesh_.triangles(t, c)), Index(mesh_.triangles(t, (c + 1) % 3)));
    }
    Eigen::Vector3d normal(Index a, Index b, Index c) const {
        const auto at = [&](Index v) -> Eigen::Vector3d { return mesh_.vertices.row(v).transpose(); };
        return (at(b) - at(a)).cross(at(c) - at(a));
    }
    void flip(Index t, int c) {
        const auto shared = triangles_.find(edge(t, c));
        if (shared->second.size() != 2) return;
        const Index u = shared->second[0] == t ? shared->second[1] : shared->second[0];
        const Index a = mesh_.triangles(t, c), b = mesh_.triangles(t, (c + 1) % 3),
                    x = mesh_.triangles(t, (c + 2) % 3);
        int d = 0;
        while (d < 2 && (mesh_.triangles(u, d) == a || mesh_.triangles(u, d) == b)) ++d;
        const Index y = mesh_.triangles(u, d);
        const Eigen::Vector3d whole = normal(a, b, x) + normal(b, a, y);
        if (triangles_.contains(std::minmax(x, y)) || normal(x, a, y).dot(whole) <= 0 ||
            normal(y, b, x).dot(whole) <= 0)
            return;
        triangles_.erase(shared);
        triangles_[std::minmax(x, y)] = {t, u};
        std::replace(triangles_[std::minmax(a, y)].begin(), triangles_[std::minmax(a, y)].end(), u, t);
        std::replace(triangles_[std::minmax(b, x)].begin(), triangles_[std::minmax(b, x)].end(), t, u);
        mesh_.triangles.row(t) << x, a, y;
        mesh_.triangles.row(u) << y, b, x;
    }

    TriangleMesh mesh_;
    std::map<Edge, std::vector<Index>> triangles_;
};

struct Arguments {
    std::vector<std::string> meshes;
    int subdivisions = 0, repeats = 5, threads = 2;
};

Arguments parse(int argc, char** argv) {
    Arguments arguments;
    for (int i = 1; i < argc; ++i) {
        const std::string argument = argv[i];
        const auto number = [&] { return std::stoi(i + 1 < argc ? argv[++i] : ""); };
        if (argument == "--subdivisions")
            arguments.subdivisions = number();
        else if (argument == "--repeats")
            arguments.repeats = std::max(number(), 1);
        else if (argument == "--threads")
            arguments.threads = number();
        else
            arguments.meshes.push_back(argument);
    }
    if (!arguments.meshes.empty() && arguments.meshes.size() != 2)
        throw InvalidInput("two meshes are needed, or none");
    return arguments;
}

Json measure(const fs::path& a, const fs::path& b, const fs::path& map_file, const Arguments& arguments,
             SpectralResult& result) {
    std::vector<double> whole, reading, writing;
    std::map<std::string, std::vector<double>> stages;
    reset_peak();
    for (int i = 0; i < arguments.repeats; ++i) {
        const auto start = std::chrono::steady_clock::now();
        const TriangleMesh source = read_mesh(a).mesh, target = read_mesh(b).mesh;
        reading.push_back(seconds_since(start));
        result = match_spectral(source, target, {.n_threads = arguments.threads});
        const auto matched = std::chrono::steady_clock::now();
        write_vertex_map(result.target_from_source, map_file);
        writing.push_back(seconds_since(matched));
        whole.push_back(seconds_since(start));
        for (const StageTime& stage : result.stages) stages[stage.stage].push_back(stage.seconds);
    }
    Json seconds{{"read", median(reading)}};
    for (const StageTime& stage : result.stages) seconds[stage.stage] = median(stages[stage.stage]);
    seconds["write"] = median(writing);
    return {{"median_seconds", median(whole)}, {"stage_seconds", seconds}, {"peak_mebibytes", peak_memory()}};
}

void run(const Arguments& arguments) {
    const auto pose = [&](std::size_t i) {
        TriangleMesh mesh =
            arguments.meshes.empty() ? make_body({.subdivisions = 2}) : read_mesh(arguments.meshes[i]).mesh;
        if (arguments.meshes.empty() && i == 1)
            mesh = deform(mesh, {.bend = 0.6, .twist = 0.3, .warp = 0.05});
        for (int k = 0; k < arguments.subdivisions; ++k) mesh = subdivide(mesh);
        return mesh;
    };
    const fs::path folder = fs::temp_directory_path() / ("spectral_benchmark_" + std::to_string(getpid()));
    fs::create_directories(folder);
    const TriangleMesh source = pose(0);
    const ShuffleResult target = shuffle(Retriangulation(pose(1)).flipped(1), 1);
    write_mesh(source, folder / "a.ply");
    write_mesh(target.mesh, folder / "b.ply");
    SpectralResult result;
    const Json measured = measure(folder / "a.ply", folder / "b.ply", folder / "map.txt", arguments, result);
    fs::remove_all(folder);
    const VertexMap truth(target.shuffled_from_original, target.mesh.n_vertices());
    const EvaluationReport report =
        evaluate(result.target_from_source, sampled(truth_from_map(truth), 2000), source, target.mesh);
    Json line{{"benchmark", "spectral"},
              {"mesh", arguments.meshes.empty() ? "figure" : arguments.meshes[0]},
              {"vertices", source.n_vertices()},
              {"triangles", source.n_triangles()},
              {"threads", arguments.threads},
              {"repeats", arguments.repeats}};
    line.update(measured);
    line["mean_error"] = report.mean_error;
    std::puts(line.dump().c_str());
}

}  // namespace

int main(int argc, char** argv) try { run(parse(argc, argv)); } catch (const std::exception& error) {
    std::fprintf(stderr, "spectral: %s\n", error.what());
    return 1;
}
