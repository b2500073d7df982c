// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match_spectral.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/io/map_file.hpp>
#include <counterpart/io/shape_file.hpp>

#include <charconv>
#include <locale>
#include <map>
#include <memory>
#include <sstream>

#include <fmt/format.h>

namespace counterpart::cli {
namespace {

Json report_of(const SpectralResult& result) {
    Json alternatives = Json::array();
    for (const SpectralAlternative& other : result.alternatives)
        alternatives.push_back({{"score", other.score}, {"description", other.description}});
    return {{"score", result.score},
            {"margin", result.margin},
            {"mean_confidence", result.confidence.mean()},
            {"alternatives", alternatives}};
}

Index vertex_number(const std::string& text, const std::string& whole) {
    Index number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (text.empty() || error != std::errc() || end != text.data() + text.size())
        throw InvalidInput(fmt::format("--not takes two 0-based vertices, SOURCE:TARGET, not '{}'", whole));
    return number;
}

std::pair<Index, Index> excluded_pair(const std::string& text) {
    const std::size_t colon = std::min(text.find(':'), text.size());
    const std::string rest = colon < text.size() ? text.substr(colon + 1) : "";
    return {vertex_number(text.substr(0, colon), text), vertex_number(rest, text)};
}

// "y", "+y", "-y" or three numbers with commas.
Eigen::Vector3d direction(const std::string& text, const std::string& option) {
    Eigen::Vector3d result = Eigen::Vector3d::Zero();
    if (text.empty()) return result;
    const bool has_sign = text[0] == '-' || text[0] == '+';
    const std::string axis = text.substr(has_sign ? 1 : 0);
    if (axis == "x" || axis == "y" || axis == "z") {
        result[axis[0] - 'x'] = text[0] == '-' ? -1 : 1;
        return result;
    }
    std::istringstream numbers(text);
    numbers.imbue(std::locale::classic());
    char first = 0, second = 0;
    numbers >> result[0] >> first >> result[1] >> second >> result[2];
    if (!numbers || first != ',' || second != ',' || !numbers.eof() || result.isZero(0))
        throw InvalidInput(fmt::format(
            "{} takes an axis (x, y, z, -x, -y, -z) or three numbers x,y,z that are not all 0, not '{}'",
            option, text));
    return result;
}

}  // namespace

SpectralOptions SpectralArguments::options_for(const MatchInput& input) const {
    SpectralOptions result = options;
    result.n_threads = input.common.threads;
    result.progress = input.progress;
    result.landmarks = landmarks.read(input.source, input.target);
    for (const std::string& pair : excluded) result.excluded.push_back(excluded_pair(pair));
    result.up = direction(up, "--up");
    result.facing = direction(facing, "--facing");
    return result;
}

MatchOptions SpectralArguments::match_options_for(const MatchInput& input) const {
    MatchOptions result{.spectral = options_for(input),
                        .spectral_shape = shape,
                        .n_threads = input.common.threads,
                        .progress = input.progress};
    if (!cache.empty())
        result.prepared_shape = [folder = cache](MeshView mesh, const SpectralShapeOptions& prepared) {
            CachedShape found = cached_spectral_shape(folder, mesh, prepared);
            if (!found.warning.empty()) warn(found.warning);
            return std::move(found.shape);
        };
    return result;
}

std::filesystem::path SpectralArguments::alternative(std::size_t number) const {
    return alternatives.parent_path() /
           platform::path_of(fmt::format("{}_{}{}", utf8_name(alternatives.stem()), number,
                                         utf8_name(alternatives.extension())));
}

MatchOutcome spectral_outcome(const SpectralArguments& arguments, const SpectralResult& result) {
    if (!arguments.alternatives.empty()) {
        for (std::size_t i = 0; i < result.alternatives.size(); ++i)
            write_vertex_map(result.alternatives[i].target_from_source, arguments.alternative(i + 1));
    }
    MatchOutcome outcome;
    outcome.summary.push_back(
        fmt::format("score {:.3f}, mean confidence {:.2f}", result.score, result.confidence.mean()));
    for (const SpectralAlternative& other : result.alternatives)
        outcome.summary.push_back(fmt::format("  runner-up {:.3f}: {}", other.score, other.description));
    outcome.details = report_of(result);
    outcome.stages = result.stages;
    outcome.source_from_target = result.source_from_target;
    return outcome;
}

MethodCommand add_spectral_method(CLI::App& match, const std::shared_ptr<SpectralArguments>& arguments) {
    const std::string group = "Options of --method spectral";
    add_known_pairs(match, arguments->landmarks,
                    "Known pairs, which hold exactly; one on a part that went wrong mostly mends the map",
                    group);
    match
        .add_flag("--soft-landmarks", arguments->options.soft_landmarks,
                  "Let the landmarks only guide the choice of the map")
        ->group(group);
    match
        .add_option("--not", arguments->excluded,
                    "A pair that does not correspond, SOURCE:TARGET, two 0-based vertices; may be repeated")
        ->type_name("A:B")
        ->group(group);
    match
        .add_flag("--aligned", arguments->options.aligned,
                  "Both meshes stand alike: up, front and left are the same directions in both; not with "
                  "--symmetric")
        ->group(group);
    match
        .add_option("--up", arguments->up,
                    "The direction that is up in both meshes: x, y, z, -x, -y, -z or three numbers x,y,z")
        ->type_name("AXIS")
        ->group(group);
    match
        .add_option("--facing", arguments->facing,
                    "The direction that both meshes face, as --up, which it needs")
        ->type_name("AXIS")
        ->group(group);
    match
        .add_option(
            "--mirror", arguments->options.mirror,
            "Whether the target may be the mirror image of what the source shows, as a left bone of a right "
            "one: auto (tried where little fits, and taken if clearly better), never, always")
        ->transform(CLI::CheckedTransformer(
            std::map<std::string, Mirror>{
                {"auto", Mirror::automatic}, {"never", Mirror::never}, {"always", Mirror::always}},
            CLI::ignore_case))
        ->option_text("auto|never|always [auto]")
        ->group(group);
    match
        .add_flag("--symmetric", arguments->options.symmetric,
                  "The same as --mirror always: swap left and right")
        ->group(group);
    match.add_option("--basis-size", arguments->shape.basis_size, "Number of Laplace eigenfunctions")
        ->check(whole_number(30, 500))
        ->capture_default_str()
        ->group(group);
    match.add_option("--samples", arguments->shape.n_samples, "Number of sample points for the search")
        ->check(whole_number(200, 5000))
        ->capture_default_str()
        ->group(group);
    match
        .add_option("--seed", arguments->shape.seed,
                    "Random seed for the first sample; 0 = the vertex farthest from the center")
        ->capture_default_str()
        ->group(group);
    add_path(match, "--cache", arguments->cache,
             "Keep prepared shapes in FOLDER, so that a mesh that is matched again is not prepared again")
        ->type_name("FOLDER")
        ->group(group);
    match
        .add_option("--alternatives", arguments->options.n_alternatives, "Number of runner-up maps to report")
        ->check(whole_number(0, 10))
        ->capture_default_str()
        ->group(group);
    add_path(match, "--alternatives-output", arguments->alternatives,
             "Write the runner-up maps, with _1, _2, ... before the extension of FILE")
        ->type_name("FILE")
        ->group(group);
    return {"spectral", "Laplace eigenfunctions: similar shapes, any triangulation, fully automatic",
            [arguments](const MatchInput& input) {
                MatchOptions options = arguments->match_options_for(input);
                options.method = MatchMethod::spectral;
                const MatchResult result = counterpart::match(input.source, input.target, options);
                return with_result(spectral_outcome(*arguments, *result.spectral), result);
            }};
}

}  // namespace counterpart::cli
