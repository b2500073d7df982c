// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "io/gltf_morph_weights.hpp"

#include <algorithm>
#include <utility>

namespace counterpart::io {
namespace {

// The nodes that show a mesh.
std::vector<std::int64_t> nodes_of(const GltfDocument& document, std::size_t mesh) {
    std::vector<std::int64_t> nodes;
    for (std::size_t i = 0; i < document.count("nodes"); ++i) {
        const GltfJson& node = document.json["nodes"][i];
        if (number_at(document, node, "mesh", -1) == static_cast<std::int64_t>(mesh))
            nodes.push_back(static_cast<std::int64_t>(i));
    }
    return nodes;
}

std::size_t morph_count(const GltfJson& mesh) {
    const GltfJson& primitive = mesh["primitives"][0];
    return primitive.contains("targets") ? primitive["targets"].size() : 0;
}

}  // namespace

void forget_morph_weights(GltfDocument& document, std::size_t mesh) {
    GltfJson& json = document.json;
    json["meshes"][mesh].erase("weights");
    const std::vector<std::int64_t> nodes = nodes_of(document, mesh);
    for (const std::int64_t node : nodes) json["nodes"][static_cast<std::size_t>(node)].erase("weights");
    forget_weight_channels(document, nodes);
}

void forget_weight_channels(GltfDocument& document, const std::vector<std::int64_t>& nodes) {
    GltfJson& json = document.json;
    for (std::size_t i = 0; i < document.count("animations"); ++i) {
        GltfJson& channels = json["animations"][i]["channels"];
        GltfJson kept = GltfJson::array();
        for (const GltfJson& channel : channels) {
            const GltfJson& target = channel.at("target");
            const std::int64_t node = number_at(document, target, "node", -1);
            if (target.value("path", "") != "weights" ||
                !std::binary_search(nodes.begin(), nodes.end(), node))
                kept.push_back(channel);
        }
        channels = std::move(kept);
    }
    if (!json.contains("animations")) return;
    GltfJson animations = GltfJson::array();
    for (const GltfJson& animation : json["animations"])
        if (!animation["channels"].empty()) animations.push_back(animation);
    if (animations.empty())
        json.erase("animations");
    else
        json["animations"] = std::move(animations);
}

void play_morph_targets(GltfDocument& document, double frames_per_second) {
    GltfJson samplers = GltfJson::array(), channels = GltfJson::array();
    for (std::size_t m = 0; m < document.count("meshes"); ++m) {
        const std::size_t n = morph_count(document.json["meshes"][m]);
        if (n == 0) continue;
        forget_morph_weights(document, m);
        const auto rows = static_cast<Eigen::Index>(n);
        const Matrix times = Vector::LinSpaced(rows + 1, 0, static_cast<double>(n) / frames_per_second);
        // All weights at the first time, then all at the second, ...: blend shape i is whole at time i + 1.
        Matrix weights = Matrix::Zero((rows + 1) * rows, 1);
        for (Eigen::Index i = 0; i < rows; ++i) weights((i + 1) * rows + i, 0) = 1;
        const std::int64_t input =
            append_accessor(document, times, GltfComponent::f32, GltfTarget::none, true);
        const std::int64_t output = append_accessor(document, weights, GltfComponent::f32, GltfTarget::none);
        for (const std::int64_t node : nodes_of(document, m))
            channels.push_back(
                {{"sampler", samplers.size()}, {"target", {{"node", node}, {"path", "weights"}}}});
        samplers.push_back({{"input", input}, {"interpolation", "LINEAR"}, {"output", output}});
    }
    if (channels.empty()) return;
    document.json["animations"].push_back(
        {{"name", "morph"}, {"channels", std::move(channels)}, {"samplers", std::move(samplers)}});
}

}  // namespace counterpart::io
