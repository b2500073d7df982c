// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/types.hpp>
#include <counterpart/render/image.hpp>

#include <string>
#include <variant>
#include <vector>

namespace counterpart::render {

/// Flat shapes, in pixels from the top left corner, drawn one over the other: charts, and labels on images.
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
    double anchor = 0;  ///< fraction of the text left of `at`: 0 starts there, 0.5 is centered, 1 ends there
    bool upward = false;  ///< rotated to read upward
};
struct Drawing {
    int width = 0, height = 0;
    std::vector<std::variant<Polyline, Box, Text>> shapes;
};

/// Draws over the image, anti-aliased. Shapes may extend beyond it. Text uses a built-in stroke font, so that
/// it looks the same on every machine.
void draw(const Drawing& drawing, Image& image);
/// The same as an SVG document on white, with real text.
std::string to_svg(const Drawing& drawing);

/// Width of a text in pixels when drawn.
double text_width(const std::string& text, double size);

/// One map's curve in an error chart.
struct ErrorCurve {
    std::string label;
    std::vector<double> errors;           ///< increasing, x 100 / sqrt(target area)
    std::vector<double> fraction_within;  ///< 0 .. 1 for each of them
    double mean = 0;                      ///< for the legend; left out where it is not finite
};

struct ChartOptions {
    int width = 1200, height = 800;  ///< pixels, at least 300 x 200
    double max_error = 0;            ///< end of the horizontal axis; 0 = the largest error given
};

/// Cumulative error curves: the fraction of vertices within each error, with axes, grid and legend. Throws
/// InvalidInput for no curves, curves whose two lists differ in length or are empty, or options out of range.
Drawing error_chart(const std::vector<ErrorCurve>& curves, const ChartOptions& options = {});

/// A color bar with ticks and a title, in the given box.
struct ColorBar {
    double left = 0, top = 0, width = 0, height = 0;  ///< of the colors; numbers and title stand below
    Colormap colormap = Colormap::magma;
    double max = 1;
    std::string title;
    double text_size = 20;
};
void add_color_bar(Drawing& drawing, const ColorBar& bar);

/// Square distance matrices side by side with titles, in one color scale (viridis); infinite entries are
/// gray. Large matrices are averaged down, small ones drawn in blocks. Throws InvalidInput for no matrices,
/// empty ones, or another number of titles.
Image matrix_picture(const std::vector<Matrix>& matrices, const std::vector<std::string>& titles, int width,
                     int height);

/// Steps of 1, 2 or 5 times a power of ten that divide 0 .. max into at most `most` parts.
std::vector<double> round_ticks(double max, int most);

}  // namespace counterpart::render
