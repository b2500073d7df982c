// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/mesh/attributed_mesh.hpp>
#include <counterpart/mesh/shapes.hpp>

#include <string>
#include <vector>

namespace counterpart::test {

/// A joint of a skeleton in its rest pose, unturned.
struct Joint {
    std::string name;
    Index parent = -1;  ///< an earlier joint; -1 for the root
    Eigen::RowVector3d position;
};

struct Character {
    AttributedMesh content;
    std::vector<Joint> joints;  ///< 8: what content.skin.joints numbers
};

/// The figure of make_body as an artist would deliver it: one set of texture coordinates in two charts, front
/// and back, with a seam between them; a color for each vertex; up to four of eight joints for each vertex;
/// the blend shapes "smile", "belly" and "wag". All numbers are floats held in doubles, so that files of
/// floats keep them as they are.
Character make_character(const BodyOptions& options = {});

}  // namespace counterpart::test
