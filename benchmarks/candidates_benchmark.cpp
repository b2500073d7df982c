// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Choosing between candidates: every finalist's true error and every cue, the chosen one against the best.
//
//     candidates FOLDER PAIRS RESULTS.jsonl [UP]
//
// FOLDER and PAIRS as for accuracy. One JSON line per pair goes to RESULTS; pairs that are there already are
// not run again. "finalists" have scores, cues and errors before the last refinement, best first; "refined"
// has what the program ends with: the map ("mean_error" of the pair is its error) and its runners-up. Errors
// are geodesic at every 8th point, times 100 / sqrt(target area). A pair above 6 is matched again with one
// landmark ("with_landmark"), and with UP, an axis (x, y or z) that is up in both meshes, with that alone
// ("with_up"). Two pairs run at a time, on one thread each. The last line on stdout: pairs, mean error of the
// chosen, of the best finalist, and how many are above 6.
#include "base/parallel.hpp"
#include "match/spectral/confidence.hpp"
#include "match/spectral/lift.hpp"
#include "match/spectral/prepared_shape.hpp"
#include "match/spectral/refined_score.hpp"
#include "match/spectral/rivals.hpp"
#include "match/spectral/round_trips.hpp"
#include "match/spectral/search.hpp"

#include <counterpart/geodesic/distances.hpp>
#include <counterpart/io/map_file.hpp>
#include <counterpart/io/mesh_file.hpp>
#include <counterpart/mesh/measure.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <map>
#include <memory>
#include <mutex>
#include <numeric>
#include <set>
#include <string>
#include <thread>

#include <nlohmann/json.hpp>

namespace counterpart::spectral_match {
namespace {

using Json = nlohmann::ordered_json;
using Pair = std::pair<std::string, std::string>;
namespace fs = std::filesystem;

// A mesh, prepared once, with its points of known meaning.
struct Known {
    TriangleMesh mesh;
    PreparedShape shape;
    VertexMap points;

    Known(const fs::path& folder, const std::string& name)
        : mesh(read_mesh(folder / (name + ".off")).mesh),
          shape(prepare(mesh, {})),
          points(read_vertex_map(folder / "corres" / (name + ".vts"), IndexBase::one)) {}

