// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Accuracy and cost of the spectral method on a folder of meshes with ground truth:
//
//     accuracy FOLDER PAIRS RESULTS.jsonl [--seeds N] [--first-seed N] [--every N] [--from N]
//              [--commit NAME]
//
// FOLDER holds NAME.off and corres/NAME.vts (line k of any two name the same point, from 1). PAIRS is
// "ordered" (all ordered pairs), "unordered" (all i < j) or a file of two names a line; of these every Nth,
// from number --from on. Each pair is matched once for each seed, from which samples begin
// (SpectralShapeOptions::seed). One JSON line each, with the commit's name, goes to RESULTS; what is there
// already is not run again. Two pairs run at a time, on one thread each; seconds are of its processor, those
// of preparing both shapes apart. Errors are geodesic, times 100 / sqrt(target area), at every 4th point. The
// last line on stdout is a summary; benchmarks/compare.py compares results.
#include <counterpart/geodesic/distances.hpp>
#include <counterpart/io/map_file.hpp>
#include <counterpart/io/mesh_file.hpp>
#include <counterpart/match/spectral.hpp>
#include <counterpart/mesh/measure.hpp>

#include <algorithm>
#include <cmath>
#include <compare>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <mutex>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>

#include <nlohmann/json.hpp>

namespace {

using namespace counterpart;
using Json = nlohmann::ordered_json;
using Pair = std::pair<std::string, std::string>;
namespace fs = std::filesystem;

std::vector<Pair> list_pairs(const fs::path& folder, const std::string& which) {
    std::vector<Pair> pairs;
    if (which != "ordered" && which != "unordered") {
        std::ifstream file(which);
        for (std::string a, b; file >> a >> b;) pairs.emplace_back(a, b);
        return pairs;
    }
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.path().extension() == ".off") names.insert(entry.path().stem().string());
    for (const std::string& a : names)
        for (const std::string& b : names)
            if (a < b || (a != b && which == "ordered")) pairs.emplace_back(a, b);
    return pairs;
}

// Of this thread: other programs on the machine do not count.
double processor_seconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct Run {
    Pair pair;
    std::uint64_t seed = 0;

    auto operator<=>(const Run&) const = default;
};

constexpr double good = 5;  // an error below is right

Json measure(const fs::path& folder, const Run& run) {
    const auto& [pair, seed] = run;
    const TriangleMesh source = read_mesh(folder / (pair.first + ".off")).mesh;
    const TriangleMesh target = read_mesh(folder / (pair.second + ".off")).mesh;
    const double start = processor_seconds();
    const SpectralShapeOptions preparation{.seed = seed, .n_threads = 1};
    const SpectralShape a(source, preparation), b(target, preparation);
    const double prepared = processor_seconds();
    const SpectralResult result = match_spectral(a, b, {.n_threads = 1});
    const double matched = processor_seconds();

    const auto truth = [&](const std::string& name) {
        return read_vertex_map(folder / "corres" / (name + ".vts"), IndexBase::one);
    };
    const VertexMap on_source = truth(pair.first), on_target = truth(pair.second);
    std::vector<std::pair<Index, Index>> ends;
    Vector confidence((on_source.source_size() + 3) / 4);
    for (Index k = 0; k < on_source.source_size(); k += 4) {
        confidence[static_cast<Eigen::Index>(ends.size())] = result.confidence[on_source[k]];
        ends.emplace_back(on_target[k], result.target_from_source[on_source[k]]);
    }
    const Vector errors =
        pair_distances(DistanceGraph(target), ends, {.n_threads = 1}) * 100 / std::sqrt(surface_area(target));
    // Of points by tenths of confidence: how many, how many right, and the sum of their confidence.
    std::vector<int> count(10), right(10);
    std::vector<double> sum(10);
    for (Eigen::Index k = 0; k < errors.size(); ++k) {
        const auto bin = static_cast<std::size_t>(std::min(9.0, confidence[k] * 10));
        ++count[bin];
        right[bin] += errors[k] < good ? 1 : 0;
        sum[bin] += confidence[k];
    }
    Json line = {{"set", folder.filename().string()},
                 {"source", pair.first},
                 {"target", pair.second},
                 {"seed", seed},
                 {"error", errors.mean()},
                 {"score", result.score},
                 {"margin", std::min(result.margin, 9.0)},
                 {"confidence", confidence.mean()},
                 {"prepare_seconds", prepared - start},
                 {"match_seconds", matched - prepared},
                 {"bins", {{"count", count}, {"right", right}, {"confidence", sum}}}};
    for (const StageTime& stage : result.stages) line["stages"][stage.stage] = stage.seconds;
    return line;
}

