// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Accuracy of match_partial on a folder of meshes with ground truth:
//
//     partial FOLDER RESULTS.jsonl [dev|test|all] [THREADS] [key=value ...]
//
// FOLDER holds pairs.txt (two names a line), NAME.off and truth/SOURCE__TARGET.txt (line i = target vertex of
// source vertex i, -1 = none). "dev" is every pair with an even line number from 0, "test" the others. Each
// source is turned at random. Keys: part=source|target|both|unknown, scale=same|unknown, unpaired=unknown (-1
// in the truth says nothing), none (it says that there is no partner), or inner (so where all neighbors have
// none either: where the whole's vertices outnumber the part's, several share one), only=SUBSTRING of the
// pair, swap=1 (match target to source), kept=SHARE (the source's triangles are made anew, with this share of
// its vertices), by=connectivity (find_differences in place of match_partial) or automatic (match),
// fill=EDGES (see CompleteOptions), crossed=1 (two parts of one whole: a line's source to that of the next
// line with the same target), known=N (landmarks: N pairs of the truth, spread out), seed=N (which way
// sources are turned). One JSON line per pair goes to RESULTS. Errors are geodesic, times 100 / sqrt(target
// area); the last line on stdout is the summary.
#include "base/random.hpp"

#include <counterpart/geodesic/distances.hpp>
#include <counterpart/geodesic/farthest_points.hpp>
#include <counterpart/io/map_file.hpp>
#include <counterpart/io/mesh_file.hpp>
#include <counterpart/map/complete.hpp>
#include <counterpart/match/differences.hpp>
#include <counterpart/match/match.hpp>
#include <counterpart/match/partial.hpp>
#include <counterpart/mesh/adjacency.hpp>
#include <counterpart/mesh/measure.hpp>
#include <counterpart/mesh/variants.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