    Index matched_point(Index k) const { return shape.vertex_of_input(points[k]); }
    Index full_point(Index k) const {
        return shape.origin.matched_of_input[static_cast<std::size_t>(points[k])];
    }
};

constexpr Index step = 8;    // of the known points
constexpr double wrong = 6;  // mean errors above

struct MapErrors {
    std::vector<double> means;  // of each map
    Vector of_first;            // of the first map at each point
};

// Of several maps at once: distances from one point to all its images cost one search.
MapErrors errors_of(const Known& source, const Known& target, const std::vector<const PairedMaps*>& maps) {
    std::vector<PairedMaps> lifted;
    for (const PairedMaps* map : maps)
        lifted.push_back(lift(source.shape, target.shape, *map, SpectralTuning{}.refinement, {}));
    std::vector<std::pair<Index, Index>> ends;
    for (Index k = 0; k < source.points.source_size(); k += step)
        for (const PairedMaps& map : lifted)
            ends.emplace_back(target.points[k],
                              target.shape.origin.input_of_matched[static_cast<std::size_t>(
                                  map.b_from_a[static_cast<std::size_t>(source.full_point(k))])]);
    const Vector distances = pair_distances(DistanceGraph(target.mesh), ends, {.n_threads = 1}) * 100 /
                             std::sqrt(surface_area(target.mesh));
    const auto n = static_cast<Eigen::Index>(maps.size());
    MapErrors errors{{}, distances(Eigen::seq(0, Eigen::last, n))};
    for (Eigen::Index m = 0; m < n; ++m)
        errors.means.push_back(distances(Eigen::seq(m, Eigen::last, n)).mean());
    return errors;
}

// What confidence is made of, at every 4th of these points: the error, the round trip plus tear, and which
// finalists (from the second on) take it elsewhere.
Json evidence(const Known& source, const SampledPair& all, const std::vector<Candidate>& finalists,
              const Vector& errors) {
    const Vector doubts = round_trips_and_tears(all.a, all.b, finalists.front().on_vertices);
    const MapDistance distance(all);
    Json lines = Json::array();
    for (Eigen::Index i = 0; i < errors.size(); i += 4) {
        const Index v = source.matched_point(static_cast<Index>(i) * step);
        const auto s = static_cast<std::size_t>(all.a.cell_of_vertex[static_cast<std::size_t>(v)]);
        Json apart = Json::array();
        for (std::size_t c = 1; c < finalists.size(); ++c)
            apart.push_back(std::round(1000 * distance.on_b(finalists[c].maps.b_from_a[s],
                                                            finalists[0].maps.b_from_a[s])) /
                            1000);
        lines.push_back({std::round(100 * errors[i]) / 100, std::round(1e4 * doubts[v]) / 1e4, apart});
    }
    return lines;
}

// Of this thread: other programs on the machine do not count.
double processor_seconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct Matched {
    std::vector<Candidate> finalists, refined;
};

Matched match_with(const PreparedShape& a, const PreparedShape& b, const Priors& priors) {
    const SpectralTuning tuning;
    Stopwatch watch;
    Search found =
        search(a, b, priors, static_cast<std::size_t>(SpectralOptions{}.n_alternatives), tuning, {}, watch);
    Matched matched{found.finalists, std::move(found.finalists)};
    refine_rivals(matched.refined, found.all, found.rivals, found.refinement);
    return matched;
}

// What becomes of a map when a point of a wrong limb is given as a landmark: the one at the 95th percentile
// of the errors. (The very worst ones often lie in mouths and between legs.)
double error_with_landmark(const Known& source, const Known& target, const Vector& errors) {
    std::vector<Index> order(static_cast<std::size_t>(errors.size()));
    std::iota(order.begin(), order.end(), 0);
    const auto at = order.begin() + static_cast<std::ptrdiff_t>(0.95 * static_cast<double>(order.size()));
    std::nth_element(order.begin(), at, order.end(), [&](Index i, Index j) { return errors[i] < errors[j]; });
    const Index k = *at * step;
    const Priors priors = make_priors(source.shape, target.shape,
                                      VertexPairs{{source.matched_point(k), target.matched_point(k)}}, {});
    const Matched found = match_with(source.shape, target.shape, priors);
    return errors_of(source, target, {&found.refined.front().on_vertices}).means[0];
}

// What becomes of a map when a person says which way is up.
double error_with_up(const Known& source, const Known& target, const Eigen::Vector3d& up) {
    SpectralOptions options;
    options.up = up;
    const Priors priors = make_priors(source.shape, target.shape, options, SpectralTuning{}.priors);
    const Matched found = match_with(source.shape, target.shape, priors);
    return errors_of(source, target, {&found.refined.front().on_vertices}).means[0];
}

Json measure(const Pair& pair, const Known& source, const Known& target, const Eigen::Vector3d& up) {
    const PreparedShape &a = source.shape, &b = target.shape;
    const double start = processor_seconds();
    const auto [finalists, refined] = match_with(a, b, nothing_known);
    const double seconds = processor_seconds() - start;
    std::vector<const PairedMaps*> maps;
    for (const auto* list : {&refined, &finalists})
        for (const Candidate& candidate : *list) maps.push_back(&candidate.on_vertices);
    const MapErrors found = errors_of(source, target, maps);
    const double error = found.means[0];
    Json brief = Json::array(), full = Json::array();
    for (std::size_t i = 0; i < finalists.size(); ++i) {
        const auto& [scores, cues] = std::tie(finalists[i].scores, finalists[i].cues);
        brief.push_back({{"mean_error", found.means[refined.size() + i]},
                         {"total", scores.total},
                         {"curvature", scores.curvature},
                         {"orientation", scores.orientation},
                         {"drift", scores.drift},
                         {"rigidity", scores.rigidity},
                         {"orthogonality", scores.orthogonality},
                         {"relief", cues.relief},
                         {"residual", cues.residual},
                         {"wring", cues.wring}});
    }
    const SampledPair all(a, b, all_samples, 0);
    const RefinedScoreTuning tuning;
    for (std::size_t i = 0; i < refined.size(); ++i)
        full.push_back(
            {{"mean_error", found.means[i]},
             {"total", refined[i].scores.total},
             {"drift", refined[i].scores.drift},
             {"refined_score", refined[i].refined_score},
             {"relief", mean_relief(relief_correlations(a, b, refined[i].on_vertices))},
             {"normals", agreement_of_normals(a, b, refined[i].on_vertices, tuning.normal_radius)}});
    Json line{{"source", pair.first},
              {"target", pair.second},
              {"mean_error", error},
              {"seconds", seconds},
              {"finalists", brief},
              {"refined", full},
              {"vertices", evidence(source, all, refined, found.of_first)}};
    if (error > wrong) line["with_landmark"] = error_with_landmark(source, target, found.of_first);
    if (error > wrong && !up.isZero(0)) line["with_up"] = error_with_up(source, target, up);
    return line;
}

std::vector<Pair> list_pairs(const fs::path& file) {
    std::ifstream input(file);
    std::vector<Pair> pairs;
    for (std::string a, b; input >> a >> b;) pairs.emplace_back(a, b);
    return pairs;
}

Eigen::Vector3d axis(const std::string& name) {
    Eigen::Vector3d result = Eigen::Vector3d::Zero();
    const std::size_t i = std::string("xyz").find(name);
    if (name.size() == 1 && i < 3) result[static_cast<Eigen::Index>(i)] = 1;
    return result;
}

void run(const fs::path& folder, const fs::path& list, const fs::path& results, const Eigen::Vector3d& up) {
    std::vector<Json> lines;
    std::set<Pair> done;
    std::ifstream earlier(results);
    for (std::string text; std::getline(earlier, text);) {
        lines.push_back(Json::parse(text));
        done.emplace(lines.back()["source"].get<std::string>(), lines.back()["target"].get<std::string>());
    }
    std::vector<Pair> pairs = list_pairs(list);
    std::erase_if(pairs, [&](const Pair& pair) { return done.contains(pair); });
    std::map<std::string, std::unique_ptr<Known>> known;
    std::mutex mutex, output_mutex;
    const auto get = [&](const std::string& name) -> const Known& {
        const std::lock_guard lock(mutex);
        auto& entry = known[name];
        if (!entry) entry = std::make_unique<Known>(folder, name);
        return *entry;
    };
    std::ofstream output(results, std::ios::app);
    std::atomic<std::size_t> next = 0;
    const auto work = [&] {
        for (std::size_t i = next++; i < pairs.size(); i = next++) {
            Json line = counterpart::with_threads(
                1, [&] { return measure(pairs[i], get(pairs[i].first), get(pairs[i].second), up); });
            const std::lock_guard lock(output_mutex);
            output << line.dump() << std::endl;
            lines.push_back(std::move(line));
        }
    };
    std::thread second(work);
    work();
    second.join();
    double chosen = 0, best = 0;
    int n_wrong = 0;
    for (const Json& line : lines) {
        double least = 1e9;
        for (const Json& finalist : line["finalists"])
            least = std::min(least, finalist["mean_error"].get<double>());
        chosen += line["mean_error"].get<double>();
        best += least;
        if (line["mean_error"] > wrong) ++n_wrong;
    }
    const auto n = static_cast<double>(lines.size());
    std::printf(
        "{\"summary\":\"%s\",\"pairs\":%zu,\"mean_error\":%.3f,\"best_finalist\":%.3f,\"pairs_above_6\":%d}"
        "\n",
        folder.c_str(), lines.size(), chosen / n, best / n, n_wrong);
}

}  // namespace
}  // namespace counterpart::spectral_match

int main(int argc, char** argv) {
    if (argc < 4) {
        std::fputs("usage: candidates FOLDER PAIRS RESULTS.jsonl [UP]\n", stderr);
        return 2;
    }
    try {
        counterpart::spectral_match::run(argv[1], argv[2], argv[3],
                                         counterpart::spectral_match::axis(argc > 4 ? argv[4] : ""));
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "error: %s\n", error.what());
        return 1;
    }
}
