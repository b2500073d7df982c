// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/types.hpp>

#include <string>
#include <vector>

namespace counterpart::render {

/// Red, green, blue (sRGB), each 0 .. 1.
using Color = Eigen::RowVector3d;

/// Color maps with monotone lightness, legible with common kinds of color blindness and in gray.
enum class Colormap {
    viridis,  ///< dark blue to yellow: distances, levels (van der Walt and Smith 2015)
    cividis,  ///< dark blue to yellow, the same with and without red-green blindness (Nunez et al. 2018)
    magma,    ///< pale (low) to dark purple (high): errors, so that correct regions stay pale
};
/// Throws InvalidInput for a name that is not in colormap_names().
Colormap colormap_from_name(const std::string& name);
std::vector<std::string> colormap_names();

/// The color at `t`, clamped to 0 .. 1; gray if t is NaN.
Color sample(Colormap map, double t);

/// A color for each position: hue by the direction from the center of the image, shifted with depth; pale at
/// the center, lighter upward. `position` in -1 .. 1 on each axis: right, up, toward the viewer. Nearby
/// positions have similar colors; distant ones differ.
Color position_color(const Eigen::RowVector3d& position);

/// Color n of a palette that is also distinguishable with color blindness (Okabe and Ito 2008); repeats after
/// eight.
Color category_color(int n);

/// For elements without a value.
inline Color no_value_color() { return {0.62, 0.62, 0.62}; }

}  // namespace counterpart::render
