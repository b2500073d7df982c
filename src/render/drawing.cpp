// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "render/stroke_font.hpp"

#include <counterpart/render/charts.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

namespace counterpart::render {
namespace {

constexpr double capital_per_size = 1 / 1.4;

double distance_to_segment(const Eigen::RowVector2d& p, const Eigen::RowVector2d& a,
                           const Eigen::RowVector2d& b) {
    const Eigen::RowVector2d ab = b - a;
    const double length2 = ab.squaredNorm();
    const double t = length2 > 0 ? std::clamp((p - a).dot(ab) / length2, 0.0, 1.0) : 0;
    return (p - a - t * ab).norm();
}

/// Draws shapes into an image; each shape covers a pixel to a share of 0 .. 1.
class Pen {
  public:
    explicit Pen(Image& image) : image_(image) {}

    void operator()(const Box& box) {
        const auto overlap = [](double low, double size, int pixel) {
            return std::clamp(std::min(low + size, pixel + 1.0) - std::max(low, pixel + 0.0), 0.0, 1.0);
        };
        for_each_pixel({box.left, box.top}, {box.left + box.width, box.top + box.height}, [&](int x, int y) {
            blend(x, y, box.color, overlap(box.left, box.width, x) * overlap(box.top, box.height, y));
        });
    }

    void operator()(const Polyline& line) {
        if (line.points.empty()) return;
        Eigen::RowVector2d low = line.points[0], high = low;
        for (const Eigen::RowVector2d& p : line.points) low = low.cwiseMin(p), high = high.cwiseMax(p);
        const Eigen::RowVector2d reach(line.width + 1, line.width + 1);
        low -= reach, high += reach;
        const int left = std::max(0, static_cast<int>(low.x())), top = std::max(0, static_cast<int>(low.y()));
        const int right = std::min(image_.width, static_cast<int>(high.x()) + 2);
        const int bottom = std::min(image_.height, static_cast<int>(high.y()) + 2);
        if (left >= right || top >= bottom) return;
        // The strongest coverage by any segment, so that joints are not darker.
        Matrix covered = Matrix::Zero(bottom - top, right - left);
        for (std::size_t i = 0; i < std::max<std::size_t>(1, line.points.size() - 1); ++i) {
            const Eigen::RowVector2d &a = line.points[i],
                                     &b = line.points[std::min(i + 1, line.points.size() - 1)];
            for_each_pixel(a.cwiseMin(b) - reach, a.cwiseMax(b) + reach, [&](int x, int y) {
                const double distance = distance_to_segment({x + 0.5, y + 0.5}, a, b);
                double& place = covered(y - top, x - left);
                place = std::max(place, std::clamp(0.5 * line.width + 0.5 - distance, 0.0, 1.0));
            });
        }
        for (int y = top; y < bottom; ++y)
            for (int x = left; x < right; ++x) blend(x, y, line.color, covered(y - top, x - left));
    }

    void operator()(const Text& text) {
        const StrokedText stroked = stroke_text(text.text);
        const double scale = text.size * capital_per_size;
        for (const auto& stroke : stroked.strokes) {
            Polyline line{{}, text.color, std::max(1.1, 0.075 * text.size)};
            for (const Eigen::RowVector2d& p : stroke) {
                const double along = scale * (p.x() - text.anchor * stroked.width), up = scale * p.y();
                line.points.push_back(text.at + (text.upward ? Eigen::RowVector2d(-up, -along)
                                                             : Eigen::RowVector2d(along, -up)));
            }
            (*this)(line);
        }
    }

  private:
    template <class Body>
    void for_each_pixel(const Eigen::RowVector2d& low, const Eigen::RowVector2d& high, const Body& body) {
        const int left = std::max(0, static_cast<int>(std::floor(low.x())));
        const int top = std::max(0, static_cast<int>(std::floor(low.y())));
        const int right = std::min(image_.width, static_cast<int>(std::floor(high.x())) + 1);
        const int bottom = std::min(image_.height, static_cast<int>(std::floor(high.y())) + 1);
        for (int y = top; y < bottom; ++y)
            for (int x = left; x < right; ++x) body(x, y);
    }
    void blend(int x, int y, const Color& color, double share) {
        if (share > 0) image_.set(x, y, (1 - share) * image_.at(x, y) + share * color);
    }

    Image& image_;
};

std::string hex(const Color& color) {
    const auto byte = [&](int c) { return std::lround(255 * std::clamp(color[c], 0.0, 1.0)); };
    return fmt::format("#{:02x}{:02x}{:02x}", byte(0), byte(1), byte(2));
}

std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : text) {
        switch (c) {
            case '&':
                result += "&amp;";
                break;
            case '<':
                result += "&lt;";
                break;
            case '>':
                result += "&gt;";
                break;
            default:
                result += c;
        }
    }
    return result;
}

struct SvgWriter {
    std::string& out;

    void operator()(const Box& box) const {
        fmt::format_to(std::back_inserter(out),
                       "<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" fill=\"{}\"/>\n",
                       box.left, box.top, box.width, box.height, hex(box.color));
    }
    void operator()(const Polyline& line) const {
        out += "<polyline points=\"";
        for (const Eigen::RowVector2d& p : line.points)
            fmt::format_to(std::back_inserter(out), "{:.2f},{:.2f} ", p.x(), p.y());
        fmt::format_to(std::back_inserter(out),
                       "\" fill=\"none\" stroke=\"{}\" stroke-width=\"{:.2f}\" stroke-linejoin=\"round\" "
                       "stroke-linecap=\"round\"/>\n",
                       hex(line.color), line.width);
    }
    void operator()(const Text& text) const {
        const char* anchor = text.anchor < 0.25 ? "start" : text.anchor > 0.75 ? "end" : "middle";
        const std::string turn =
            text.upward ? fmt::format(" transform=\"rotate(-90 {:.2f} {:.2f})\"", text.at.x(), text.at.y())
                        : "";
        fmt::format_to(
            std::back_inserter(out),
            "<text x=\"{:.2f}\" y=\"{:.2f}\" font-size=\"{:.1f}\" fill=\"{}\" text-anchor=\"{}\"{}>{}"
            "</text>\n",
            text.at.x(), text.at.y(), text.size, hex(text.color), anchor, turn, escaped(text.text));
    }
};

}  // namespace

void draw(const Drawing& drawing, Image& image) {
    Pen pen(image);
    for (const auto& shape : drawing.shapes) std::visit(pen, shape);
}

std::string to_svg(const Drawing& drawing) {
    std::string out = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
        "font-family=\"Helvetica, Arial, 'DejaVu Sans', sans-serif\">\n"
        "<rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n",
        drawing.width, drawing.height);
    for (const auto& shape : drawing.shapes) std::visit(SvgWriter{out}, shape);
    return out + "</svg>\n";
}

double text_width(const std::string& text, double size) {
    return stroke_text(text).width * size * capital_per_size;
}

}  // namespace counterpart::render
