// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// What each stage of the spectral method is worth, and how much its constants matter:
//
//     ablation DATA [--every N] [--part I OF] [stages|terms|constants]
//
// DATA holds the folders faust_r, faust_a, tosca_r, scape_r, shrec19, smal_r and tosca_noniso_r, each with
// NAME.off, corres/NAME.vts (line k of any two names the same point, from 1) and, if not all pairs count,
// pairs.txt. Every Nth pair of the hard sets is matched (1 = all), fewer of the easy ones, by the method as
// it is, but that nothing ends early (all searches and rounds of refinement run in full), and by variants:
// with one stage switched off, with one term of a stage switched off, or with one constant halved or doubled.
// With --part only every OF-th of these pairs, from number I (from 0), so that several runs share the work. A
// variant shares the stages before the first one that it changes, and the refinement where it chooses the
// same map. One JSON line per pair and variant, then one per variant; errors are geodesic, times 100 /
// sqrt(target area); seconds are processor time of stages 2 to 5. One thread.
#include "base/parallel.hpp"
#include "match/spectral/candidates.hpp"
#include "match/spectral/final_choice.hpp"
#include "match/spectral/prepared_shape.hpp"
#include "match/spectral/rivals.hpp"
#include "match/spectral/selection.hpp"
#include "match/spectral/unlike_shapes.hpp"

#include <counterpart/geodesic/distances.hpp>
#include <counterpart/io/map_file.hpp>
#include <counterpart/io/mesh_file.hpp>
#include <counterpart/mesh/measure.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <functional>
#include <map>
#include <string>

#include <nlohmann/json.hpp>