namespace {

using namespace counterpart;
using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;
using Settings = std::map<std::string, std::string>;

TriangleMesh turned(TriangleMesh mesh, std::uint64_t seed) {
    Random random(seed);
    const auto normal = [&] {
        return std::sqrt(-2 * std::log(1 - random.uniform())) *
               std::cos(6.283185307179586 * random.uniform());
    };
    const Eigen::Quaterniond rotation =
        Eigen::Quaterniond(normal(), normal(), normal(), normal()).normalized();
    mesh.vertices = mesh.vertices * rotation.toRotationMatrix().transpose();
    return mesh;
}

Part part_named(const std::string& name) {
    for (const Part part : {Part::source, Part::target, Part::both, Part::neither})
        if (to_string(part) == name) return part;
    return Part::unknown;
}

// Mean over at most 1000 vertices with a known partner.
double mean_error(const VertexMap& map, const VertexMap& truth, const TriangleMesh& target,
                  std::vector<double>* all) {
    std::vector<std::pair<Index, Index>> ends;
    for (Index v = 0; v < map.source_size(); ++v)
        if (truth[v] >= 0 && map[v] >= 0) ends.emplace_back(truth[v], map[v]);
    std::vector<std::pair<Index, Index>> some;
    const std::size_t n = std::min<std::size_t>(ends.size(), 1000);
    for (std::size_t i = 0; i < n; ++i) some.push_back(ends[i * ends.size() / n]);
    const Vector errors = pair_distances(DistanceGraph(target), some) * 100 / std::sqrt(surface_area(target));
    double sum = 0;
    for (const double e : errors) {
        sum += std::min(e, 500.0);
        if (all != nullptr) all->push_back(e);
    }
    return n > 0 ? sum / static_cast<double>(n) : std::nan("");
}

// Vertices next to one that has a partner; none unless asked for.
std::vector<char> beside_partners(const TriangleMesh& mesh, const VertexMap& truth, bool asked) {
    std::vector<char> found(static_cast<std::size_t>(mesh.n_vertices()), 0);
    if (!asked) return found;
    const Adjacency adjacency(mesh);
    for (Index v = 0; v < mesh.n_vertices(); ++v)
        if (truth[v] >= 0)
            for (const Index w : adjacency.neighbors(v)) found[static_cast<std::size_t>(w)] = 1;
    return found;
}

PartialResult by_connectivity(const TriangleMesh& source, const TriangleMesh& target, int n_threads) {
    PartialResult result;
    result.target_from_source = find_differences(source, target, {.n_threads = n_threads}).target_from_source;
    result.confidence = Vector::Ones(source.n_vertices());
    return result;
}

PartialResult by_automatic(const TriangleMesh& source, const TriangleMesh& target,
                           const PartialOptions& options) {
    const MatchResult found = match(source, target, {.partial = options, .n_threads = options.n_threads});
    PartialResult result = found.partial.value_or(PartialResult{});
    result.target_from_source = found.target_from_source;
    result.confidence = found.confidence;
    return result;
}

VertexMap filled(const VertexMap& map, const TriangleMesh& source, const TriangleMesh& target,
                 int max_edges) {
    if (max_edges == 0 || count_matched(map) == 0) return map;
    return complete_map(map, source, target, {.max_edges = max_edges});
}

// The true map to `b`: given, or that of both to the whole of which they are parts.
VertexMap true_map(const fs::path& folder, const std::string& a, const std::string& b,
                   const std::string& whole) {
    const auto given = [&](const std::string& from, const std::string& to) {
        return read_vertex_map(folder / "truth" / (from + "__" + to + ".txt"));
    };
    if (whole.empty()) return given(a, b);
    const Index n = read_mesh(folder / (whole + ".off")).mesh.n_vertices();
    const auto to_whole = [&](const std::string& part) { return VertexMap(given(part, whole).image(), n); };
    return compose_maps(to_whole(a), invert(to_whole(b)));
}

// Pairs of the truth, far from each other.
std::vector<std::pair<Index, Index>> known_pairs(const TriangleMesh& source, const VertexMap& truth, int n) {
    std::vector<std::pair<Index, Index>> pairs;
    if (n == 0) return pairs;
    for (const Index v : farthest_point_samples(source, DistanceGraph(source), {.count = 20 * n}).vertices)
        if (truth[v] >= 0 && static_cast<int>(pairs.size()) < n) pairs.emplace_back(v, truth[v]);
    return pairs;
}

struct NamedPair {
    std::string source, target, whole;  // `whole`: of which both are parts; empty: the truth is given
    std::uint64_t number = 0;
};

std::vector<NamedPair> named_pairs(const fs::path& folder, bool crossed) {
    std::ifstream lines(folder / "pairs.txt");
    std::vector<NamedPair> given, found;
    for (std::string a, b; lines >> a >> b;) given.push_back({a, b, "", given.size()});
    if (!crossed) return given;
    for (std::size_t i = 1; i < given.size(); ++i)
        if (given[i - 1].target == given[i].target)
            found.push_back({given[i - 1].source, given[i].source, given[i].target, found.size()});
    return found;
}

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

Json measure(const fs::path& folder, const NamedPair& names, const Settings& settings, int n_threads) {
    const auto& [a, b, whole, number] = names;
    const auto setting = [&](const std::string& key, const std::string& otherwise) {
        const auto found = settings.find(key);
        return found == settings.end() ? otherwise : found->second;
    };
    const std::uint64_t seed = number + 1 + 1000 * std::stoull(setting("seed", "0"));
    TriangleMesh source = turned(read_mesh(folder / (a + ".off")).mesh, seed);
    TriangleMesh target = read_mesh(folder / (b + ".off")).mesh;
    source.vertices *= std::stod(setting("times", "1"));
    VertexMap truth = true_map(folder, a, b, whole);
    if (const double kept = std::stod(setting("kept", "0")); kept > 0) {
        RetriangulateResult other = retriangulate(source, {.kept_share = kept, .seed = seed});
        source = std::move(other.mesh);
        truth = compose_maps(VertexMap(std::move(other.original_from_mesh), truth.source_size()), truth);
    }
    const bool swap = setting("swap", "0") == "1";
    if (swap) {
        std::swap(source, target);
        truth = invert(VertexMap(truth.image(), source.n_vertices()));
    }
    const std::vector<char> says_nothing =
        beside_partners(source, truth, setting("unpaired", "none") == "inner");
    PartialOptions options{.part = part_named(setting("part", "unknown")), .n_threads = n_threads};
    options.same_scale = setting("scale", "same") == "same";
    options.landmarks = known_pairs(source, truth, std::stoi(setting("known", "0")));
    Stopwatch watch;
    const double cpu_before = cpu_seconds();
    const std::string by = setting("by", "geometry");
    PartialResult result = by == "connectivity" ? by_connectivity(source, target, n_threads)
                           : by == "automatic"  ? by_automatic(source, target, options)
                                                : match_partial(source, target, options);
    watch.lap("match");
    const double cpu = cpu_seconds() - cpu_before;
    result.target_from_source =
        filled(result.target_from_source, source, target, std::stoi(setting("fill", "0")));

    const bool none_is_known = setting("unpaired", "none") != "unknown";
    std::vector<double> errors;
    const double mean = mean_error(result.target_from_source, truth, target, &errors);
    std::sort(errors.begin(), errors.end());
    Index paired = 0, missed = 0, unpaired = 0, invented = 0, common = 0;
    double doubt_sum = 0, sure_sum = 0;
    for (Index v = 0; v < source.n_vertices(); ++v) {
        const bool matched = result.target_from_source[v] >= 0;
        if (v < truth.source_size() && truth[v] >= 0) {
            ++paired, missed += matched ? 0 : 1, common += matched ? 1 : 0;
            sure_sum += matched ? result.confidence[v] : 0;
        } else if (none_is_known && says_nothing[static_cast<std::size_t>(v)] == 0) {
            ++unpaired, invented += matched ? 1 : 0;
            doubt_sum += matched ? result.confidence[v] : 0;
        }
    }
    Json line = {{"source", a},
                 {"target", b},
                 {"mean_error", mean},
                 {"median_error", errors.empty() ? std::nan("") : errors[errors.size() / 2]},
                 {"missed", static_cast<double>(missed) / std::max(paired, 1)},
                 {"invented", static_cast<double>(invented) / std::max(unpaired, 1)},
                 {"iou", static_cast<double>(common) / std::max(paired + invented, 1)},
                 {"overlap", static_cast<double>(paired) / std::max(source.n_vertices(), 1)},
                 {"confidence", common > 0 ? sure_sum / common : 0},
                 {"invented_confidence", invented > 0 ? doubt_sum / invented : 0},
                 {"score", result.score},
                 {"margin", std::min(result.margin, 9.0)},
                 {"part", to_string(result.part)},
                 {"scale", result.scale},
                 {"severity", to_string(gravest(result.messages))},
                 {"seconds", watch.stages()[0].seconds},
                 {"cpu_seconds", cpu}};
    for (const PartialAlternative& other : result.alternatives)
        line["alternatives"].push_back(
            {other.score, mean_error(other.target_from_source, truth, target, nullptr)});
    for (const StageTime& stage : result.stages)
        line["stages"][stage.stage] = std::round(stage.seconds * 1000) / 1000;
    return line;
}

double middle(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values.empty() ? std::nan("") : values[values.size() / 2];
}

void print_summary(const std::string& name, const std::vector<Json>& lines) {
    std::map<std::string, std::vector<double>> columns;
    for (const Json& line : lines)
        for (const char* key :
             {"mean_error", "missed", "invented", "iou", "seconds", "cpu_seconds", "confidence", "score"})
            if (line[key].is_number()) columns[key].push_back(line[key]);
    const auto mean = [&](const char* key) {
        double sum = 0;
        for (const double x : columns[key]) sum += x;
        return columns[key].empty() ? 0 : sum / static_cast<double>(columns[key].size());
    };
    const auto above = [&](double e) {
        return std::count_if(columns["mean_error"].begin(), columns["mean_error"].end(),
                             [&](double x) { return x > e; });
    };
    const Json summary = {{"summary", name},
                          {"pairs", lines.size()},
                          {"mean_error", mean("mean_error")},
                          {"median_error", middle(columns["mean_error"])},
                          {"pairs_above_10", above(10)},
                          {"pairs_above_15", above(15)},
                          {"missed", mean("missed")},
                          {"invented", mean("invented")},
                          {"iou", mean("iou")},
                          {"confidence", mean("confidence")},
                          {"median_seconds", middle(columns["seconds"])},
                          {"median_cpu_seconds", middle(columns["cpu_seconds"])}};
    std::printf("%s\n", summary.dump().c_str());
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 3) {
        std::fprintf(stderr,
                     "usage: partial FOLDER RESULTS.jsonl [dev|test|all] [THREADS] [key=value ...]\n");
        return 2;
    }
    const fs::path folder = argv[1];
    const std::string half = argc > 3 ? argv[3] : "all";
    const int n_threads = argc > 4 ? std::atoi(argv[4]) : 0;
    Settings settings;
    for (int i = 5; i < argc; ++i) {
        const std::string text = argv[i];
        const auto equals = text.find('=');
        if (equals != std::string::npos) settings[text.substr(0, equals)] = text.substr(equals + 1);
    }
    std::ofstream out(argv[2]);
    std::vector<Json> lines;
    for (const NamedPair& pair : named_pairs(folder, settings["crossed"] == "1")) {
        if ((half == "dev" && pair.number % 2 == 1) || (half == "test" && pair.number % 2 == 0)) continue;
        if ((pair.source + " " + pair.target).find(settings["only"]) == std::string::npos) continue;
        lines.push_back(measure(folder, pair, settings, n_threads));
        out << lines.back().dump() << std::endl;
    }
    print_summary(folder.filename().string() + " " + half, lines);
}
