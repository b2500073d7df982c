// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Landmarks as JSON: 3D Slicer's markups (.mrk.json, schema 1.0.3) and scalismo's list.
#include "io/landmark_formats.hpp"
#include "io/text_cursor.hpp"

#include <counterpart/base/errors.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace counterpart::io {
namespace {

using LandmarkJson = nlohmann::ordered_json;

[[noreturn]] void refuse(const std::string& name, const std::string& reason) {
    throw IoError(fmt::format("{}: {}", name, reason));
}

LandmarkJson parsed(std::string_view bytes, const std::string& name) {
    constexpr int most_levels = 64;  // copying recurses
    const auto check = [&](int depth, LandmarkJson::parse_event_t, const LandmarkJson&) {
        if (depth > most_levels) refuse(name, "the JSON is nested too deep");
        return true;
    };
    LandmarkJson json = LandmarkJson::parse(without_mark(bytes), check, false);
    if (json.is_discarded()) refuse(name, "the JSON is damaged");
    return json;
}

Eigen::RowVector3d point_of(const LandmarkJson& numbers, std::size_t i, const std::string& name) {
    if (!numbers.is_array() || numbers.size() != 3)
        refuse(name, fmt::format("point {} has no three coordinates", i));
    Eigen::RowVector3d point;
    for (std::size_t k = 0; k < 3; ++k) {
        if (!numbers[k].is_number())
            refuse(name, fmt::format("point {} has a coordinate that is no number", i));
        point[static_cast<Eigen::Index>(k)] = numbers[k].get<double>();
    }
    if (!point.allFinite()) refuse(name, fmt::format("point {} has a coordinate that is not finite", i));
    return point;
}

std::string text_of(const LandmarkJson& object, const char* key) {
    return object.contains(key) && object[key].is_string() ? object[key].get<std::string>() : "";
}

std::optional<Anatomical> axes_of(const std::string& word, const std::string& name) {
    if (word.empty()) return std::nullopt;
    if (word == "LPS") return Anatomical::lps;
    if (word == "RAS") return Anatomical::ras;
    refuse(name, "the coordinateSystem is neither LPS nor RAS");
}

void add_markup(const LandmarkJson& markup, const std::string& name, LandmarkPoints& points) {
    if (!markup.contains("controlPoints") || !markup["controlPoints"].is_array()) return;
    std::size_t i = 0;
    for (const LandmarkJson& control : markup["controlPoints"]) {
        const std::string status = text_of(control, "positionStatus");
        ++i;
        if (!status.empty() && status != "defined") continue;
        if (!control.contains("position")) refuse(name, fmt::format("point {} has no position", i - 1));
        std::string label = text_of(control, "label");
        if (label.empty()) label = text_of(control, "id");
        points.landmarks.push_back({std::move(label), point_of(control["position"], i - 1, name)});
    }
}

}  // namespace

LandmarkPoints parse_slicer_json(std::string_view bytes, const std::string& name) {
    const LandmarkJson json = parsed(bytes, name);
    if (!json.is_object() || !json.contains("markups") || !json["markups"].is_array())
        refuse(name, "there are no markups");
    LandmarkPoints points;
    bool is_first = true;
    for (const LandmarkJson& markup : json["markups"]) {
        const auto axes = axes_of(text_of(markup, "coordinateSystem"), name);
        if (!is_first && axes != points.axes) refuse(name, "the markups have different coordinate systems");
        is_first = false;
        points.axes = axes;
        add_markup(markup, name, points);
    }
    return points;
}

LandmarkPoints parse_scalismo_json(std::string_view bytes, const std::string& name) {
    const LandmarkJson json = parsed(bytes, name);
    if (!json.is_array()) refuse(name, "a list of landmarks with id and coordinates is expected");
    LandmarkPoints points;
    for (const LandmarkJson& landmark : json) {
        const std::size_t i = points.landmarks.size();
        if (!landmark.is_object() || !landmark.contains("coordinates"))
            refuse(name, fmt::format("point {} has no coordinates", i));
        points.landmarks.push_back({text_of(landmark, "id"), point_of(landmark["coordinates"], i, name)});
    }
    return points;
}

std::string slicer_json_bytes(const LandmarkPoints& points) {
    LandmarkJson controls = LandmarkJson::array();
    for (const Landmark& landmark : points.landmarks)
        controls.push_back({{"id", std::to_string(controls.size() + 1)},
                            {"label", landmark.name},
                            {"position", {landmark.point[0], landmark.point[1], landmark.point[2]}},
                            {"positionStatus", "defined"}});
    LandmarkJson markup = {{"type", "Fiducial"}, {"coordinateSystem", to_string(points.axes.value())}};
    markup["controlPoints"] = std::move(controls);
    LandmarkJson json = {
        {"@schema",
         "https://raw.githubusercontent.com/slicer/slicer/master/Modules/Loadable/Markups/Resources/"
         "Schema/markups-schema-v1.0.3.json#"}};
    json["markups"] = LandmarkJson::array({std::move(markup)});
    return json.dump(1, ' ', false, LandmarkJson::error_handler_t::replace) + '\n';
}

std::string scalismo_json_bytes(const LandmarkPoints& points) {
    LandmarkJson json = LandmarkJson::array();
    for (const Landmark& landmark : points.landmarks)
        json.push_back({{"id", landmark.name},
                        {"coordinates", {landmark.point[0], landmark.point[1], landmark.point[2]}}});
    return json.dump(1, ' ', false, LandmarkJson::error_handler_t::replace) + '\n';
}

}  // namespace counterpart::io
