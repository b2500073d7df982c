// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "render/tracer.hpp"

#include <vector>

namespace counterpart::render {

/// How much light reaches a point: of the whole sky, and of the key light. 0 .. 1 each.
struct Light {
    float sky = 1, key = 1;
};

inline Eigen::Vector3f key_direction() { return Eigen::Vector3f(-0.45F, 0.75F, 0.65F).normalized(); }

/// The hit of each pixel's center, row by row from the top.
using Hits = std::vector<Tracer::Hit>;

/// Light at each pixel's hit. Each pixel of a 4 x 4 tile casts different rays of a fixed pattern; then
/// pixels of the same surface share their results, which removes the noise as 16 times as many rays would.
std::vector<Light> gather_light(const Tracer& tracer, const Hits& hits, int width, int height, int rays);

}  // namespace counterpart::render
