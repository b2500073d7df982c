// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Accuracy of the spectral method on a folder of meshes with ground truth:
//
//     accuracy FOLDER PAIRS RESULTS.jsonl [reuse]
//
// FOLDER holds NAME.off and corres/NAME.vts (line k of any two name the same point, from 1). PAIRS is
// "ordered" (all ordered pairs), "unordered" (all i < j) or a file of two names a line. One JSON line per
// pair goes to RESULTS; pairs that are there already are not run again. With "reuse" each shape is prepared
// once and kept. Two pairs run at a time, on one thread each. Errors are geodesic, times 100 / sqrt(target
// area); the last line on stdout is the summary.
#include <counterpart/base/progress.hpp>
#include <counterpart/geodesic/distances.hpp>
#include <counterpart/io/map_file.hpp>
#include <counterpart/io/mesh_file.hpp>
#include <counterpart/match/spectral.hpp>
#include <counterpart/mesh/measure.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <mutex>
#include <optional>
#include <set>
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

// Shapes prepared once, each by the first thread that asks.
class Shapes {
  public:
    SpectralShape get(const std::string& name, const TriangleMesh& mesh) {
        Entry* entry = nullptr;
        {
            const std::lock_guard lock(mutex_);
            entry = &entries_[name];
        }
        const std::lock_guard lock(entry->mutex);
        if (!entry->shape) entry->shape.emplace(mesh, SpectralShapeOptions{.n_threads = 1});
        return *entry->shape;
    }

  private:
    struct Entry {
        std::mutex mutex;
        std::optional<SpectralShape> shape;
    };
    std::mutex mutex_;
    std::map<std::string, Entry> entries_;
};

Json measure(const fs::path& folder, const Pair& pair, Shapes* shapes) {
    Stopwatch watch;
    const TriangleMesh source = read_mesh(folder / (pair.first + ".off")).mesh;
    const TriangleMesh target = read_mesh(folder / (pair.second + ".off")).mesh;
    watch.lap("read");
    const SpectralOptions options{.n_threads = 1};
    const SpectralResult result =
        shapes != nullptr
            ? match_spectral(shapes->get(pair.first, source), shapes->get(pair.second, target), options)
            : match_spectral(source, target, options, {.n_threads = 1});
    watch.lap("match");

    const auto truth = [&](const std::string& name) {
        return read_vertex_map(folder / "corres" / (name + ".vts"), IndexBase::one);
    };
    const VertexMap on_source = truth(pair.first), on_target = truth(pair.second);
    std::vector<std::pair<Index, Index>> ends;
    for (Index k = 0; k < on_source.source_size(); ++k)
        ends.emplace_back(on_target[k], result.target_from_source[on_source[k]]);
    const Vector errors =
        pair_distances(DistanceGraph(target), ends, {.n_threads = 1}) * 100 / std::sqrt(surface_area(target));
    double sure = 0, unsure = 0;
    int n_sure = 0, n_unsure = 0;
    for (Index k = 0; k < errors.size(); ++k) {
        const double confidence = result.confidence[on_source[k]];
        if (confidence > 0.8) sure += errors[k], ++n_sure;
        if (confidence < 0.2) unsure += errors[k], ++n_unsure;
    }
    Json line = {
        {"source", pair.first},         {"target", pair.second},
        {"mean_error", errors.mean()},  {"seconds", watch.stages()[0].seconds + watch.stages()[1].seconds},
        {"score", result.score},        {"margin", std::min(result.margin, 9.0)},
        {"error_sum_confident", sure},  {"n_confident", n_sure},
        {"error_sum_doubtful", unsure}, {"n_doubtful", n_unsure}};
    for (const StageTime& stage : result.stages) line["stages"][stage.stage] = stage.seconds;
    return line;
}

void print_summary(const std::string& folder, const std::vector<Json>& lines) {
    std::vector<double> errors, seconds;
    double sure = 0, unsure = 0, n_sure = 0, n_unsure = 0;
    for (const Json& line : lines) {
        errors.push_back(line["mean_error"]);
        seconds.push_back(line["seconds"]);
        sure += line["error_sum_confident"].get<double>();
        unsure += line["error_sum_doubtful"].get<double>();
        n_sure += line["n_confident"].get<double>();
        n_unsure += line["n_doubtful"].get<double>();
    }
    if (errors.empty()) return;
    double sum = 0;
    for (const double e : errors) sum += e;
    std::sort(errors.begin(), errors.end());
    std::sort(seconds.begin(), seconds.end());
    const auto wrong = std::count_if(errors.begin(), errors.end(), [](double e) { return e > 6; });
    const Json summary = {{"summary", folder},
                          {"pairs", errors.size()},
                          {"mean_error", sum / static_cast<double>(errors.size())},
                          {"median_error", errors[errors.size() / 2]},
                          {"pairs_above_6", wrong},
                          {"median_seconds", seconds[seconds.size() / 2]},
                          {"mean_error_confident", n_sure > 0 ? sure / n_sure : 0},
                          {"mean_error_doubtful", n_unsure > 0 ? unsure / n_unsure : 0},
                          {"n_confident", n_sure},
                          {"n_doubtful", n_unsure}};
    std::printf("%s\n", summary.dump().c_str());
}

int run(const fs::path& folder, const std::string& which, const fs::path& results, bool reuse) {
    const std::vector<Pair> pairs = list_pairs(folder, which);
    const std::set<Pair> wanted(pairs.begin(), pairs.end());
    std::vector<Json> lines;
    std::set<Pair> done;
    std::ifstream earlier(results);
    for (std::string text; std::getline(earlier, text);) {
        const Json line = Json::parse(text);
        const Pair pair{line["source"], line["target"]};
        if (wanted.contains(pair) && done.insert(pair).second) lines.push_back(line);
    }
    Shapes shapes;
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
            const Json line = measure(folder, pair, reuse ? &shapes : nullptr);
            const std::lock_guard lock(mutex);
            output << line.dump() << std::endl;
            lines.push_back(line);
        }
    };
    std::thread second(work);
    work();
    second.join();
    print_summary(folder.string(), lines);
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 4) {
        std::fputs("usage: accuracy FOLDER ordered|unordered|PAIRS RESULTS.jsonl [reuse]\n", stderr);
        return 2;
    }
    try {
        return run(argv[1], argv[2], argv[3], argc > 4 && std::string(argv[4]) == "reuse");
    } catch (const std::exception& error) {
        std::fprintf(stderr, "error: %s\n", error.what());
        return 1;
    }
}
