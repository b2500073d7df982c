// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// What `counterpart match` needs from each method. A method lives in match_<name>.cpp: it adds its own
// options to the command and returns a function that runs it.
#pragma once

#include "console.hpp"

#include <counterpart/base/message.hpp>
#include <counterpart/map/vertex_map.hpp>
#include <counterpart/match/match.hpp>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace counterpart::cli {

struct MatchInput {
    const TriangleMesh& source;
    const TriangleMesh& target;
    const CommonOptions& common;
    Progress progress;
    CornerAttribute source_uv{}, target_uv{};  ///< texture coordinates; none but for the method uv
};

struct MatchOutcome {
    VertexMap target_from_source;
    std::optional<VertexMap> source_from_target{};  ///< if the method finds it; else it is the inverse
    Vector confidence{};                            ///< per source vertex; empty if the method has none
    std::string method{};                           ///< that auto chose; else empty
    std::vector<std::string> summary{};             ///< what the method found, in lines for the user
    std::vector<Message> messages{};                ///< what was noticed and what may be wrong
    std::vector<Message> causes{};                  ///< of a verdict other than "use"
    Json details = Json::object();                  ///< the method's part of the report
    std::vector<StageTime> stages{};
    std::string failure{};  ///< not empty: write the report, but no map, and fail with this sentence
};

/// With the map, confidence and messages of a result of match().
MatchOutcome with_result(MatchOutcome outcome, const MatchResult& result);
/// Of a map of which nothing but the map is known, or a confidence.
MatchOutcome plain_outcome(const MatchInput& input, VertexMap target_from_source, Vector confidence = {});

struct MethodCommand {
    std::string name;
    std::string summary;  ///< half a line for --help
    std::function<MatchOutcome(const MatchInput&)> run;
    bool has_confidence = true;
    std::vector<std::string> shared_options{};  ///< that another method brings and this one uses, too
};

MethodCommand add_frontiers_method(CLI::App& match);
MethodCommand add_assignment_method(CLI::App& match);
struct ExactArguments;
struct PartialArguments;
struct SpectralArguments;

MethodCommand add_auto_method(const std::shared_ptr<ExactArguments>& exact,
                              const std::shared_ptr<SpectralArguments>& spectral,
                              const std::shared_ptr<PartialArguments>& partial);
MethodCommand add_exact_method(CLI::App& match, const std::shared_ptr<ExactArguments>& arguments);
MethodCommand add_nearest_method(CLI::App& match);
MethodCommand add_place_method(CLI::App& match);
MethodCommand add_uv_method(CLI::App& match);
MethodCommand add_partial_method(CLI::App& match, const std::shared_ptr<PartialArguments>& arguments,
                                 const std::shared_ptr<SpectralArguments>& shared);
MethodCommand add_spectral_method(CLI::App& match, const std::shared_ptr<SpectralArguments>& arguments);

}  // namespace counterpart::cli
