// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/mesh/analyze.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace counterpart::cli {

/// What to know of two meshes before they are matched, as sentences and for the report: connectivity, scale
/// and units, up axis, inside out or mirrored, parts that may be missing.
struct MeshComparison {
    std::vector<std::string> sentences;
    nlohmann::ordered_json details;
};
MeshComparison compare_meshes(const TriangleMesh& first, const MeshReport& first_report,
                              const TriangleMesh& second, const MeshReport& second_report);

/// What may be the cause of a doubtful map, the likeliest first: missing parts, unlike shapes, mirrored or
/// inside out, not welded, other units, another axis up.
std::vector<std::string> probable_causes(const TriangleMesh& source, const TriangleMesh& target,
                                         const std::string& source_name, const std::string& target_name);

/// Where the connectivity differs and a mesh has vertices at the place of another: that, and the cure.
std::string welding_advice(const TriangleMesh& source, const TriangleMesh& target,
                           const std::string& source_name, const std::string& target_name);

}  // namespace counterpart::cli