namespace counterpart::spectral_match {
namespace {

using Json = nlohmann::ordered_json;
using Pair = std::pair<std::string, std::string>;
namespace fs = std::filesystem;

struct Variant {
    std::string name;
    int first_stage;  // that it changes: 2 candidates, 3 selection, 4 final choice, 5 refinement
    std::function<void(SpectralTuning&)> change;
};

const Variant reference{"as it is", 2, [](SpectralTuning&) {}};

// One stage off.
std::vector<Variant> stages() {
    using T = SpectralTuning;
    return {
        reference,
        {"no extremities", 2,
         [](T& t) { t.candidates.extremities.n_matchings = t.candidates.extremities.n_fine_matchings = 0; }},
        {"no extrinsic candidates", 2, [](T& t) { t.candidates.extrinsic.enabled = false; }},
        {"no sign flips", 2, [](T& t) { t.candidates.n_flip_rounds = 0; }},
        {"all as near isometries", 3, [](T& t) { t.selection.near_isometry_drift = 1e9; }},
        {"no final choice", 4, [](T& t) { t.final_choice.n_tried = 1; }},
        {"no rivals", 5, [](T& t) { t.rivals.n_refined = 1; }},
        {"no elastic fit", 5, [](T& t) { t.refinement.position_weight = t.refinement.normal_weight = 0; }},
        {"no rounds of refinement", 5, [](T& t) { t.refinement.n_rounds = 0; }}};
}

// One term of a stage off.
std::vector<Variant> terms() {
    using T = SpectralTuning;
    const auto in_selection = [](auto change) {
        return [change](T& t) {
            change(t.selection.score);
            change(t.selection.final_score);
        };
    };
    return {reference,
            {"candidates: no descriptors", 2,
             [](T& t) { t.candidates.wave_kernel_weight = t.candidates.curvature_weight = 0; }},
            {"candidates: no orthogonality", 2, [](T& t) { t.candidates.score.orthogonality = 0; }},
            {"selection: no curvature", 3, in_selection([](ScoreWeights& w) { w.curvature = 0; })},
            {"selection: no orientation", 3, in_selection([](ScoreWeights& w) { w.orientation = 0; })},
            {"selection: no rigidity", 3, in_selection([](ScoreWeights& w) { w.rigidity = 0; })},
            {"selection: no drift", 3, in_selection([](ScoreWeights& w) { w.drift = 0; })},
            {"selection: no mask", 3, [](T& t) { t.selection.final_masked = false; }},
            {"refinement: no mask", 5, [](T& t) { t.refinement.masked = false; }},
            {"refinement: no features", 5, [](T& t) { t.refinement.feature_weight = 0; }},
            {"refinement: no normals", 5, [](T& t) { t.refinement.normal_weight = 0; }}};
}

// A constant halved and doubled.
void add_constant(std::vector<Variant>& variants, const std::string& name, int first_stage,
                  const std::function<void(SpectralTuning&, double)>& scale) {
    for (const double factor : {0.5, 2.0})
        variants.push_back({name + (factor < 1 ? " / 2" : " x 2"), first_stage,
                            [=](SpectralTuning& tuning) { scale(tuning, factor); }});
}

std::vector<Variant> constants() {
    std::vector<Variant> all{reference};
    const auto add = [&](const std::string& name, int first_stage, auto member) {
        add_constant(all, name, first_stage, [member](SpectralTuning& tuning, double factor) {
            auto& value = member(tuning);
            value =
                static_cast<std::remove_reference_t<decltype(value)>>(static_cast<double>(value) * factor);
        });
    };
    using T = SpectralTuning;
    add(
        "candidates: samples", 2, [](T & t) -> auto& { return t.candidates.n_samples; });
    add(
        "candidates: matchings", 2, [](T & t) -> auto& { return t.candidates.extremities.n_matchings; });
    add(
        "candidates: skip cost", 2, [](T & t) -> auto& { return t.candidates.extremities.skip_cost; });
    add(
        "candidates: flipped", 2, [](T & t) -> auto& { return t.candidates.n_flipped; });
    add(
        "candidates: min difference", 2, [](T & t) -> auto& { return t.candidates.distinct.mean; });
    add(
        "candidates: kept", 2, [](T & t) -> auto& { return t.candidates.n_kept; });
    add(
        "candidates: w_c", 2, [](T & t) -> auto& { return t.candidates.score.orthogonality; });
    add(
        "selection: samples", 3, [](T & t) -> auto& { return t.selection.n_samples; });
    add(
        "selection: final w_o", 3, [](T & t) -> auto& { return t.selection.final_score.orientation; });
    add(
        "selection: final w_d", 3, [](T & t) -> auto& { return t.selection.final_score.drift; });
    add(
        "selection: final w_r", 3, [](T & t) -> auto& { return t.selection.final_score.rigidity; });
    add(
        "final choice: relief weight", 4, [](T & t) -> auto& { return t.final_choice.cues.relief_weight; });
    add(
        "final choice: residual weight", 4,
        [](T & t) -> auto& { return t.final_choice.cues.residual_weight; });
    add(
        "final choice: wring weight", 4, [](T & t) -> auto& { return t.final_choice.cues.wring_weight; });
    add(
        "final choice: tried", 4, [](T & t) -> auto& { return t.final_choice.n_tried; });
    add(
        "refinement: first match size", 5, [](T & t) -> auto& { return t.refinement.first_match_size; });
    add(
        "refinement: first size", 5, [](T & t) -> auto& { return t.refinement.first_size; });
    add(
        "refinement: feature weight", 5, [](T & t) -> auto& { return t.refinement.feature_weight; });
    add(
        "refinement: position weight", 5, [](T & t) -> auto& { return t.refinement.position_weight; });
    add(
        "refinement: normal weight", 5, [](T & t) -> auto& { return t.refinement.normal_weight; });
    add(
        "refinement: first length", 5, [](T & t) -> auto& { return t.refinement.first_length; });
    add(
        "refinement: last length", 5, [](T & t) -> auto& { return t.refinement.last_length; });
    add(
        "refinement: iterations", 5, [](T & t) -> auto& { return t.refinement.n_iterations; });
    add(
        "refinement: rounds", 5, [](T & t) -> auto& { return t.refinement.n_rounds; });
    return all;
}

// A folder, the pairs that count in it, and how much sparser than the hard sets it is sampled.
struct DataSet {
    std::string name, pairs;
    int sparser;
};
const std::vector<DataSet> sets{{"smal_r", "first 8", 1},    {"tosca_noniso_r", "file", 1},
                                {"scape_r", "file", 4},      {"faust_r", "unordered", 8},
                                {"faust_a", "unordered", 2}, {"tosca_r", "file", 4},
                                {"shrec19", "unordered", 5}};

std::vector<Pair> pairs_of(const fs::path& folder, const std::string& which) {
    std::vector<Pair> pairs;
    if (which == "file") {
        std::ifstream file(folder / "pairs.txt");
        for (std::string a, b; file >> a >> b;) pairs.emplace_back(a, b);
        return pairs;
    }
    std::vector<std::string> names;
    if (which == "first 8")
        names = {"00047093_ferrari", "Davis_cow_00000", "Hippo_for_Nat", "cougar",
                 "dog_alph",         "fox-05",          "lion3",         "muybridge_087_04"};
    else
        for (const auto& entry : fs::directory_iterator(folder))
            if (entry.path().extension() == ".off") names.push_back(entry.path().stem().string());
    std::sort(names.begin(), names.end());
    for (const std::string& a : names)
        for (const std::string& b : names)
            if (a < b || (a != b && which == "first 8")) pairs.emplace_back(a, b);
    return pairs;
}

// A mesh, prepared once, with its points of known meaning.
struct Known {
    TriangleMesh mesh;
    PreparedShape shape;
    VertexMap points;

