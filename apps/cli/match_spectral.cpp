// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match_methods.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/io/map_file.hpp>
#include <counterpart/io/npy.hpp>
#include <counterpart/match/spectral.hpp>

#include <cmath>
#include <fstream>
#include <limits>
#include <memory>
#include <sstream>

#include <fmt/format.h>

namespace counterpart::cli {
namespace {

struct SpectralCommand {
    SpectralOptions options;
    SpectralShapeOptions shape;
    std::filesystem::path landmarks, inverse, confidence, alternatives;
};

Index nearest_vertex(const TriangleMesh& mesh, const Eigen::RowVector3d& point) {
    Eigen::Index nearest = 0;
    (mesh.vertices.rowwise() - point).rowwise().squaredNorm().minCoeff(&nearest);
    return static_cast<Index>(nearest);
}

// Two columns: vertex numbers from 0; six: a point near the source, a point near the target.
std::vector<std::pair<Index, Index>> read_landmarks(const std::filesystem::path& file,
                                                    const MatchInput& input) {
    std::ifstream stream(file);
    if (!stream) throw IoError(fmt::format("{}: cannot be read", file.string()));
    std::vector<std::pair<Index, Index>> landmarks;
    std::string line;
    for (int number = 1; std::getline(stream, line); ++number) {
        std::istringstream words(line.substr(0, line.find('#')));
        std::vector<double> values;
        for (double value = 0; words >> value;) values.push_back(value);
        if (values.empty() && words.eof()) continue;
        if (!words.eof() || (values.size() != 2 && values.size() != 6))
            throw IoError(
                fmt::format("{}, line {}: a landmark is two vertex numbers or two points (6 numbers)",
                            file.string(), number));
        if (values.size() == 2) {
            for (const double value : values)
                if (value != std::floor(value) || std::abs(value) > std::numeric_limits<Index>::max())
                    throw IoError(
                        fmt::format("{}, line {}: {} is not a vertex number", file.string(), number, value));
            landmarks.emplace_back(static_cast<Index>(values[0]), static_cast<Index>(values[1]));
        } else {
            landmarks.emplace_back(nearest_vertex(input.source, {values[0], values[1], values[2]}),
                                   nearest_vertex(input.target, {values[3], values[4], values[5]}));
        }
    }
    if (landmarks.empty()) throw IoError(fmt::format("{}: no landmarks in the file", file.string()));
    return landmarks;
}

std::filesystem::path numbered(const std::filesystem::path& file, std::size_t number) {
    return file.parent_path() /
           fmt::format("{}_{}{}", file.stem().string(), number, file.extension().string());
}

Json report_of(const SpectralResult& result) {
    Json alternatives = Json::array();
    for (const SpectralAlternative& other : result.alternatives)
        alternatives.push_back({{"score", other.score}, {"description", other.description}});
    return {{"score", result.score},
            {"margin", result.margin},
            {"mean_confidence", result.confidence.mean()},
            {"alternatives", alternatives},
            {"warnings", result.warnings}};
}

MatchOutcome run(const SpectralCommand& command, const MatchInput& input) {
    SpectralOptions options = command.options;
    options.n_threads = input.common.threads;
    options.progress = input.progress;
    if (!command.landmarks.empty()) options.landmarks = read_landmarks(command.landmarks, input);
    const SpectralResult result = match_spectral(input.source, input.target, options, command.shape);
    for (const std::string& sentence : result.warnings) warn(sentence);
    if (!command.inverse.empty()) write_vertex_map(result.source_from_target, command.inverse);
    if (!command.confidence.empty()) write_npy(result.confidence, command.confidence);
    if (!command.alternatives.empty()) {
        for (std::size_t i = 0; i < result.alternatives.size(); ++i)
            write_vertex_map(result.alternatives[i].target_from_source,
                             numbered(command.alternatives, i + 1));
    }
    MatchOutcome outcome;
    outcome.messages.push_back(
        fmt::format("score {:.3f}, mean confidence {:.2f}", result.score, result.confidence.mean()));
    for (const SpectralAlternative& other : result.alternatives)
        outcome.messages.push_back(fmt::format("  runner-up {:.3f}: {}", other.score, other.description));
    outcome.details = report_of(result);
    outcome.stages = result.stages;
    outcome.target_from_source = result.target_from_source;
    return outcome;
}

}  // namespace

MatchMethod add_spectral_method(CLI::App& match) {
    auto command = std::make_shared<SpectralCommand>();
    const std::string group = "Options of --method spectral";
    match
        .add_option(
            "--landmarks", command->landmarks,
            "Known pairs, one a line: two vertex numbers from 0, or two points (6 numbers); at least 3")
        ->type_name("FILE")
        ->group(group);
    match.add_flag("--symmetric", command->options.symmetric, "Return the mirrored map: left to right")
        ->group(group);
    match.add_option("--basis-size", command->shape.basis_size, "Laplace eigenfunctions")
        ->check(CLI::Range(30, 500))
        ->capture_default_str()
        ->group(group);
    match.add_option("--samples", command->shape.n_samples, "Points that maps are searched on")
        ->check(CLI::Range(200, 5000))
        ->capture_default_str()
        ->group(group);
    match
        .add_option("--seed", command->shape.seed,
                    "0: samples begin at the vertex farthest from the centre; else at a random one")
        ->capture_default_str()
        ->group(group);
    match.add_option("--alternatives", command->options.n_alternatives, "Runners-up to report, with scores")
        ->check(CLI::Range(0, 10))
        ->capture_default_str()
        ->group(group);
    match
        .add_option("--alternatives-output", command->alternatives,
                    "Write the runners-up as FILE_1, FILE_2, ... before the extension")
        ->type_name("FILE")
        ->group(group);
    match.add_option("--inverse", command->inverse, "Write the map from TARGET to SOURCE too")
        ->type_name("FILE")
        ->group(group);
    match
        .add_option("--confidence", command->confidence, "Write the confidence of each source vertex (.npy)")
        ->type_name("FILE")
        ->group(group);
    return {"spectral", "eigenfunctions; any two triangulations of alike shapes, fully automatic",
            [command](const MatchInput& input) { return run(*command, input); }};
}

}  // namespace counterpart::cli
