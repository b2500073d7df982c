// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "base/parallel.hpp"
#include "mesh/surface_box.hpp"
#include "render/light.hpp"
#include "render/tracer.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/render/scene.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

namespace counterpart::render {
namespace {

/// In image space. Rays are cast in single precision, in which products of lengths must not overflow.
constexpr double largest_coordinate = 1e15;

void require_in_range(double largest) {
    if (!(largest <= largest_coordinate))
        throw InvalidInput(
            "coordinates beyond 1e15 in image space cannot be drawn: a mesh is extremely thin, or a vertex "
            "extremely far away");
}

void require_valid(const Scene& scene, const RenderOptions& options) {
    if (scene.surfaces.empty() && scene.dots.empty() && scene.tubes.empty())
        throw InvalidInput("there is nothing to draw: the scene is empty");
    for (const Surface& surface : scene.surfaces) {
        counterpart::require_valid(surface.mesh);
        if (surface.attributes.rows() != surface.mesh.n_vertices())
            throw InvalidInput("a surface of " + std::to_string(surface.mesh.n_vertices()) +
                               " vertices needs as many attributes, not " +
                               std::to_string(surface.attributes.rows()));
        require_in_range(surface.mesh.vertices.cwiseAbs().maxCoeff());
    }
    for (const Dot& dot : scene.dots) require_in_range(dot.center.cwiseAbs().maxCoeff() + dot.radius);
    for (const Tube& tube : scene.tubes)
        require_in_range(tube.from.cwiseAbs().cwiseMax(tube.to.cwiseAbs()).maxCoeff() + tube.radius);
    if (!(options.margin >= 0 && options.margin <= 0.45))
        throw InvalidInput("the margin must be 0 to 0.45 of the image");
    if (options.bottom < 0 || options.right < 0 || 2 * options.bottom > options.height ||
        2 * options.right > options.width)
        throw InvalidInput("the space left at the bottom and right must be 0 to half of the image");
    if (options.occlusion_rays < 1 || options.occlusion_rays > 64)
        throw InvalidInput("the number of occlusion rays must be 1 to 64");
}

double to_linear(double x) { return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4); }
double to_screen(double x) { return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055; }

/// Linear light that a hit sends to the viewer.
Color shade(const Tracer& tracer, const Tracer::Hit& hit, const Light& light) {
    const double n_key = std::max(0.0F, hit.normal.dot(key_direction()));
    const double sky =
        0.62 + 0.28 * static_cast<double>(hit.normal.y()) + 0.10 * static_cast<double>(hit.normal.z());
    const double open = std::pow(static_cast<double>(light.sky), 1.2);
    const Eigen::Vector3f halfway = (key_direction() + Eigen::Vector3f::UnitZ()).normalized();
    const double gloss =
        std::pow(std::max(0.0F, hit.normal.dot(halfway)), 24) * static_cast<double>(light.key);
    Color color = tracer.color(hit).unaryExpr(&to_linear);
    if (hit.inside) color *= 0.55;  // the back of an open surface
    const double diffuse = 0.68 * open * sky + 0.68 * static_cast<double>(light.key) * n_key;
    return (diffuse * color).array() + 0.035 * gloss;
}

class Painter {
  public:
    Painter(const Scene& scene, const RenderOptions& options)
        : options_(options),
          frame_(fit(scene, options)),
          tracer_(scene),
          background_(options.background.unaryExpr(&to_linear)) {}

    Image paint() {
        Image image(options_.width, options_.height, options_.background);
        hits_.resize(n_pixels());
        for_each_row([&](int y) {
            for (int x = 0; x < options_.width; ++x) hits_[at(x, y)] = look(x + 0.5, y + 0.5);
        });
        report_progress(options_.progress, 0.1);
        lights_ = gather_light(tracer_, hits_, options_.width, options_.height, options_.occlusion_rays);
        report_progress(options_.progress, 0.7);
        std::vector<Color> colors(n_pixels(), background_);
        for_each_row([&](int y) {
            for (int x = 0; x < options_.width; ++x) {
                const Tracer::Hit& hit = hits_[at(x, y)];
                if (hit.object != Tracer::nothing) colors[at(x, y)] = shade(tracer_, hit, lights_[at(x, y)]);
            }
        });
        for_each_row([&](int y) {
            for (int x = 0; x < options_.width; ++x) {
                const Color color = is_edge(colors, x, y) ? average(x, y) : colors[at(x, y)];
                image.set(x, y, color.cwiseMax(0).cwiseMin(1).unaryExpr(&to_screen));
            }
        });
        report_progress(options_.progress, 1);
        return image;
    }

