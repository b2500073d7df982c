// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// The triangles of a glTF file primitive by primitive, between the file's accessors and the joined surface.
#pragma once

#include "io/gltf_document.hpp"

#include <counterpart/io/gltf.hpp>

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

namespace counterpart::io {

/// One primitive as stored, in the scene's space: its own vertices, before welding. Absent parts are empty.
struct GltfPrimitive {
    std::size_t mesh = 0, number = 0;                         ///< meshes[mesh].primitives[number]
    std::int64_t node = -1;                                   ///< that places the mesh; -1: none does
    Eigen::Affine3d placement = Eigen::Affine3d::Identity();  ///< from the mesh's space into the scene's
    Points positions;
    Triangles triangles;
    Matrix normals;
    std::vector<Matrix> texture_coordinates, colors;
    SkinBinding skin;
    std::vector<Points> displacements;

    /// A placement that mirrors turns the triangles over.
    void turn_over() {
        if (triangles.rows() > 0) triangles.col(1).swap(triangles.col(2));
    }
};

/// All that hold triangles, of the meshes that the scene shows. Throws IoError, also if there are none.
std::vector<GltfPrimitive> read_primitives(const GltfDocument& document, std::vector<std::string>& notices);

/// The primitives as one surface. `content.document` stays empty.
GltfFile join_primitives(const GltfDocument& document, const std::vector<GltfPrimitive>& primitives);

/// What a document shows, with the document itself; of an object, one that shows nothing else. Throws
/// IoError.
GltfFile surface_of(GltfDocument document, const std::optional<std::string>& object = {});

}  // namespace counterpart::io
