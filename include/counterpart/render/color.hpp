// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/types.hpp>

#include <string>
#include <vector>

namespace counterpart {

/// Red, green, blue as on the screen (sRGB), each 0 .. 1.
using Color = Eigen::RowVector3d;

/// Colour maps with monotone lightness, legible with the common kinds of colour-blindness and in grey.
enum class Colormap {
    viridis,  ///< dark blue to yellow: distances, levels (van der Walt and Smith 2015)
    cividis,  ///< dark blue to yellow, the same with and without red-green blindness (Nunez et al. 2018)
    magma,    ///< pale (low) to dark purple (high): errors, so that what is right stays pale
};
/// Throws InvalidInput for a name that is not in colormap_names().
Colormap colormap_from_name(const std::string& name);
std::vector<std::string> colormap_names();

/// The colour at `t`, clamped to 0 .. 1; grey where t is not a number.
Color sample(Colormap map, double t);

/// The color wheel of a position: hue by the direction from the middle of the picture, turned gradually along
/// depth, pale in the middle, lighter upwards. `position` in -1 .. 1 on each axis: right, up, towards the
/// viewer. Nearby positions have nearby colours; distant ones differ.
Color position_color(const Eigen::RowVector3d& position);

/// n colours that are told apart also by the colour-blind (Okabe and Ito 2008), repeated after eight.
Color category_color(int n);

/// What has no value.
inline Color no_value_color() { return {0.62, 0.62, 0.62}; }

}  // namespace counterpart
