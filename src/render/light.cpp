// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "render/light.hpp"

#include "base/parallel.hpp"

#include <cmath>
#include <numbers>

namespace counterpart::render {
namespace {

constexpr int tile = 4, n_tile = tile * tile;

/// Orthonormal basis around a unit vector (Duff et al. 2017).
Eigen::Matrix3f basis_around(const Eigen::Vector3f& n) {
    const float sign = std::copysign(1.0F, n.z());
    const float a = -1 / (sign + n.z()), b = n.x() * n.y() * a;
    Eigen::Matrix3f basis;
    basis.col(0) = Eigen::Vector3f(1 + sign * n.x() * n.x() * a, sign * b, -sign * n.x());
    basis.col(1) = Eigen::Vector3f(b, sign + n.y() * n.y() * a, -n.y());
    basis.col(2) = n;
    return basis;
}

/// Points of the unit disk, evenly spread (a golden-angle spiral), dealt to the pixels of a tile in turn.
std::vector<Eigen::Vector2f> disk_points(int rays) {
    constexpr double golden_angle = std::numbers::pi * (3 - 2.2360679774997896);
    const int count = rays * n_tile;
    std::vector<Eigen::Vector2f> points;
    for (int i = 0; i < count; ++i) {
        const double radius = std::sqrt((i + 0.5) / count), angle = i * golden_angle;
        points.emplace_back(static_cast<float>(radius * std::cos(angle)),
                            static_cast<float>(radius * std::sin(angle)));
    }
    return points;
}

class Gatherer {
  public:
    Gatherer(const Tracer& tracer, int rays)
        : tracer_(tracer), rays_(rays), sky_points_(disk_points(rays)), key_points_(disk_points(key_rays)) {
        reach_ = 0.3F * tracer.object_size();
        skip_ = 0.004F * tracer.object_size();
    }

    Light operator()(const Tracer::Hit& hit, int x, int y) const {
        // Rays start a little off the surface: the smooth normal is not that of the flat triangles.
        const Eigen::Vector3f origin = hit.position + 0.3F * skip_ * hit.normal;
        const int slot = (5 * (x % tile) + 7 * (y % tile) * tile) % n_tile;
        const Eigen::Matrix3f around = basis_around(hit.normal);
        float open = 0;
        for (int r = 0; r < rays_; ++r) {
            const Eigen::Vector2f& p = sky_points_[static_cast<std::size_t>(r * n_tile + slot)];
            const float up = std::sqrt(std::max(0.0F, 1 - p.squaredNorm()));  // lifted: cosine-weighted
            const Eigen::Vector3f direction = around * Eigen::Vector3f(p.x(), p.y(), up);
            if (!tracer_.blocked(origin, direction, skip_, reach_)) open += 1;
        }
        Light light{open / static_cast<float>(rays_), 0};
        if (hit.normal.dot(key_direction()) <= 0) return light;
        const Eigen::Matrix3f key = basis_around(key_direction());
        for (int r = 0; r < key_rays; ++r) {
            const Eigen::Vector2f p = 0.16F * key_points_[static_cast<std::size_t>(r * n_tile + slot)];
            const Eigen::Vector3f direction = (key * Eigen::Vector3f(p.x(), p.y(), 1)).normalized();
            if (!tracer_.blocked(origin, direction, skip_, 4 * reach_)) light.key += 1;
        }
        light.key /= static_cast<float>(key_rays);
        return light;
    }

  private:
    static constexpr int key_rays = 2;
    const Tracer& tracer_;
    int rays_;
    std::vector<Eigen::Vector2f> sky_points_, key_points_;
    float reach_ = 0, skip_ = 0;
};

/// Mean over the 4 x 4 pixels around (x, y) that lie on the same surface, close to its tangent plane.
Light shared(const std::vector<Light>& lights, const Hits& hits, int x, int y, int width, int height,
             float tolerance) {
    const auto at = [&](int column, int row) {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(column);
    };
    const Tracer::Hit& here = hits[at(x, y)];
    float sky = 0, key = 0, count = 0;
    for (int row = std::max(0, y - 1); row <= std::min(height - 1, y + 2); ++row) {
        for (int column = std::max(0, x - 1); column <= std::min(width - 1, x + 2); ++column) {
            const Tracer::Hit& there = hits[at(column, row)];
            if (there.object != here.object || there.normal.dot(here.normal) < 0.7F) continue;
            if (std::abs(here.normal.dot(there.position - here.position)) > tolerance) continue;
            const Light& light = lights[at(column, row)];
            sky += light.sky, key += light.key, count += 1;
        }
    }
    return {sky / count, key / count};
}

}  // namespace

std::vector<Light> gather_light(const Tracer& tracer, const Hits& hits, int width, int height, int rays) {
    const Gatherer gather(tracer, rays);
    std::vector<Light> noisy(hits.size()), smooth(hits.size());
    const auto for_each_hit = [&](const auto& body) {
        parallel_for(static_cast<std::size_t>(height), 4, [&](std::size_t row) {
            for (int x = 0; x < width; ++x) {
                const std::size_t i = row * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
                if (hits[i].object != Tracer::nothing) body(i, x, static_cast<int>(row));
            }
        });
    };
    for_each_hit([&](std::size_t i, int x, int y) { noisy[i] = gather(hits[i], x, y); });
    const float tolerance = 0.006F * tracer.object_size();
    for_each_hit([&](std::size_t i, int x, int y) {
        smooth[i] = shared(noisy, hits, x, y, width, height, tolerance);
    });
    return smooth;
}

}  // namespace counterpart::render
