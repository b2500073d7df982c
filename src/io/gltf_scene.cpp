// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "io/gltf_scene.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace counterpart::io {
namespace {

Eigen::Affine3d local_transform(const GltfDocument& document, const GltfJson& node) {
    const auto numbers = [&](const char* key, std::vector<double> otherwise) {
        if (!node.contains(key)) return otherwise;
        auto values = node[key].get<std::vector<double>>();
        if (values.size() != otherwise.size())
            document.fail(fmt::format("a node's '{}' has the wrong length", key));
        return values;
    };
    Eigen::Affine3d transform = Eigen::Affine3d::Identity();
    if (node.contains("matrix")) {
        const auto m = numbers("matrix", std::vector<double>(16, 0));
        transform.matrix() = Eigen::Map<const Eigen::Matrix4d>(m.data());
        return transform;
    }
    const auto t = numbers("translation", {0, 0, 0}), r = numbers("rotation", {0, 0, 0, 1}),
               s = numbers("scale", {1, 1, 1});
    transform.translate(Eigen::Vector3d(t[0], t[1], t[2]));
    transform.rotate(Eigen::Quaterniond(r[3], r[0], r[1], r[2]).normalized());
    transform.scale(Eigen::Vector3d(s[0], s[1], s[2]));
    return transform;
}

struct Visit {
    std::int64_t node;
    Eigen::Affine3d parent;
};

// The nodes of a list as they are to be taken from a stack's end.
void push_nodes(const GltfDocument& document, const GltfJson& list, const Eigen::Affine3d& parent,
                std::vector<Visit>& stack) {
    for (auto node = list.rbegin(); node != list.rend(); ++node)
        stack.push_back({whole_number(document, *node, "a node"), parent});
}

}  // namespace

std::vector<ShownMesh> shown_meshes(const GltfDocument& document) {
    std::vector<ShownMesh> shown;
    std::vector<char> visited(document.count("nodes"), 0);
    std::vector<Visit> stack;
    if (document.count("scenes") > 0) {
        const GltfJson& scene = document.element("scenes", number_at(document, document.json, "scene", 0));
        if (scene.contains("nodes")) push_nodes(document, scene["nodes"], Eigen::Affine3d::Identity(), stack);
    }
    while (!stack.empty()) {
        const Visit visit = stack.back();
        stack.pop_back();
        const GltfJson& node = document.element("nodes", visit.node);
        if (visited[static_cast<std::size_t>(visit.node)]++) document.fail("the nodes do not form a tree");
        const Eigen::Affine3d transform = visit.parent * local_transform(document, node);
        if (node.contains("mesh")) {
            const std::int64_t mesh = number_at(document, node, "mesh", 0);
            document.element("meshes", mesh);
            shown.push_back(
                {visit.node, mesh, node.contains("skin") ? Eigen::Affine3d::Identity() : transform});
        }
        if (node.contains("children")) push_nodes(document, node["children"], transform, stack);
    }
    return shown;
}

}  // namespace counterpart::io
