// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match_options.hpp"

#include <counterpart/base/errors.hpp>

#include <array>
#include <functional>
#include <map>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace counterpart::javascript {
namespace {

using Json = nlohmann::json;
using Pairs = std::vector<std::pair<Index, Index>>;

MatchMethod method_of(const std::string& name) {
    if (name == "auto") return MatchMethod::automatic;
    for (const MatchMethod method :
         {MatchMethod::exact, MatchMethod::frontiers, MatchMethod::partial, MatchMethod::spectral,
          MatchMethod::place, MatchMethod::nearest, MatchMethod::assignment})
        if (name == to_string(method)) return method;
    throw InvalidInput("there is no method '" + name +
                       "': auto, exact, frontiers, partial, spectral, place, nearest or assignment");
}

Part part_of_name(const std::string& name) {
    for (const Part part : {Part::unknown, Part::source, Part::target, Part::both, Part::neither})
        if (name == to_string(part)) return part;
    throw InvalidInput("part cannot be '" + name + "': unknown, source, target, both or neither");
}

Mirror mirror_of(const std::string& name) {
    if (name == "auto") return Mirror::automatic;
    if (name == "never") return Mirror::never;
    if (name == "always") return Mirror::always;
    throw InvalidInput("mirror cannot be '" + name + "': auto, never or always");
}

Eigen::Vector3d direction_of(const Json& value) {
    if (!value.is_string()) {
        const auto [x, y, z] = value.get<std::array<double, 3>>();
        return {x, y, z};
    }
    const auto name = value.get<std::string>();
    const bool is_negative = name.starts_with('-');
    const std::size_t axis = std::string_view("xyz").find(is_negative ? name.substr(1) : name);
    if (name.size() != (is_negative ? 2U : 1U) || axis == std::string_view::npos)
        throw InvalidInput("a direction must be x, y, z, -x, -y, -z or three numbers, not '" + name + "'");
    Eigen::Vector3d direction = Eigen::Vector3d::Zero();
    direction[static_cast<Eigen::Index>(axis)] = is_negative ? -1 : 1;
    return direction;
}

using Setter = std::function<void(MatchOptions&, const Json&)>;

// What each option sets.
const std::map<std::string, Setter>& setters() {
    static const std::map<std::string, Setter> all = {
        {"method", [](MatchOptions& o, const Json& v) { o.method = method_of(v.get<std::string>()); }},
        {"minShared", [](MatchOptions& o, const Json& v) { o.min_shared = v.get<double>(); }},
        {"allowMirror", [](MatchOptions& o, const Json& v) { o.exact.allow_mirror = v.get<bool>(); }},
        {"weldDistance", [](MatchOptions& o, const Json& v) { o.exact.weld_distance = v.get<double>(); }},
        {"landmarks",
         [](MatchOptions& o, const Json& v) { o.spectral.landmarks = o.partial.landmarks = v.get<Pairs>(); }},
        {"softLandmarks",
         [](MatchOptions& o, const Json& v) {
             o.spectral.soft_landmarks = o.partial.soft_landmarks = v.get<bool>();
         }},
        {"excluded", [](MatchOptions& o, const Json& v) { o.spectral.excluded = v.get<Pairs>(); }},
        {"aligned", [](MatchOptions& o, const Json& v) { o.spectral.aligned = v.get<bool>(); }},
        {"up", [](MatchOptions& o, const Json& v) { o.spectral.up = direction_of(v); }},
        {"facing", [](MatchOptions& o, const Json& v) { o.spectral.facing = direction_of(v); }},
        {"mirror",
         [](MatchOptions& o, const Json& v) { o.spectral.mirror = mirror_of(v.get<std::string>()); }},
        {"symmetric", [](MatchOptions& o, const Json& v) { o.spectral.symmetric = v.get<bool>(); }},
        {"basisSize", [](MatchOptions& o, const Json& v) { o.spectral_shape.basis_size = v.get<int>(); }},
        {"nSamples", [](MatchOptions& o, const Json& v) { o.spectral_shape.n_samples = v.get<int>(); }},
        {"seed", [](MatchOptions& o,
                    const Json& v) { o.spectral_shape.seed = o.partial.seed = v.get<std::uint64_t>(); }},
        {"part", [](MatchOptions& o, const Json& v) { o.partial.part = part_of_name(v.get<std::string>()); }},
        {"sameScale", [](MatchOptions& o, const Json& v) { o.partial.same_scale = v.get<bool>(); }},
        {"nAlternatives",
         [](MatchOptions& o, const Json& v) {
             o.spectral.n_alternatives = o.partial.n_alternatives = v.get<int>();
         }},
    };
    return all;
}

}  // namespace

MatchOptions match_options_of(const std::string& json) {
    MatchOptions options;
    const Json given = Json::parse(json);
    for (const auto& [name, value] : given.items()) {
        const auto setter = setters().find(name);
        if (setter == setters().end()) throw InvalidInput(fmt::format("match has no option '{}'", name));
        try {
            setter->second(options, value);
        } catch (const Json::exception&) {
            throw InvalidInput(fmt::format("{} cannot be {}", name, value.dump()));
        }
    }
    return options;
}

}  // namespace counterpart::javascript
