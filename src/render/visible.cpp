// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "render/tracer.hpp"

#include <counterpart/render/visible.hpp>

namespace counterpart::render {

std::vector<char> visible_triangles(MeshView mesh, const Camera& view) {
    require_valid(mesh);
    Scene scene;
    scene.surfaces.push_back({Placement(mesh, view)(mesh), Points::Zero(mesh.n_vertices(), 3), {}});
    const TriangleMesh& placed = scene.surfaces[0].mesh;
    const Tracer tracer(scene);
    std::vector<char> visible;
    for (Index t = 0; t < mesh.n_triangles(); ++t) {
        Eigen::RowVector3d middle = Eigen::RowVector3d::Zero();
        for (int c = 0; c < 3; ++c) middle += placed.vertices.row(placed.triangles(t, c)) / 3;
        const Tracer::Hit hit = tracer.look(middle.x(), middle.y());
        visible.push_back(hit.primitive == static_cast<std::uint32_t>(t) && !hit.inside &&
                                  hit.object != Tracer::nothing
                              ? 1
                              : 0);
    }
    return visible;
}

}  // namespace counterpart::render