    explicit Known(const fs::path& folder, const std::string& name)
        : mesh(read_mesh(folder / (name + ".off")).mesh),
          shape(prepare(mesh, {})),
          points(read_vertex_map(folder / "corres" / (name + ".vts"), IndexBase::one)) {}
};

double mean_error(const Known& source, const Known& target, const std::vector<Index>& matched) {
    const VertexMap map =
        between_inputs({matched, target.shape.mesh.n_vertices()}, source.shape.origin, target.shape.origin);
    std::vector<std::pair<Index, Index>> ends;
    for (Index k = 0; k < source.points.source_size(); ++k)
        ends.emplace_back(target.points[k], map[source.points[k]]);
    return pair_distances(DistanceGraph(target.mesh), ends, {.n_threads = 1}).mean() * 100 /
           std::sqrt(surface_area(target.mesh));
}

// What a stage gave with the method as it is, and the seconds up to there.
struct Stage {
    std::vector<Candidate> maps;
    bool is_unlike = false;
    double seconds = 0;
};
struct Shared {
    Stage candidates, selection, final_choice;
};

// Of this process, on its one thread: other programs on the machine do not count.
double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

// The error and the seconds of one variant. The first one of a pair fills `shared`.
std::pair<double, double> run(const Known& source, const Known& target, const Variant& variant,
                              Shared& shared) {
    SpectralTuning tuning;
    variant.change(tuning);
    tuning.refinement.goes_on = false;  // all rounds
    const PreparedShape &a = source.shape, &b = target.shape;
    const bool is_reference = shared.final_choice.maps.empty();
    Stage now;
    const auto take = [&](int number, Stage& known, const auto& stage) {
        if (variant.first_stage > number) {
            now = known;
            return;
        }
        const double start = processor_seconds();
        stage();
        now.seconds += processor_seconds() - start;
        if (is_reference) known = now;
    };
    const SampledPair coarse(a, b, tuning.candidates.n_samples, tuning.candidates.rigidity_radius);
    take(2, shared.candidates, [&] {
        now.maps = vary_candidates(coarse, start_candidates(coarse, tuning.candidates), tuning.candidates);
    });
    take(3, shared.selection, [&] {
        std::vector<Candidate> selected =
            select(coarse, now.maps, tuning.selection.n_finalists, tuning.selection);
        now.is_unlike = selected.empty();
        if (!now.is_unlike) now.maps = std::move(selected);
    });
    const SampledPair all(a, b, all_samples, tuning.final_choice.cues.radius);
    take(4, shared.final_choice, [&] {
        if (now.is_unlike)  // one way only
            now.maps = search_unlike(std::move(now.maps), {}, all, 1, tuning);
        else
            choose_best(now.maps, all, tuning.final_choice);
    });
    if (now.is_unlike) {
        tuning.rivals.n_refined = 1;
        tuning.rivals.n_pull_rounds = tuning.unlike.rivals.n_pull_rounds;
    }
    const double start = processor_seconds();
    refine_rivals(now.maps, all, tuning.rivals, tuning.refinement);
    const double seconds = processor_seconds() - start;
    return {mean_error(source, target, now.maps.front().on_vertices.b_from_a), now.seconds + seconds};
}

void print_summary(const std::string& name, std::vector<double> errors, double seconds) {
    double sum = 0;
    for (const double e : errors) sum += e;
    std::sort(errors.begin(), errors.end());
    const auto n = static_cast<double>(errors.size());
    const Json line = {
        {"variant", name},
        {"pairs", errors.size()},
        {"mean_error", sum / n},
        {"median_error", errors[errors.size() / 2]},
        {"pairs_above_6", std::count_if(errors.begin(), errors.end(), [](double e) { return e > 6; })},
        {"mean_seconds", seconds / n}};
    std::printf("%s\n", line.dump().c_str());
}

struct ChosenPair {
    double place;  // in its set, in [0, 1): pairs are run in this order, so that sets take turns
    std::string set;
    Pair pair;
};

std::vector<ChosenPair> choose_pairs(const fs::path& data, int every) {
    std::vector<ChosenPair> chosen;
    for (const DataSet& set : sets) {
        const std::vector<Pair> pairs = pairs_of(data / set.name, set.pairs);
        const auto step = static_cast<std::size_t>(every * set.sparser);
        for (std::size_t i = step / 2; i < pairs.size(); i += step)
            chosen.push_back(
                {static_cast<double>(i) / static_cast<double>(pairs.size()), set.name, pairs[i]});
    }
    std::stable_sort(chosen.begin(), chosen.end(),
                     [](const ChosenPair& x, const ChosenPair& y) { return x.place < y.place; });
    return chosen;
}

struct Part {
    std::size_t number = 0, count = 1;
};

void measure(const fs::path& data, int every, Part part, const std::vector<Variant>& variants) {
    std::map<std::string, std::pair<std::vector<double>, double>> results;
    std::map<fs::path, Known> known;
    const auto get = [&](const std::string& set, const std::string& name) -> const Known& {
        return known.try_emplace(data / set / name, data / set, name).first->second;
    };
    const std::vector<ChosenPair> chosen = choose_pairs(data, every);
    for (std::size_t i = part.number; i < chosen.size(); i += part.count) {
        const auto& [place, set, pair] = chosen[i];
        const Known &source = get(set, pair.first), &target = get(set, pair.second);
        Shared shared;
        for (const Variant& variant : variants) {
            const auto [error, seconds] = run(source, target, variant, shared);
            results[variant.name].first.push_back(error);
            results[variant.name].second += seconds;
            const Json line = {{"set", set},
                               {"source", pair.first},
                               {"target", pair.second},
                               {"variant", variant.name},
                               {"mean_error", error},
                               {"seconds", seconds}};
            std::printf("%s\n", line.dump().c_str());
            std::fflush(stdout);
        }
    }
    for (const Variant& variant : variants)
        if (const auto& [errors, seconds] = results[variant.name]; !errors.empty())
            print_summary(variant.name, errors, seconds);
}

}  // namespace
}  // namespace counterpart::spectral_match

int main(int argc, char** argv) {
    using namespace counterpart::spectral_match;
    int every = 1;
    Part part;
    std::vector<Variant> variants = stages();
    for (int i = 2; i < argc; ++i) {
        const std::string word = argv[i];
        if (word == "--every" && i + 1 < argc) every = std::max(1, std::atoi(argv[++i]));
        if (word == "--part" && i + 2 < argc) {
            part.number = static_cast<std::size_t>(std::max(0, std::atoi(argv[++i])));
            part.count = static_cast<std::size_t>(std::max(1, std::atoi(argv[++i])));
        }
        if (word == "terms") variants = terms();
        if (word == "constants") variants = constants();
    }
    if (argc < 2) {
        std::fputs("usage: ablation DATA [--every N] [--part I OF] [stages|terms|constants]\n", stderr);
        return 2;
    }
    try {
        counterpart::with_threads(1, [&] { measure(argv[1], every, part, variants); });
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "error: %s\n", error.what());
        return 1;
    }
}
