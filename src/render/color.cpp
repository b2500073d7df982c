// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include <counterpart/base/errors.hpp>
#include <counterpart/render/color.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

namespace counterpart::render {
namespace {

// Colors at equal steps of the published tables; between them interpolation is off by less than 0.01.
constexpr std::array viridis = {0x440154, 0x482878, 0x3e4989, 0x31688e, 0x26828e,
                                0x1f9e89, 0x35b779, 0x6ece58, 0xb5de2b, 0xfde725};
constexpr std::array cividis = {0x00224e, 0x123570, 0x3b496c, 0x575d6d, 0x707173,
                                0x8a8678, 0xa59c74, 0xc3b369, 0xe1cc55, 0xfee838};
// Reversed, and without the darkest tenth, on which shading could not be seen.
constexpr std::array magma = {0xfcfdbf, 0xfec98d, 0xfd9567, 0xf1605d, 0xcd4071,
                              0x9e2f7f, 0x721f81, 0x440f76, 0x180f3d};
constexpr std::array okabe_ito = {0x0072b2, 0xd55e00, 0x009e73, 0xcc79a7,
                                  0xe69f00, 0x56b4e9, 0x000000, 0xb8a800};

Color from_hex(int hex) { return Color((hex >> 16) & 255, (hex >> 8) & 255, hex & 255) / 255.0; }

std::span<const int> table(Colormap map) {
    switch (map) {
        case Colormap::cividis:
            return cividis;
        case Colormap::magma:
            return magma;
        default:
            return viridis;
    }
}

}  // namespace

std::vector<std::string> colormap_names() { return {"viridis", "cividis", "magma"}; }

Colormap colormap_from_name(const std::string& name) {
    const std::vector<std::string> names = colormap_names();
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end())
        throw InvalidInput("there is no color map '" + name + "'; use viridis, cividis or magma");
    return static_cast<Colormap>(found - names.begin());
}

Color sample(Colormap map, double t) {
    if (std::isnan(t)) return no_value_color();
    const std::span<const int> colors = table(map);
    const double place = std::clamp(t, 0.0, 1.0) * static_cast<double>(colors.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(place), colors.size() - 2);
    const double part = place - static_cast<double>(below);
    return (1 - part) * from_hex(colors[below]) + part * from_hex(colors[below + 1]);
}

Color position_color(const Eigen::RowVector3d& position) {
    // A circle of constant lightness in the Oklab color space (Ottosson 2020), where equal distances look
    // equal.
    const double radius = std::min(1.0, std::hypot(position.x(), position.y()));
    const double hue = std::atan2(position.y(), position.x()) + 0.9 * position.z();
    const double chroma = 0.15 * std::pow(radius, 0.6);
    const double lightness = 0.74 + 0.08 * position.y() - 0.05 * position.z();
    const double a = chroma * std::cos(hue), b = chroma * std::sin(hue);
    const Eigen::Array3d roots(lightness + 0.3963377774 * a + 0.2158037573 * b,
                               lightness - 0.1055613458 * a - 0.0638541728 * b,
                               lightness - 0.0894841775 * a - 1.2914855480 * b);
    const Eigen::Vector3d lms = roots.cube();
    Eigen::Matrix3d rgb_from_lms;
    rgb_from_lms << 4.0767416621, -3.3077115913, 0.2309699292,  //
        -1.2684380046, 2.6097574011, -0.3413193965,             //
        -0.0041960863, -0.7034186147, 1.7076147010;
    const auto encode = [](double x) {
        x = std::clamp(x, 0.0, 1.0);
        return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
    };
    return (rgb_from_lms * lms).unaryExpr(encode).transpose();
}

Color category_color(int n) { return from_hex(okabe_ito[static_cast<std::size_t>(n) % okabe_ito.size()]); }

}  // namespace counterpart::render