void print_summary(const std::string& folder, const std::vector<Json>& lines) {
    std::vector<double> errors, seconds;
    for (const Json& line : lines) {
        errors.push_back(line["error"]);
        seconds.push_back(line["match_seconds"]);
    }
    if (errors.empty()) return;
    double sum = 0;
    for (const double e : errors) sum += e;
    std::sort(errors.begin(), errors.end());
    std::sort(seconds.begin(), seconds.end());
    const auto wrong = std::count_if(errors.begin(), errors.end(), [](double e) { return e > 6; });
    const Json summary = {{"summary", folder},
                          {"runs", errors.size()},
                          {"mean_error", sum / static_cast<double>(errors.size())},
                          {"median_error", errors[errors.size() / 2]},
                          {"largest_error", errors.back()},
                          {"runs_above_6", wrong},
                          {"median_match_seconds", seconds[seconds.size() / 2]},
                          {"largest_match_seconds", seconds.back()}};
    std::printf("%s\n", summary.dump().c_str());
}

struct Arguments {
    fs::path folder;
    std::string pairs;
    fs::path results;
    std::uint64_t n_seeds = 1, first_seed = 0;
    std::size_t every = 1, from = 0;
    std::string commit{};  // of the program, to be written
};

std::vector<Run> list_runs(const Arguments& arguments) {
    const std::vector<Pair> pairs = list_pairs(arguments.folder, arguments.pairs);
    std::vector<Run> runs;
    for (std::uint64_t seed = 0; seed < arguments.n_seeds; ++seed)
        for (std::size_t i = arguments.from; i < pairs.size(); i += arguments.every)
            runs.push_back({pairs[i], arguments.first_seed + seed});
    return runs;
}

int run(const Arguments& arguments) {
    const std::vector<Run> runs = list_runs(arguments);
    const std::set<Run> wanted(runs.begin(), runs.end());
    std::vector<Json> lines;
    std::set<Run> done;
    std::ifstream earlier(arguments.results);
    for (std::string text; std::getline(earlier, text);) {
        const Json line = Json::parse(text);
        const Run known{{line["source"], line["target"]}, line["seed"]};
        if (wanted.contains(known) && done.insert(known).second) lines.push_back(line);
    }
    std::mutex mutex;
    std::ofstream output(arguments.results, std::ios::app);
    std::size_t next = 0;
    const auto work = [&] {
        while (true) {
            Run todo;
            {
                const std::lock_guard lock(mutex);
                while (next < runs.size() && done.contains(runs[next])) ++next;
                if (next == runs.size()) return;
                todo = runs[next++];
            }
            Json line = measure(arguments.folder, todo);
            line["commit"] = arguments.commit;
            const std::lock_guard lock(mutex);
            output << line.dump() << std::endl;
            lines.push_back(line);
        }
    };
    std::thread second(work);
    work();
    second.join();
    print_summary(arguments.folder.string(), lines);
    return 0;
}

Arguments parsed(int argc, char** argv) {
    Arguments arguments{argv[1], argv[2], argv[3]};
    for (int i = 4; i + 1 < argc; i += 2) {
        const std::string name = argv[i];
        if (name == "--commit") {
            arguments.commit = argv[i + 1];
            continue;
        }
        const std::uint64_t value = std::stoull(argv[i + 1]);
        if (name == "--seeds")
            arguments.n_seeds = value;
        else if (name == "--first-seed")
            arguments.first_seed = value;
        else if (name == "--every")
            arguments.every = std::max<std::uint64_t>(value, 1);
        else if (name == "--from")
            arguments.from = value;
        else
            throw std::runtime_error("unknown option " + name);
    }
    return arguments;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 4 || argc % 2 != 0) {
        std::fputs(
            "usage: accuracy FOLDER ordered|unordered|PAIRS RESULTS.jsonl [--seeds N] [--first-seed N] "
            "[--every N] [--from N] [--commit NAME]\n",
            stderr);
        return 2;
    }
    try {
        return run(parsed(argc, argv));
    } catch (const std::exception& error) {
        std::fprintf(stderr, "error: %s\n", error.what());
        return 1;
    }
}
