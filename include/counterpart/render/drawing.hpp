// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/render/image.hpp>

#include <string>
#include <variant>
#include <vector>

namespace counterpart {

/// Flat shapes, in pixels from the top left corner, drawn one over the other: diagrams, and what is written
/// on a picture.
struct Polyline {
    std::vector<Eigen::RowVector2d> points;
    Color color;
    double width = 1;
};
struct Box {
    double left = 0, top = 0, width = 0, height = 0;
    Color color;
};
struct Text {
    Eigen::RowVector2d at;  ///< on the baseline
    std::string text;       ///< printable ASCII; anything else shows as a small box
    double size = 20;       ///< height of a capital x 1.4
    Color color = {0.2, 0.2, 0.2};
    double anchor = 0;  ///< the part of the text left of `at`: 0 starts there, 0.5 is centred, 1 ends there
    bool upwards = false;  ///< read from below
};
struct Drawing {
    int width = 0, height = 0;
    std::vector<std::variant<Polyline, Box, Text>> shapes;
};

/// Draws over the image, anti-aliased. Shapes may reach beyond it. Text is set in a stroke font of our own,
/// so that it looks the same on a machine without fonts.
void draw(const Drawing& drawing, Image& image);
/// The same as an SVG document on white, with real text.
std::string to_svg(const Drawing& drawing);

/// Width of a text in pixels when drawn.
double text_width(const std::string& text, double size);

}  // namespace counterpart
