// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/render/scene.hpp>

#include <cstdint>
#include <memory>

namespace counterpart::render {

/// Finds what a ray hits. Safe to use from several threads.
class Tracer {
  public:
    explicit Tracer(const Scene& scene);
    ~Tracer();
    Tracer(Tracer&&) noexcept;
    Tracer& operator=(Tracer&&) noexcept;

    static constexpr std::uint32_t nothing = 0xffffffff;
    struct Hit {
        std::uint32_t object = nothing, primitive = 0;
        float u = 0, v = 0;
        Eigen::Vector3f position = Eigen::Vector3f::Zero();
        Eigen::Vector3f normal = Eigen::Vector3f::Zero();  ///< smooth, unit, toward the viewer
        bool inside = false;                               ///< the back of a surface
    };
    /// The first thing seen at (x, y) from z = infinity.
    Hit look(double x, double y) const;
    /// Whether a surface or dot lies between `near` and `far` along a unit direction.
    bool blocked(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction, float near,
                 float far) const;
    Color color(const Hit& hit) const;

    /// Largest side of the box around any one surface (around all, if there is none).
    float object_size() const;

  private:
    struct Data;
    std::unique_ptr<Data> data_;
};

}  // namespace counterpart::render
