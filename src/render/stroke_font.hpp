// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/types.hpp>

#include <string>
#include <vector>

namespace counterpart::render {

/// A text as pen strokes: x to the right from 0, y up from the baseline, capitals 1 high.
struct StrokedText {
    std::vector<std::vector<Eigen::RowVector2d>> strokes;
    double width = 0;
};
StrokedText stroke_text(const std::string& text);

}  // namespace counterpart::render
