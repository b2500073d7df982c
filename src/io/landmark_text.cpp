// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Landmarks as lines of text: 3D Slicer's .fcsv, tables (.csv), and TPS.
#include "io/decimal.hpp"
#include "io/landmark_formats.hpp"
#include "io/text_cursor.hpp"

#include <counterpart/base/errors.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

namespace counterpart::io {
namespace {

// Around fields of tables.
constexpr std::string_view around = " \t\r\"";

std::vector<std::string_view> fields_of(std::string_view line) {
    std::vector<std::string_view> fields;
    for (;;) {
        const std::size_t comma = line.find_first_of(",;");
        fields.push_back(stripped(line.substr(0, comma), around));
        if (comma == line.npos) return fields;
        line.remove_prefix(comma + 1);
    }
}

std::optional<double> number_of(std::string_view field) {
    double value = 0;
    const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
    if (error != std::errc() || end != field.data() + field.size() || !std::isfinite(value))
        return std::nullopt;
    return value;
}

// The name is the first field, then the three numbers.
std::optional<Eigen::RowVector3d> point_in(const std::vector<std::string_view>& fields) {
    if (fields.size() < 4) return std::nullopt;
    Eigen::RowVector3d point;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto number = number_of(fields[k + 1]);
        if (!number) return std::nullopt;
        point[static_cast<Eigen::Index>(k)] = *number;
    }
    return point;
}

// Calls take(line, its number) for each that is not blank.
template <class Take>
void for_each_full_line(std::string_view text, const Take& take) {
    text = without_mark(text);
    for (int number = 1; !text.empty(); ++number) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        if (!stripped(text.substr(0, end), around).empty()) take(text.substr(0, end), number);
        text.remove_prefix(std::min(end + 1, text.size()));
    }
}

[[noreturn]] void expect_point(const std::string& name, int number) {
    throw IoError(fmt::format("{}:{}: a name and three coordinates are expected", name, number));
}

std::string coordinates(const Landmark& landmark, char between) {
    std::string text;
    for (Eigen::Index k = 0; k < 3; ++k) {
        if (k > 0) text += between;
        append_decimal(text, landmark.point[k]);
    }
    return text;
}

// Of a line "# CoordinateSystem = LPS"; in old files 0 stands for RAS and 1 for LPS.
void read_axes(std::string_view line, const std::string& name, int number, LandmarkPoints& points) {
    const std::size_t at = line.find("CoordinateSystem");
    const std::size_t equals = at == line.npos ? at : line.find('=', at);
    if (equals == line.npos) return;
    const std::string_view word = stripped(line.substr(equals + 1), around);
    if (word != "RAS" && word != "0" && word != "LPS" && word != "1")
        throw IoError(fmt::format("{}:{}: the CoordinateSystem is neither LPS nor RAS", name, number));
    points.axes = word == "RAS" || word == "0" ? Anatomical::ras : Anatomical::lps;
}

}  // namespace

// Columns id, x, y, z, ow, ox, oy, oz, vis, sel, lock, label, desc, associatedNodeID.
LandmarkPoints parse_fcsv(std::string_view bytes, const std::string& name) {
    LandmarkPoints points;
    for_each_full_line(bytes, [&](std::string_view line, int number) {
        if (line.starts_with('#')) return read_axes(line, name, number, points);
        const std::vector<std::string_view> fields = fields_of(line);
        const auto point = point_in(fields);
        if (!point) expect_point(name, number);
        constexpr std::size_t label = 11;
        const bool has_label = fields.size() > label && !fields[label].empty();
        points.landmarks.push_back({std::string(fields[has_label ? label : 0]), *point});
    });
    return points;
}

LandmarkPoints parse_landmark_csv(std::string_view bytes, const std::string& name) {
    LandmarkPoints points;
    bool is_first = true;
    for_each_full_line(bytes, [&](std::string_view line, int number) {
        const std::vector<std::string_view> fields = fields_of(line);
        const auto point = point_in(fields);
        const bool is_heading = is_first && fields.size() >= 4 && !number_of(fields[1]);
        is_first = false;
        if (is_heading) return;
        if (!point) expect_point(name, number);
        points.landmarks.push_back({std::string(fields[0]), *point});
    });
    return points;
}

std::string fcsv_bytes(const LandmarkPoints& points) {
    std::string text = fmt::format(
        "# Markups fiducial file version = 4.11\n# CoordinateSystem = {}\n"
        "# columns = id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label,desc,associatedNodeID\n",
        to_string(points.axes.value()));
    std::size_t i = 0;
    for (const Landmark& landmark : points.landmarks)
        text += fmt::format("{},{},0,0,0,1,1,1,0,{},,\n", ++i, coordinates(landmark, ','), landmark.name);
    return text;
}

std::string landmark_csv_bytes(const LandmarkPoints& points) {
    std::string text = "name,x,y,z\n";
    for (const Landmark& landmark : points.landmarks)
        text += fmt::format("{},{}\n", landmark.name, coordinates(landmark, ','));
    return text;
}

std::string tps_bytes(const LandmarkPoints& points) {
    std::string text = fmt::format("LM3={}\n", points.landmarks.size());
    for (const Landmark& landmark : points.landmarks) text += coordinates(landmark, ' ') + '\n';
    return text;
}

}  // namespace counterpart::io
