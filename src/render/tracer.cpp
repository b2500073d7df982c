// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "render/tracer.hpp"

#include "mesh/surface_box.hpp"
#include "render/ray_tree.hpp"

#include <counterpart/mesh/measure.hpp>

#include <algorithm>
#include <limits>
#include <utility>

namespace counterpart::render {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

Eigen::Vector3f point(const Eigen::RowVector3d& at) { return at.transpose().cast<float>(); }

// Surfaces, dots and, where they are asked for, tubes.
std::vector<Shape> shapes_of(const Scene& scene, bool with_tubes) {
    std::vector<Shape> shapes;
    for (const Surface& surface : scene.surfaces) {
        const MeshView mesh = surface.mesh;
        const auto corner = [&](Index t, int k) { return point(mesh.vertices.row(mesh.triangles(t, k))); };
        for (Index t = 0; t < mesh.n_triangles(); ++t)
            shapes.push_back({corner(t, 0), corner(t, 1), corner(t, 2)});
    }
    for (const Dot& dot : scene.dots) {
        shapes.push_back({point(dot.center), point(dot.center), point(dot.center)});
        shapes.back().radius = static_cast<float>(dot.radius);
    }
    if (!with_tubes) return shapes;
    for (const Tube& tube : scene.tubes) {
        shapes.push_back({point(tube.from), point(tube.to), point(tube.to)});
        shapes.back().radius = static_cast<float>(tube.radius);
    }
    return shapes;
}

}  // namespace

struct Tracer::Data {
    const Scene& scene;
    RayTree visible, solid;            // solid: what casts shadows, where that is another
    std::vector<std::uint32_t> first;  // shape of each surface, of the dots, of the tubes
    std::vector<Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor>> normals;
    float top = 0, size = 0;

    explicit Data(const Scene& what)
        : scene(what),
          visible(shapes_of(what, true)),
          solid(what.tubes.empty() ? std::vector<Shape>() : shapes_of(what, false)) {
        first.push_back(0);
        for (const Surface& surface : scene.surfaces) {
            const MeshView mesh = surface.mesh;
            first.push_back(first.back() + static_cast<std::uint32_t>(mesh.n_triangles()));
            normals.push_back(vertex_normals(mesh).cast<float>());
            size =
                std::max(size, static_cast<float>(counterpart::mesh::surface_box(mesh).sizes().maxCoeff()));
        }
        first.push_back(first.back() + static_cast<std::uint32_t>(scene.dots.size()));
        const Eigen::AlignedBox3f& box = visible.box();
        if (box.isEmpty()) return;
        top = box.max().z() + 1;
        if (scene.surfaces.empty()) size = box.sizes().head<2>().maxCoeff();
    }

    Eigen::Vector3f smooth_normal(const Hit& hit, const Eigen::Vector3f& flat) const {
        if (hit.object >= normals.size()) return flat;
        const auto corners = scene.surfaces[hit.object].mesh.triangles.row(hit.primitive);
        const auto& normal = normals[hit.object];
        const Eigen::Vector3f smooth = (1 - hit.u - hit.v) * normal.row(corners[0]) +
                                       hit.u * normal.row(corners[1]) + hit.v * normal.row(corners[2]);
        const float length = smooth.norm();
        return length > 1e-6F ? Eigen::Vector3f(smooth / length) : flat;
    }
};

Tracer::Tracer(const Scene& scene) : data_(std::make_unique<Data>(scene)) {}
Tracer::~Tracer() = default;
Tracer::Tracer(Tracer&&) noexcept = default;
Tracer& Tracer::operator=(Tracer&&) noexcept = default;

Tracer::Hit Tracer::look(double x, double y) const {
    const Eigen::Vector3f origin(static_cast<float>(x), static_cast<float>(y), data_->top);
    const auto met = data_->visible.first({origin, -Eigen::Vector3f::UnitZ(), 0, infinity});
    Hit hit;
    if (!met) return hit;
    const auto after = std::upper_bound(data_->first.begin(), data_->first.end(), met->shape);
    hit.object = static_cast<std::uint32_t>(after - data_->first.begin() - 1);
    hit.primitive = met->shape - *(after - 1);
    hit.u = met->u, hit.v = met->v;
    hit.position = origin - Eigen::Vector3f(0, 0, met->t);
    Eigen::Vector3f flat = met->normal.normalized();
    hit.normal = data_->smooth_normal(hit, flat);
    if (flat.z() < 0) {
        hit.inside = hit.object < data_->normals.size();
        flat = -flat, hit.normal = -hit.normal;
    }
    // Near the silhouette interpolation can turn the normal away from the viewer.
    if (hit.normal.z() < 0.02F)
        hit.normal = Eigen::Vector3f(hit.normal.x(), hit.normal.y(), 0.02F).normalized();
    return hit;
}

bool Tracer::blocked(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction, float near,
                     float far) const {
    const RayTree& tree = data_->scene.tubes.empty() ? data_->visible : data_->solid;
    return tree.meets_any({origin, direction, near, far});
}

Color Tracer::color(const Hit& hit) const {
    const Scene& scene = data_->scene;
    if (hit.object == scene.surfaces.size()) return scene.dots[hit.primitive].color;
    if (hit.object > scene.surfaces.size()) return scene.tubes[hit.primitive].color;
    const Surface& surface = scene.surfaces[hit.object];
    const auto corners = surface.mesh.triangles.row(hit.primitive);
    const double u = static_cast<double>(hit.u), v = static_cast<double>(hit.v);
    const Eigen::RowVector3d attribute = (1 - u - v) * surface.attributes.row(corners[0]) +
                                         u * surface.attributes.row(corners[1]) +
                                         v * surface.attributes.row(corners[2]);
    return surface.color ? surface.color(attribute) : attribute;
}

float Tracer::object_size() const { return data_->size; }

}  // namespace counterpart::render
