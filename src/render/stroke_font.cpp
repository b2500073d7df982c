// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "render/stroke_font.hpp"

#include <array>
#include <sstream>

namespace counterpart::render {
namespace {

struct Glyph {
    int width;
    const char* path;  // M = move, L = line, Q = quadratic curve; capitals are 14 high, small letters 10
};

// ' ' to '~'.
constexpr std::array<Glyph, 95> glyphs = {{
    {4, ""},
    {0, "M0 14 L0 5 M0 0 L0 1"},
    {4, "M0 14 L0 10 M4 14 L4 10"},
    {10, "M3 0 L5 14 M7 0 L9 14 M1 9 L11 9 M0 5 L10 5"},
    {8, "M8 11 Q7 13 4 13 Q0 13 0 10 Q0 7 4 7 Q8 6 8 4 Q8 1 4 1 Q1 1 0 3 M4 15 L4 -1"},
    {14,
     "M3 7 Q0 7 0 10 Q0 14 3 14 Q6 14 6 10 Q6 7 3 7 M12 14 L2 0 M11 0 Q8 0 8 3 Q8 7 11 7 Q14 7 14 3 Q14 0 11 "
     "0"},
    {11, "M11 0 L2 10 Q1 14 4 14 Q8 14 7 11 Q6 9 2 7 Q0 5 0 4 Q0 0 4 0 Q8 0 10 6"},
    {0, "M0 14 L0 10"},
    {3, "M3 16 Q0 12 0 6 Q0 1 3 -3"},
    {3, "M0 16 Q3 12 3 6 Q3 1 0 -3"},
    {8, "M4 13 L4 5 M0 11 L8 7 M0 7 L8 11"},
    {8, "M4 1 L4 9 M0 5 L8 5"},
    {1, "M1 1 L0 -2"},
    {6, "M0 5 L6 5"},
    {0, "M0 0 L0 1"},
    {7, "M0 -2 L7 15"},
    {8, "M4 0 Q0 0 0 7 Q0 14 4 14 Q8 14 8 7 Q8 0 4 0"},
    {6, "M1 11 L5 14 L5 0"},
    {8, "M0 11 Q0 14 4 14 Q8 14 8 10 Q8 7 0 0 L8 0"},
    {8, "M0 12 Q1 14 4 14 Q8 14 8 11 Q8 8 3 8 M3 8 Q8 8 8 4 Q8 0 4 0 Q1 0 0 2"},
    {9, "M7 0 L7 14 L0 4 L9 4"},
    {8, "M7 14 L1 14 L0 8 Q2 9 4 9 Q8 9 8 4 Q8 0 4 0 Q1 0 0 2"},
    {8, "M7 13 Q6 14 5 14 Q0 14 0 5 Q0 0 4 0 Q8 0 8 4 Q8 8 4 8 Q0 8 0 4"},
    {8, "M0 14 L8 14 L3 0"},
    {8, "M4 8 Q0 8 0 11 Q0 14 4 14 Q8 14 8 11 Q8 8 4 8 Q0 8 0 4 Q0 0 4 0 Q8 0 8 4 Q8 8 4 8"},
    {8, "M1 1 Q2 0 3 0 Q8 0 8 9 Q8 14 4 14 Q0 14 0 10 Q0 6 4 6 Q8 6 8 10"},
    {0, "M0 9 L0 10 M0 0 L0 1"},
    {1, "M1 9 L1 10 M1 1 L0 -2"},
    {8, "M8 9 L0 5 L8 1"},
    {8, "M0 7 L8 7 M0 3 L8 3"},
    {8, "M0 9 L8 5 L0 1"},
    {7, "M0 12 Q1 14 4 14 Q7 14 7 11 Q7 9 5 8 Q3 7 3 4 M3 0 L3 1"},
    {13,
     "M9 8 Q9 10 7 10 Q4 10 4 7 Q4 4 7 4 Q9 4 9 8 Q9 4 11 4 Q13 5 13 8 Q13 14 7 14 Q0 14 0 7 Q0 0 7 0 Q9 0 "
     "11 1"},
    {10, "M0 0 L5 14 L10 0 M2 5 L8 5"},
    {10, "M0 0 L0 14 L5 14 Q9 14 9 11 Q9 8 5 8 L0 8 M5 8 Q10 8 10 4 Q10 0 5 0 L0 0"},
    {10, "M10 11 Q9 14 6 14 Q0 14 0 7 Q0 0 6 0 Q9 0 10 3"},
    {10, "M0 0 L0 14 L4 14 Q10 14 10 7 Q10 0 4 0 L0 0"},
    {9, "M9 14 L0 14 L0 0 L9 0 M0 7 L7 7"},
    {8, "M8 14 L0 14 L0 0 M0 7 L7 7"},
    {11, "M10 11 Q9 14 6 14 Q0 14 0 7 Q0 0 6 0 Q11 0 11 6 L7 6"},
    {10, "M0 0 L0 14 M10 0 L10 14 M0 7 L10 7"},
    {0, "M0 0 L0 14"},
    {6, "M6 14 L6 4 Q6 0 3 0 Q0 0 0 3"},
    {9, "M0 0 L0 14 M9 14 L0 5 M3 8 L9 0"},
    {8, "M0 14 L0 0 L8 0"},
    {12, "M0 0 L0 14 L6 4 L12 14 L12 0"},
    {10, "M0 0 L0 14 L10 0 L10 14"},
    {12, "M6 0 Q0 0 0 7 Q0 14 6 14 Q12 14 12 7 Q12 0 6 0"},
    {9, "M0 0 L0 14 L5 14 Q9 14 9 10 Q9 6 5 6 L0 6"},
    {12, "M6 0 Q0 0 0 7 Q0 14 6 14 Q12 14 12 7 Q12 0 6 0 M8 3 L12 -1"},
    {10, "M0 0 L0 14 L5 14 Q9 14 9 10 Q9 6 5 6 L0 6 M5 6 L10 0"},
    {10, "M9 11 Q9 14 5 14 Q0 14 0 11 Q0 8 5 7 Q10 6 10 3 Q10 0 5 0 Q0 0 0 3"},
    {10, "M0 14 L10 14 M5 14 L5 0"},
    {10, "M0 14 L0 5 Q0 0 5 0 Q10 0 10 5 L10 14"},
    {10, "M0 14 L5 0 L10 14"},
    {16, "M0 14 L4 0 L8 12 L12 0 L16 14"},
    {9, "M0 0 L9 14 M0 14 L9 0"},
    {10, "M0 14 L5 7 L10 14 M5 7 L5 0"},
    {9, "M0 14 L9 14 L0 0 L9 0"},
    {3, "M3 16 L0 16 L0 -3 L3 -3"},
    {7, "M0 15 L7 -2"},
    {3, "M0 16 L3 16 L3 -3 L0 -3"},
    {8, "M0 9 L4 14 L8 9"},
    {8, "M0 -3 L8 -3"},
    {2, "M0 14 L2 11"},
    {8, "M8 10 L8 0 M8 5 Q8 10 4 10 Q0 10 0 5 Q0 0 4 0 Q8 0 8 5"},
    {8, "M0 14 L0 0 M0 5 Q0 10 4 10 Q8 10 8 5 Q8 0 4 0 Q0 0 0 5"},
    {8, "M8 8 Q7 10 5 10 Q0 10 0 5 Q0 0 5 0 Q7 0 8 2"},
    {8, "M8 14 L8 0 M8 5 Q8 10 4 10 Q0 10 0 5 Q0 0 4 0 Q8 0 8 5"},
    {8, "M0 5 L8 5 Q8 10 4 10 Q0 10 0 5 Q0 0 4 0 Q7 0 8 2"},
    {5, "M6 14 Q2 15 2 11 L2 0 M0 9 L5 9"},
    {8, "M8 10 L8 -1 Q8 -4 4 -4 Q1 -4 0 -3 M8 5 Q8 10 4 10 Q0 10 0 5 Q0 0 4 0 Q8 0 8 5"},
    {8, "M0 14 L0 0 M0 6 Q1 10 4 10 Q8 10 8 6 L8 0"},
    {0, "M0 0 L0 10 M0 13 L0 14"},
    {2, "M2 10 L2 -2 Q2 -4 0 -4 M2 13 L2 14"},
    {8, "M0 14 L0 0 M7 10 L0 4 M3 6 L8 0"},
    {0, "M0 14 L0 0"},
    {12, "M0 10 L0 0 M0 6 Q0 10 3 10 Q6 10 6 6 L6 0 M6 6 Q6 10 9 10 Q12 10 12 6 L12 0"},
    {8, "M0 10 L0 0 M0 6 Q1 10 4 10 Q8 10 8 6 L8 0"},
    {8, "M4 0 Q0 0 0 5 Q0 10 4 10 Q8 10 8 5 Q8 0 4 0"},
    {8, "M0 10 L0 -4 M0 5 Q0 10 4 10 Q8 10 8 5 Q8 0 4 0 Q0 0 0 5"},
    {8, "M8 10 L8 -4 M8 5 Q8 10 4 10 Q0 10 0 5 Q0 0 4 0 Q8 0 8 5"},
    {5, "M0 10 L0 0 M0 6 Q1 10 5 10"},
    {8, "M7 8 Q7 10 4 10 Q0 10 0 8 Q0 6 4 5 Q8 4 8 2 Q8 0 4 0 Q0 0 0 2"},
    {5, "M2 13 L2 3 Q2 0 5 0 M0 10 L5 10"},
    {8, "M0 10 L0 4 Q0 0 4 0 Q7 0 8 4 M8 10 L8 0"},
    {8, "M0 10 L4 0 L8 10"},
    {12, "M0 10 L3 0 L6 9 L9 0 L12 10"},
    {7, "M0 0 L7 10 M0 10 L7 0"},
    {8, "M0 10 L4 0 M8 10 L4 0 Q3 -4 0 -4"},
    {7, "M0 10 L7 10 L0 0 L7 0"},
    {4, "M4 16 Q2 16 2 13 L2 9 Q2 6 0 6 Q2 6 2 4 L2 0 Q2 -3 4 -3"},
    {0, "M0 16 L0 -3"},
    {4, "M0 16 Q2 16 2 13 L2 9 Q2 6 4 6 Q2 6 2 4 L2 0 Q2 -3 0 -3"},
    {9, "M0 4 Q1 7 3 6 L6 4 Q8 3 9 6"},
}};
constexpr Glyph unknown = {8, "M0 0 L0 14 L8 14 L8 0 L0 0"};

Eigen::RowVector2d read_point(std::istringstream& path) {
    double x = 0, y = 0;
    path >> x >> y;
    return {x, y};
}

void append(const Glyph& glyph, double left, StrokedText& text) {
    constexpr double capital = 14;
    const auto place = [&](const Eigen::RowVector2d& p) {
        return Eigen::RowVector2d((p.x() + left) / capital, p.y() / capital);
    };
    std::istringstream path(glyph.path);
    Eigen::RowVector2d pen(0, 0);
    for (char command = 0; path >> command;) {
        const Eigen::RowVector2d next = read_point(path);
        if (command == 'M') text.strokes.emplace_back();
        if (command != 'Q') {
            text.strokes.back().push_back(place(next));
            pen = next;
            continue;
        }
        const Eigen::RowVector2d end = read_point(path);
        constexpr int steps = 8;
        for (int i = 1; i <= steps; ++i) {
            // A conic between parabola and quarter ellipse: rounder bowls than the plain quadratic.
            const double t = static_cast<double>(i) / steps, w = 0.75;
            const double a = (1 - t) * (1 - t), b = 2 * w * t * (1 - t), c = t * t;
            text.strokes.back().push_back(place((a * pen + b * next + c * end) / (a + b + c)));
        }
        pen = end;
    }
}

}  // namespace

StrokedText stroke_text(const std::string& text) {
    constexpr double space = 4;
    StrokedText result;
    double left = 0;
    for (const char c : text) {
        const bool known = c >= ' ' && c <= '~';
        const Glyph& glyph = known ? glyphs[static_cast<std::size_t>(c - ' ')] : unknown;
        append(glyph, left, result);
        left += glyph.width + space;
    }
    result.width = text.empty() ? 0 : (left - space) / 14;
    return result;
}

}  // namespace counterpart::render
