// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include <counterpart/base/errors.hpp>
#include <counterpart/render/charts.hpp>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace counterpart::render {
namespace {

const Color ink(0.15, 0.15, 0.17), grid_ink(0.88, 0.88, 0.88), paper(1, 1, 1);

/// The rectangle between the axes, and what is drawn in it.
class Chart {
  public:
    Chart(const ChartOptions& options, double max_error)
        : text_(std::max(12.0, options.height / 36.0)), max_error_(max_error) {
        drawing_.width = options.width, drawing_.height = options.height;
        left_ = 5.2 * text_, top_ = 1.6 * text_;
        right_ = options.width - 2.2 * text_, bottom_ = options.height - 4.2 * text_;
    }

    Eigen::RowVector2d place(double error, double fraction) const {
        return {left_ + (right_ - left_) * error / max_error_, bottom_ - (bottom_ - top_) * fraction};
    }

    void draw_axes() {
        for (const double error : round_ticks(max_error_, 10)) {
            line({place(error, 0), place(error, 1)}, grid_ink, 1);
            write({place(error, 0) + Eigen::RowVector2d(0, 1.4 * text_), fmt::format("{:g}", error), text_,
                   ink, 0.5});
        }
        for (int percent = 0; percent <= 100; percent += 20) {
            line({place(0, percent / 100.0), place(max_error_, percent / 100.0)}, grid_ink, 1);
            write({place(0, percent / 100.0) + Eigen::RowVector2d(-0.6 * text_, 0.36 * text_),
                   fmt::format("{}", percent), text_, ink, 1});
        }
        line({place(0, 1), place(0, 0), place(max_error_, 0)}, ink, 0.09 * text_);
        write({{0.5 * (left_ + right_), bottom_ + 3.2 * text_},
               "geodesic error x 100 / sqrt(target area)",
               1.1 * text_,
               ink,
               0.5});
        write({{1.7 * text_, 0.5 * (top_ + bottom_)},
               "vertices within the error (%)",
               1.1 * text_,
               ink,
               0.5,
               true});
    }

    void draw_curve(const ErrorCurve& curve, const Color& color) {
        std::vector<Eigen::RowVector2d> points;
        for (std::size_t i = 0; i < curve.errors.size(); ++i) {
            if (curve.errors[i] > max_error_) {
                if (i == 0) break;
                const double part =
                    (max_error_ - curve.errors[i - 1]) / (curve.errors[i] - curve.errors[i - 1]);
                points.push_back(place(
                    max_error_, (1 - part) * curve.fraction_within[i - 1] + part * curve.fraction_within[i]));
                break;
            }
            points.push_back(place(curve.errors[i], curve.fraction_within[i]));
        }
        line(points, color, 0.16 * text_);
    }

    /// In the lower right corner, which the curves of good maps leave free.
    void draw_legend(const std::vector<ErrorCurve>& curves) {
        double width = 0;
        std::vector<std::string> labels;
        for (const ErrorCurve& curve : curves) {
            labels.push_back(std::isfinite(curve.mean)
                                 ? fmt::format("{} (mean {:.2f})", curve.label, curve.mean)
                                 : curve.label);
            width = std::max(width, text_width(labels.back(), text_));
        }
        const double row = 1.7 * text_, height = row * static_cast<double>(curves.size()) + 0.6 * text_;
        const double left = right_ - width - 5 * text_, top = bottom_ - height - text_;
        drawing_.shapes.emplace_back(Box{left, top, width + 4.2 * text_, height, {0.97, 0.97, 0.97}});
        for (std::size_t i = 0; i < curves.size(); ++i) {
            const double y = top + row * (static_cast<double>(i) + 0.5) + 0.3 * text_;
            line({{left + 0.7 * text_, y}, {left + 2.7 * text_, y}}, category_color(static_cast<int>(i)),
                 0.2 * text_);
            write({{left + 3.4 * text_, y + 0.36 * text_}, labels[i], text_, ink});
        }
    }

    Drawing take() { return std::move(drawing_); }

  private:
    void line(std::vector<Eigen::RowVector2d> points, const Color& color, double width) {
        drawing_.shapes.emplace_back(Polyline{std::move(points), color, width});
    }
    void write(Text text) { drawing_.shapes.emplace_back(std::move(text)); }

    Drawing drawing_;
    double text_, max_error_, left_ = 0, top_ = 0, right_ = 0, bottom_ = 0;
};

/// Mean of the finite entries of `matrix` that fall on pixel (x, y) of a side x side picture.
double pixel_value(const Matrix& matrix, int side, int x, int y) {
    const auto range = [side](Eigen::Index n, int pixel) {
        const Eigen::Index first = n * pixel / side, last = n * (pixel + 1) / side;
        return std::pair{first, std::max<Eigen::Index>(1, last - first)};
    };
    const auto [row, rows] = range(matrix.rows(), y);
    const auto [column, columns] = range(matrix.cols(), x);
    return matrix.block(row, column, rows, columns).mean();
}

double largest_finite(const Matrix& matrix) {
    return matrix.unaryExpr([](double x) { return std::isfinite(x) ? x : 0.0; }).maxCoeff();
}

}  // namespace

