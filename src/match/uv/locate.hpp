// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/uv/layout.hpp"

#include <counterpart/map/surface_map.hpp>

#include <vector>

namespace counterpart::uv {

/// Where in another layout a vertex lies by one of its texture coordinates.
struct Located {
    enum class How {
        nowhere,
        surely,    ///< at one place
        by_place,  ///< several places have its coordinates, and one of them is clearly nearer
        undecided  ///< several have, and none is
    };

    Corner corner{};
    How how = How::nowhere;
    SurfacePoint point{};
    double outside = 0;  ///< how far outside of a chart, in units of texture coordinates
};

/// For each corner of `from` where it lies in `to`, at most `reach` outside of a chart; `near` is how far
/// apart points of the mesh of `to` may be and count as one place. Of charts over one another the one that is
/// nearest on average counts, after the similarity that fits best what has one place only.
std::vector<Located> locate(const Layout& from, const Layout& to, double reach, double near);

}  // namespace counterpart::uv
