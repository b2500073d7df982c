// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "io/landmark_formats.hpp"
#include "platform/files.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/io/file.hpp>
#include <counterpart/io/landmark_points.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <fmt/format.h>

namespace counterpart {

using namespace io;

namespace {

struct LandmarkFormat {
    std::string_view extension;
    LandmarkPoints (*parse)(std::string_view bytes, const std::string& name) = nullptr;
    std::string (*bytes)(const LandmarkPoints& points) = nullptr;
    bool says_axes = false, is_table = false;
};

// The longer extension first.
constexpr std::array<LandmarkFormat, 5> landmark_formats = {
    {{".mrk.json", parse_slicer_json, slicer_json_bytes, true, false},
     {".fcsv", parse_fcsv, fcsv_bytes, true, true},
     {".json", parse_scalismo_json, scalismo_json_bytes, false, false},
     {".csv", parse_landmark_csv, landmark_csv_bytes, false, true},
     {".tps", nullptr, tps_bytes, false, false}}};

const LandmarkFormat& landmark_format_of(const std::filesystem::path& file) {
    std::string name = platform::utf8_name(file.filename());
    std::transform(name.begin(), name.end(), name.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    for (const LandmarkFormat& format : landmark_formats)
        if (name.ends_with(format.extension)) return format;
    throw IoError(
        fmt::format("{}: the name of landmarks must end in .mrk.json, .fcsv, .json, .csv or, to be "
                    "written, .tps, which tells the format",
                    platform::utf8_name(file)));
}

void turn(LandmarkPoints& points, Anatomical axes) {
    if (points.axes == axes) return;
    for (Landmark& landmark : points.landmarks) landmark.point.head<2>() *= -1;
    points.axes = axes;
}

std::map<std::string, Eigen::RowVector3d> by_name(const LandmarkPoints& points, const char* side) {
    std::map<std::string, Eigen::RowVector3d> found;
    for (const Landmark& landmark : points.landmarks)
        if (!found.emplace(landmark.name, landmark.point).second)
            throw InvalidInput(fmt::format("the {} has two landmarks '{}'", side, landmark.name));
    return found;
}

struct Nearest {
    Index vertex;
    double distance;
};

Nearest nearest_to(const Eigen::RowVector3d& point, MeshView mesh) {
    Eigen::Index vertex = 0;
    const double squared = (mesh.vertices.rowwise() - point).rowwise().squaredNorm().minCoeff(&vertex);
    return {static_cast<Index>(vertex), std::sqrt(squared)};
}

// The landmark that lies farthest from the mesh.
struct Farthest {
    const Landmark* landmark = nullptr;
    double distance = 0;
};

Farthest farthest_of(const std::vector<Landmark>& landmarks, MeshView mesh) {
    Farthest found;
    for (const Landmark& landmark : landmarks)
        if (const double distance = nearest_to(landmark.point, mesh).distance; distance > found.distance)
            found = {&landmark, distance};
    return found;
}

}  // namespace

std::string to_string(Anatomical axes) { return axes == Anatomical::lps ? "LPS" : "RAS"; }

LandmarkPoints read_landmark_points(const std::filesystem::path& file, std::optional<Anatomical> axes) {
    const LandmarkFormat& format = landmark_format_of(file);
    if (format.parse == nullptr)
        throw IoError(fmt::format("{}: TPS is written, not read", platform::utf8_name(file)));
    LandmarkPoints points = format.parse(read_whole_file(file), platform::utf8_name(file));
    if (points.landmarks.empty())
        throw IoError(fmt::format("{}: there are no landmarks", platform::utf8_name(file)));
    if (!axes) return points;
    if (!points.axes)
        throw IoError(
            fmt::format("{}: the file does not say whether its points are LPS or RAS, so they cannot "
                        "be turned to {}",
                        platform::utf8_name(file), to_string(*axes)));
    turn(points, *axes);
    return points;
}

void require_writable(const LandmarkPoints& points, const std::filesystem::path& file) {
    const LandmarkFormat& format = landmark_format_of(file);
    const auto require = [&](bool holds, const std::string& reason) {
        if (!holds) throw IoError(fmt::format("{}: not written: {}", platform::utf8_name(file), reason));
    };
    require(!format.says_axes || points.axes, "the format says LPS or RAS, and which it is was not given");
    for (const Landmark& landmark : points.landmarks) {
        require(landmark.point.allFinite(),
                fmt::format("landmark '{}' has a coordinate that is not finite", landmark.name));
        require(!format.is_table || landmark.name.find_first_of(",;\"\r\n#") == std::string::npos,
                fmt::format("the name '{}' has characters that the format cannot hold", landmark.name));
    }
}

void write_landmark_points(const LandmarkPoints& points, const std::filesystem::path& file) {
    require_writable(points, file);
    write_file(landmark_format_of(file).bytes(points), file);
}

void require_near(const std::vector<Landmark>& landmarks, MeshView mesh, const std::string& side) {
    constexpr double near = 0.05, far = 0.25, much_nearer = 0.25;  // near and far: shares of the diagonal
    const double diagonal = (mesh.vertices.colwise().maxCoeff() - mesh.vertices.colwise().minCoeff()).norm();
    const Farthest found = farthest_of(landmarks, mesh);
    if (found.distance <= near * diagonal) return;
    LandmarkPoints turned{landmarks, Anatomical::lps};
    turn(turned, Anatomical::ras);
    if (const double others = farthest_of(turned.landmarks, mesh).distance;
        others < much_nearer * found.distance)
        throw InvalidInput(fmt::format(
            "the {}'s landmarks lie up to {:.3g} from its mesh, and up to {:.3g} where x and y change "
            "signs: one of them is LPS, the other RAS; say which axes the mesh has",
            side, found.distance, others));
    if (found.distance > far * diagonal)
        throw InvalidInput(
            fmt::format("landmark '{}' of the {} lies {:.3g} from its mesh, which is {:.3g} "
                        "across: it was set in another frame or unit",
                        found.landmark->name, side, found.distance, diagonal));
}

std::vector<std::pair<Index, Index>> landmark_pairs(const LandmarkPoints& source_points, MeshView source,
                                                    const LandmarkPoints& target_points, MeshView target) {
    require_valid(source);
    require_valid(target);
    by_name(source_points, "source");
    const std::map<std::string, Eigen::RowVector3d> goals = by_name(target_points, "target");
    std::vector<Landmark> from, to;
    for (const Landmark& landmark : source_points.landmarks) {
        const auto goal = goals.find(landmark.name);
        if (goal == goals.end()) continue;
        from.push_back(landmark);
        to.push_back({landmark.name, goal->second});
    }
    if (from.empty()) throw InvalidInput("no landmark of the source has the name of one of the target");
    require_near(from, source, "source");
    require_near(to, target, "target");
    std::vector<std::pair<Index, Index>> pairs;
    for (std::size_t i = 0; i < from.size(); ++i)
        pairs.emplace_back(nearest_to(from[i].point, source).vertex, nearest_to(to[i].point, target).vertex);
    return pairs;
}

}  // namespace counterpart
