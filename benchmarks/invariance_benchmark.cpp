// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// What a change of the input that should not matter does to the spectral method's error:
//
//     invariance DATA RESULTS.jsonl [COUNT [SEED]]
//
// COUNT pairs (20) are drawn with SEED (1) from the sets below in the folder DATA, laid out as for
// `accuracy`. Each is matched as it is, swapped, with both meshes rotated, with the target scaled, and with
// both renumbered. One JSON line per pair goes to RESULTS; pairs that are there already are not run again.
// Errors are geodesic, times 100 / sqrt(target area); the last line on stdout gives the largest changes.
#include "base/random.hpp"

#include <counterpart/evaluation/evaluate.hpp>
#include <counterpart/io/map_file.hpp>
#include <counterpart/io/mesh_file.hpp>
#include <counterpart/match/spectral.hpp>
#include <counterpart/mesh/variants.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <mutex>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include <nlohmann/json.hpp>

namespace {

using namespace counterpart;
using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

const std::vector<std::string> sets{"faust_r", "tosca_r", "smal_r", "shrec19"};
const std::vector<std::string> changes{"swap", "rotate", "scale", "renumber"};

struct Pair {
    std::string set, source, target;
    auto operator<=>(const Pair&) const = default;
};

// Any ordered pair of a set; of tosca_r, whose folder holds three classes, one of its list.
std::vector<Pair> pairs_of(const fs::path& data, const std::string& set) {
    std::vector<Pair> pairs;
    if (set == "tosca_r") {
        std::ifstream file(data / set / "pairs.txt");
        for (std::string a, b; file >> a >> b;) pairs.push_back({set, a, b});
        return pairs;
    }
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(data / set))
        if (entry.path().extension() == ".off") names.insert(entry.path().stem().string());
    for (const std::string& a : names)
        for (const std::string& b : names)
            if (a != b) pairs.push_back({set, a, b});
    return pairs;
}

// From each set in turn, none twice.
std::vector<Pair> draw(const fs::path& data, std::size_t count, std::uint64_t seed) {
    Random random(seed);
    std::vector<std::vector<Pair>> left;
    for (const std::string& set : sets) left.push_back(pairs_of(data, set));
    std::vector<Pair> drawn;
    for (std::size_t i = 0; drawn.size() < count; ++i) {
        std::vector<Pair>& pairs = left[i % left.size()];
        if (i >= left.size() * count) break;
        if (pairs.empty()) continue;
        const auto k = static_cast<std::ptrdiff_t>(random.below(pairs.size()));
        drawn.push_back(pairs[static_cast<std::size_t>(k)]);
        pairs.erase(pairs.begin() + k);
    }
    return drawn;
}

VertexMap matched(const TriangleMesh& source, const TriangleMesh& target) {
    return match_spectral(source, target, {.n_threads = 1}, {.n_threads = 1}).target_from_source;
}

VertexMap matched_after(const std::string& change, const TriangleMesh& source, const TriangleMesh& target) {
    if (change == "swap")
        return match_spectral(target, source, {.n_threads = 1}, {.n_threads = 1}).source_from_target;
    if (change == "rotate") return matched(move_at_random(source, 11), move_at_random(target, 12));
    if (change == "scale") {
        TriangleMesh scaled = target;
        scaled.vertices *= 0.037;
        return matched(source, scaled);
    }
    const ShuffleResult a = shuffle(source, 21), b = shuffle(target, 22);
    const VertexMap between = matched(a.mesh, b.mesh);
    std::vector<Index> map(between.image().size());
    const VertexMap original_from_b = invert({b.shuffled_from_original, target.n_vertices()});
    for (Index v = 0; v < source.n_vertices(); ++v)
        map[static_cast<std::size_t>(v)] =
            original_from_b[between[a.shuffled_from_original[static_cast<std::size_t>(v)]]];
    return {std::move(map), target.n_vertices()};
}

Json measure(const fs::path& data, const Pair& pair) {
    const fs::path folder = data / pair.set;
    const TriangleMesh source = read_mesh(folder / (pair.source + ".off")).mesh;
    const TriangleMesh target = read_mesh(folder / (pair.target + ".off")).mesh;
    const auto of_template = [&](const std::string& name) {
        return read_vertex_map(folder / "corres" / (name + ".vts"), IndexBase::one);
    };
    const GroundTruth truth = truth_from_template(of_template(pair.source), of_template(pair.target));
    const auto error = [&](const VertexMap& map) {
        return evaluate(map, truth, source, target, {.n_threads = 1}).mean_error;
    };
    Json line = {{"set", pair.set}, {"source", pair.source}, {"target", pair.target}};
    line["mean_error"] = error(matched(source, target));
    for (const std::string& change : changes) line[change] = error(matched_after(change, source, target));
    return line;
}

void print_summary(const std::vector<Json>& lines) {
    Json summary = {{"summary", "change of the mean error"}, {"pairs", lines.size()}};
    for (const std::string& change : changes) {
        double largest = 0, sum = 0;
        int above = 0;
        for (const Json& line : lines) {
            const double by = std::abs(line[change].get<double>() - line["mean_error"].get<double>());
            largest = std::max(largest, by);
            sum += by;
            above += by > 0.3 ? 1 : 0;
        }
        summary[change] = {{"mean", sum / static_cast<double>(std::max<std::size_t>(1, lines.size()))},
                           {"largest", largest},
                           {"pairs_above_0.3", above}};
    }
    std::printf("%s\n", summary.dump().c_str());
}

int run(const fs::path& data, const fs::path& results, std::size_t count, std::uint64_t seed) {
    const std::vector<Pair> pairs = draw(data, count, seed);
    std::vector<Json> lines;
    std::set<Pair> done;
    std::ifstream earlier(results);
    for (std::string text; std::getline(earlier, text);) {
        const Json line = Json::parse(text);
        const Pair pair{line["set"], line["source"], line["target"]};
        if (std::find(pairs.begin(), pairs.end(), pair) != pairs.end() && done.insert(pair).second)
            lines.push_back(line);
    }
    std::mutex mutex;
    std::ofstream output(results, std::ios::app);
    std::size_t next = 0;
    const auto work = [&] {
        while (true) {
            Pair pair;
            {
                const std::lock_guard lock(mutex);
                while (next < pairs.size() && done.contains(pairs[next])) ++next;
                if (next == pairs.size()) return;
                pair = pairs[next++];
            }
            const Json line = measure(data, pair);
            const std::lock_guard lock(mutex);
            output << line.dump() << std::endl;
            lines.push_back(line);
        }
    };
    std::thread second(work);
    work();
    second.join();
    print_summary(lines);
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 3) {
        std::fputs("usage: invariance DATA RESULTS.jsonl [COUNT [SEED]]\n", stderr);
        return 2;
    }
    try {
        return run(argv[1], argv[2], argc > 3 ? std::stoul(argv[3]) : 20,
                   argc > 4 ? std::stoull(argv[4]) : 1);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "error: %s\n", error.what());
        return 1;
    }
}
