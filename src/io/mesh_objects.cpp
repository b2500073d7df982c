// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include <counterpart/io/mesh_objects.hpp>

#include <numeric>

namespace counterpart {
namespace {

// The triangles object by object; those of object k begin at the k-th of the other numbers.
struct Grouped {
    std::vector<Index> triangles, first;
};
Grouped grouped(const MeshObjects& objects) {
    Grouped result{std::vector<Index>(objects.of_triangle.size()),
                   std::vector<Index>(objects.names.size() + 1, 0)};
    for (const Index object : objects.of_triangle) ++result.first[static_cast<std::size_t>(object) + 1];
    std::partial_sum(result.first.begin(), result.first.end(), result.first.begin());
    std::vector<Index> next = result.first;
    for (std::size_t t = 0; t < objects.of_triangle.size(); ++t) {
        Index& place = next[static_cast<std::size_t>(objects.of_triangle[t])];
        result.triangles[static_cast<std::size_t>(place++)] = static_cast<Index>(t);
    }
    return result;
}

}  // namespace

std::vector<MeshObject> mesh_objects(const AttributedMesh& content) {
    const MeshObjects& objects = content.objects;
    const TriangleMesh& mesh = content.mesh;
    if (objects.names.size() < 2)
        return {{objects.names.empty() ? "" : objects.names[0], mesh.n_vertices(), mesh.n_triangles()}};
    std::vector<MeshObject> list;
    std::vector<Index> last_object(static_cast<std::size_t>(mesh.n_vertices()), -1);  // that names the vertex
    const Grouped groups = grouped(objects);
    for (std::size_t k = 0; k < objects.names.size(); ++k) {
        MeshObject object{objects.names[k], 0, groups.first[k + 1] - groups.first[k]};
        for (Index i = groups.first[k]; i < groups.first[k + 1]; ++i) {
            for (const Index v : mesh.triangles.row(groups.triangles[static_cast<std::size_t>(i)])) {
                Index& last = last_object[static_cast<std::size_t>(v)];
                object.n_vertices += last != static_cast<Index>(k);
                last = static_cast<Index>(k);
            }
        }
        list.push_back(std::move(object));
    }
    for (std::size_t v = 0; v < objects.of_vertex.size(); ++v)
        if (last_object[v] < 0 && objects.of_vertex[v] >= 0)
            ++list[static_cast<std::size_t>(objects.of_vertex[v])].n_vertices;
    return list;
}

}  // namespace counterpart