std::vector<double> round_ticks(double max, int most) {
    const double rough = max / most, power = std::pow(10, std::floor(std::log10(rough)));
    double step = 10 * power;
    for (const double factor : {5.0, 2.0, 1.0})
        if (factor * power >= rough * (1 - 1e-9)) step = factor * power;
    std::vector<double> ticks;
    for (int i = 0; i * step <= max * (1 + 1e-9); ++i) ticks.push_back(i * step);
    return ticks;
}

Drawing error_chart(const std::vector<ErrorCurve>& curves, const ChartOptions& options) {
    if (curves.empty()) throw InvalidInput("an error chart needs at least one curve");
    if (options.width < 300 || options.height < 200 || options.width > 16384 || options.height > 16384)
        throw InvalidInput("a chart must be at least 300 x 200 and at most 16384 pixels on a side");
    double max_error = options.max_error;
    if (!(max_error >= 0) || !std::isfinite(max_error))
        throw InvalidInput("the largest error of a chart must be 0 (automatic) or positive");
    for (const ErrorCurve& curve : curves) {
        if (curve.errors.empty() || curve.errors.size() != curve.fraction_within.size())
            throw InvalidInput("curve '" + curve.label + "' needs as many errors as fractions, at least one");
        if (options.max_error == 0) max_error = std::max(max_error, curve.errors.back());
    }
    Chart chart(options, max_error > 0 ? max_error : 1);
    chart.draw_axes();
    for (std::size_t i = curves.size(); i-- > 0;)
        chart.draw_curve(curves[i], category_color(static_cast<int>(i)));
    chart.draw_legend(curves);
    return chart.take();
}

void add_color_bar(Drawing& drawing, const ColorBar& bar) {
    const int steps = std::max(2, static_cast<int>(bar.width));
    for (int i = 0; i < steps; ++i)
        drawing.shapes.emplace_back(Box{bar.left + bar.width * i / steps, bar.top, bar.width / steps,
                                        bar.height, sample(bar.colormap, (i + 0.5) / steps)});
    for (const double tick : round_ticks(bar.max, 6)) {
        const double x = bar.left + bar.width * tick / bar.max, y = bar.top + bar.height;
        drawing.shapes.emplace_back(Polyline{{{x, y}, {x, y + 0.3 * bar.text_size}}, ink, 1.2});
        drawing.shapes.emplace_back(
            Text{{x, y + 1.25 * bar.text_size}, fmt::format("{:g}", tick), 0.8 * bar.text_size, ink, 0.5});
    }
    drawing.shapes.emplace_back(Text{{bar.left + 0.5 * bar.width, bar.top + bar.height + 2.5 * bar.text_size},
                                     bar.title,
                                     0.85 * bar.text_size,
                                     ink,
                                     0.5});
}

Image matrix_picture(const std::vector<Matrix>& matrices, const std::vector<std::string>& titles, int width,
                     int height) {
    if (matrices.empty() || titles.size() != matrices.size())
        throw InvalidInput("an image of matrices needs at least one matrix, and a title for each");
    double max = 0;
    for (const Matrix& matrix : matrices) {
        if (matrix.size() == 0) throw InvalidInput("an empty matrix cannot be drawn");
        max = std::max(max, largest_finite(matrix));
    }
    const auto n = static_cast<int>(matrices.size());
    const double text = std::max(12.0, height / 36.0);
    const int gap = static_cast<int>(1.5 * text), below = static_cast<int>(6.5 * text);
    const int side = std::min((width - (n + 1) * gap) / n, height - gap - below);
    if (side < 1) throw InvalidInput("the image is too small for " + std::to_string(n) + " matrices");
    Image image(width, height, paper);
    Drawing drawing{width, height, {}};
    const int left = (width - n * side - (n - 1) * gap) / 2;
    for (int k = 0; k < n; ++k) {
        const int start = left + k * (side + gap);
        for (int y = 0; y < side; ++y) {
            for (int x = 0; x < side; ++x) {
                const double value = pixel_value(matrices[static_cast<std::size_t>(k)], side, x, y);
                image.set(start + x, gap + y,
                          std::isfinite(value) ? sample(Colormap::viridis, max > 0 ? value / max : 0)
                                               : no_value_color());
            }
        }
        drawing.shapes.emplace_back(Text{{start + 0.5 * side, gap + side + 1.5 * text},
                                         titles[static_cast<std::size_t>(k)],
                                         text,
                                         ink,
                                         0.5});
    }
    if (max > 0)
        add_color_bar(drawing, {0.3 * width, gap + side + 2.6 * text, 0.4 * width, 0.8 * text,
                                Colormap::viridis, max, "geodesic distance (mesh units)", text});
    draw(drawing, image);
    return image;
}

}  // namespace counterpart::render
