// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/mesh/triangle_mesh.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace counterpart {

/// A point that a person has set on a mesh.
struct Landmark {
    std::string name;
    Eigen::RowVector3d point = Eigen::RowVector3d::Zero();
};

/// Which way the axes of a patient's scan point: to the left, back and up, or to the right, front and up.
enum class Anatomical { lps, ras };
/// "LPS", "RAS"
std::string to_string(Anatomical axes);

struct LandmarkPoints {
    std::vector<Landmark> landmarks;
    std::optional<Anatomical> axes{};  ///< as the file says; none if it does not
};

/// Reads the landmarks of one mesh, by the extension: .mrk.json and .fcsv of 3D Slicer, .json of scalismo,
/// .csv (name, x, y, z in each line; a first line without numbers is a heading). Points that are not defined
/// are left out. With `axes`, the points are turned to these from those that the file says; a file that says
/// none is then refused, since that cannot be guessed. Throws IoError naming file, line or entry, and reason.
LandmarkPoints read_landmark_points(const std::filesystem::path& file, std::optional<Anatomical> axes = {});

/// Writes .mrk.json, .fcsv, .json of scalismo, .csv, or .tps (LM3) by the extension. Throws IoError, also
/// where .mrk.json or .fcsv must say axes and there are none, or a name has characters that the format cannot
/// hold.
void write_landmark_points(const LandmarkPoints& points, const std::filesystem::path& file);

/// Throws what write_landmark_points would throw for these points and this file name.
void require_writable(const LandmarkPoints& points, const std::filesystem::path& file);

/// Throws InvalidInput where landmarks were set in another frame or unit than the mesh: one lies farther from
/// all vertices than a quarter of the mesh's diagonal; or one lies farther than a twentieth, and all come
/// four times nearer when they are turned from LPS to RAS. `side` ("source") is for the message. O(V) for
/// each.
void require_near(const std::vector<Landmark>& landmarks, MeshView mesh, const std::string& side);

/// The vertices nearest to landmarks of the same name, in the source's order. Throws InvalidInput if a name
/// is there twice or no two are the same, and as require_near. O(V) for each.
std::vector<std::pair<Index, Index>> landmark_pairs(const LandmarkPoints& source_points, MeshView source,
                                                    const LandmarkPoints& target_points, MeshView target);

}  // namespace counterpart
