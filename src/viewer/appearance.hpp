// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "viewer/scene_buffer.hpp"

#include <counterpart/viewer/viewer_page.hpp>

#include <string>

#include <nlohmann/json.hpp>

namespace counterpart::viewer {

/// Throws InvalidInput, naming the mesh by `name`, if the appearance does not fit it.
void require_fit(const ViewerAppearance& appearance, MeshView mesh, const std::string& name);

/// Adds an appearance to a mesh's description, if there is one: texture coordinates and colors corner by
/// corner, so that seams show.
void put_appearance(const ViewerAppearance& appearance, nlohmann::ordered_json& mesh, SceneBuffer& buffer);

}  // namespace counterpart::viewer
