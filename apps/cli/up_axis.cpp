// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "up_axis.hpp"

#include <counterpart/render/camera.hpp>

#include <fmt/format.h>

namespace counterpart::cli {

std::string guessed_up(MeshView mesh, const CommonOptions& options) {
    std::string up = render::find_up_axis(mesh);
    say(options, fmt::format("up is {}, a guess from the shape; --up sets another", up));
    return up;
}

}  // namespace counterpart::cli
