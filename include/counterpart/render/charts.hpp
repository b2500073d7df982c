// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/types.hpp>
#include <counterpart/render/drawing.hpp>

#include <string>
#include <vector>

namespace counterpart {

/// One map's line in the diagram of errors.
struct ErrorCurve {
    std::string label;
    std::vector<double> errors;           ///< increasing, x 100 / sqrt(target area)
    std::vector<double> fraction_within;  ///< 0 .. 1 for each of them
    double mean = 0;                      ///< for the legend; left out where it is not finite
};

struct ChartOptions {
    int width = 1200, height = 800;  ///< pixels, at least 300 x 200
    double max_error = 0;            ///< where the horizontal axis ends; 0 = the largest error given
};

/// The share of vertices within an error, over the error, with axes, grid and legend. Throws InvalidInput for
/// no curves, curves whose two lists differ in length or are empty, or bad options.
Drawing error_chart(const std::vector<ErrorCurve>& curves, const ChartOptions& options = {});

/// A bar of colours with ticks and a title, within the given box.
struct ColorBar {
    double left = 0, top = 0, width = 0, height = 0;  ///< of the colours; numbers and title stand below
    Colormap colormap = Colormap::magma;
    double max = 1;
    std::string title;
    double text_size = 20;
};
void add_color_bar(Drawing& drawing, const ColorBar& bar);

/// Square matrices of distances as pictures side by side with titles, in one scale of colours: black to
/// yellow, infinite in grey. Large matrices are averaged down, small ones drawn in blocks. Throws
/// InvalidInput for no matrices, empty ones, or as many titles as not.
Image matrix_picture(const std::vector<Matrix>& matrices, const std::vector<std::string>& titles, int width,
                     int height);

/// Steps of 1, 2 or 5 times a power of ten that divide 0 .. max into at most `most` parts.
std::vector<double> round_ticks(double max, int most);

}  // namespace counterpart