  private:
    std::size_t n_pixels() const {
        return static_cast<std::size_t>(options_.width) * static_cast<std::size_t>(options_.height);
    }
    std::size_t at(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(options_.width) +
               static_cast<std::size_t>(x);
    }
    template <class Body>
    void for_each_row(const Body& body) const {
        parallel_for(static_cast<std::size_t>(options_.height), 4,
                     [&](std::size_t row) { body(static_cast<int>(row)); });
    }
    Tracer::Hit look(double column, double row) const {
        return tracer_.look((column - frame_.origin.x()) / frame_.scale,
                            (frame_.origin.y() - row) / frame_.scale);
    }

    template <class Body>
    void for_each_neighbor(int x, int y, const Body& body) const {
        for (int row = std::max(0, y - 1); row <= std::min(options_.height - 1, y + 1); ++row)
            for (int column = std::max(0, x - 1); column <= std::min(options_.width - 1, x + 1); ++column)
                body(at(column, row));
    }

    /// Whether one ray is not enough: another object or a clearly other color next to it.
    bool is_edge(const std::vector<Color>& colors, int x, int y) const {
        const std::size_t here = at(x, y);
        bool edge = false;
        for_each_neighbor(x, y, [&](std::size_t there) {
            const double tolerance = 0.01 + 0.04 * colors[here].maxCoeff();
            edge = edge || hits_[there].object != hits_[here].object ||
                   (colors[there] - colors[here]).cwiseAbs().maxCoeff() > tolerance;
        });
        return edge;
    }

    /// Mean of 16 rays through the pixel, each lit as the most similar pixel around it.
    Color average(int x, int y) const {
        constexpr int side = 4;
        Color sum = Color::Zero();
        for (int i = 0; i < side * side; ++i) {
            const int column = i % side, row = i / side;
            const Tracer::Hit hit = look(x + (column + 0.5) / side, y + (row + 0.5) / side);
            sum += hit.object == Tracer::nothing ? background_ : shade(tracer_, hit, nearby_light(hit, x, y));
        }
        return sum / (side * side);
    }

    Light nearby_light(const Tracer::Hit& hit, int x, int y) const {
        Light best{0.8F, 0.8F};
        float least = std::numeric_limits<float>::infinity();
        for_each_neighbor(x, y, [&](std::size_t there) {
            if (hits_[there].object != hit.object) return;
            const float distance = (hits_[there].position - hit.position).squaredNorm();
            if (distance < least) least = distance, best = lights_[there];
        });
        return best;
    }

    const RenderOptions& options_;
    Frame frame_;
    Tracer tracer_;
    Color background_;
    Hits hits_;
    std::vector<Light> lights_;
};

}  // namespace

Frame fit(const Scene& scene, const RenderOptions& options) {
    require_valid(scene, options);
    Eigen::AlignedBox<double, 2> box;
    const auto extend = [&](const Eigen::RowVector3d& center, double radius) {
        const Eigen::Vector2d middle = center.head<2>().transpose(), reach(radius, radius);
        box.extend(Eigen::Vector2d(middle - reach)).extend(Eigen::Vector2d(middle + reach));
    };
    for (const Surface& surface : scene.surfaces) {
        const Eigen::AlignedBox3d bounds = mesh::surface_box(surface.mesh);
        extend(bounds.min().transpose(), 0);
        extend(bounds.max().transpose(), 0);
    }
    for (const Dot& dot : scene.dots) extend(dot.center, dot.radius);
    for (const Tube& tube : scene.tubes) {
        extend(tube.from, tube.radius);
        extend(tube.to, tube.radius);
    }
    const Eigen::Vector2d room((1 - 2 * options.margin) * options.width - options.right,
                               (1 - 2 * options.margin) * options.height - options.bottom);
    const Eigen::Vector2d size = box.sizes().cwiseMax(1e-30);
    Frame frame;
    frame.scale = std::max(1e-30, (room.array() / size.array()).minCoeff());
    frame.origin = {0.5 * (options.width - options.right) - frame.scale * box.center().x(),
                    0.5 * (options.height - options.bottom) + frame.scale * box.center().y()};
    return frame;
}

Image render(const Scene& scene, const RenderOptions& options) {
    require_valid(scene, options);
    return with_threads(options.n_threads, [&] { return Painter(scene, options).paint(); });
}

}  // namespace counterpart::render
