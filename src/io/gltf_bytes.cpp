// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "base/base64.hpp"
#include "io/byte_order.hpp"
#include "io/gltf_document.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include <fmt/format.h>

namespace counterpart::io {
namespace {

void append_component(std::string& bytes, double value, GltfComponent component) {
    switch (component) {
        case GltfComponent::u8:
            return append_number(bytes, static_cast<std::uint8_t>(value));
        case GltfComponent::u16:
            return append_number(bytes, static_cast<std::uint16_t>(value));
        case GltfComponent::u32:
            return append_number(bytes, static_cast<std::uint32_t>(value));
        case GltfComponent::f32:
            return append_number(bytes, static_cast<float>(value));
    }
}

std::string type_of_width(Eigen::Index width) {
    return width == 1 ? "SCALAR" : width == 16 ? "MAT4" : fmt::format("VEC{}", width);
}

void pad(std::string& bytes, std::size_t multiple, char filler) {
    bytes.resize((bytes.size() + multiple - 1) / multiple * multiple, filler);
}

std::string mime_type(const std::string& uri) {
    static const std::array<std::pair<std::string_view, std::string_view>, 5> types = {
        {{".png", "image/png"},
         {".jpg", "image/jpeg"},
         {".jpeg", "image/jpeg"},
         {".webp", "image/webp"},
         {".ktx2", "image/ktx2"}}};
    std::string lower = uri;
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    for (const auto& [ending, type] : types)
        if (lower.ends_with(ending)) return std::string(type);
    return "application/octet-stream";
}

// How much of a buffer means something: what it announces, or more where a view reaches further.
std::size_t used_size(const GltfDocument& document, std::size_t buffer) {
    const GltfJson& json = document.element("buffers", static_cast<std::int64_t>(buffer));
    std::int64_t size = number_at(document, json, "byteLength", 0);
    for (std::size_t i = 0; i < document.count("bufferViews"); ++i) {
        const GltfJson& view = document.json["bufferViews"][i];
        if (number_at(document, view, "buffer", 0) == static_cast<std::int64_t>(buffer))
            size = std::max(size, number_at(document, view, "byteOffset", 0) +
                                      number_at(document, view, "byteLength", 0));
    }
    return std::min(static_cast<std::size_t>(size), document.buffers[buffer].size());
}

// GLB has room for one buffer.
void merge_buffers(GltfDocument& document) {
    if (document.buffers.empty()) return;
    GltfJson& buffers = document.json["buffers"];
    std::vector<std::size_t> starts;
    std::string all;
    for (std::size_t i = 0; i < document.buffers.size(); ++i) {
        pad(all, i == 0 ? 1 : 8, '\0');
        starts.push_back(all.size());
        all.append(document.buffers[i], 0, used_size(document, i));
    }
    for (GltfJson& view : document.json["bufferViews"]) {
        const auto buffer = static_cast<std::size_t>(number_at(document, view, "buffer", 0));
        if (buffer == 0 || buffer >= starts.size()) continue;
        view["buffer"] = 0;
        view["byteOffset"] =
            number_at(document, view, "byteOffset", 0) + static_cast<std::int64_t>(starts[buffer]);
    }
    while (buffers.size() > 1) buffers.erase(buffers.size() - 1);
    buffers[0].erase("uri");
    buffers[0]["byteLength"] = all.size();
    document.buffers.resize(1);
    document.buffers[0] = std::move(all);
}

std::string glb_bytes(const GltfDocument& document) {
    std::string text = document.json.dump(-1, ' ', false, GltfJson::error_handler_t::replace), binary;
    if (!document.buffers.empty()) binary = document.buffers[0];
    pad(text, 4, ' ');
    pad(binary, 4, '\0');
    const std::size_t size = 20 + text.size() + (binary.empty() ? 0 : 8 + binary.size());
    if (size > std::numeric_limits<std::uint32_t>::max())
        document.fail("more than 4 GiB do not fit into a GLB file");
    std::string bytes = "glTF";
    append_number(bytes, std::uint32_t{2});
    append_number(bytes, static_cast<std::uint32_t>(size));
    append_number(bytes, static_cast<std::uint32_t>(text.size()));
    bytes += "JSON" + text;
    if (binary.empty()) return bytes;
    append_number(bytes, static_cast<std::uint32_t>(binary.size()));
    return bytes + std::string("BIN\0", 4) + binary;
}

}  // namespace

std::int64_t append_view(GltfDocument& document, std::string_view bytes) {
    if (document.buffers.empty()) {
        document.buffers.emplace_back();
        document.json["buffers"] = {{{"byteLength", 0}}};
    }
    std::string& buffer = document.buffers[0];
    GltfJson& json = document.json["buffers"][0];
    buffer.resize(used_size(document, 0));
    pad(buffer, 8, '\0');
    GltfJson& views = document.json["bufferViews"];
    views.push_back({{"buffer", 0}, {"byteOffset", buffer.size()}, {"byteLength", bytes.size()}});
    buffer += bytes;
    json["byteLength"] = buffer.size();
    return static_cast<std::int64_t>(views.size()) - 1;
}

std::int64_t append_accessor(GltfDocument& document, const Matrix& values, GltfComponent component,
                             GltfTarget target, bool bounds) {
    std::string bytes;
    for (Eigen::Index i = 0; i < values.rows(); ++i)
        for (Eigen::Index c = 0; c < values.cols(); ++c) append_component(bytes, values(i, c), component);
    const std::int64_t view = append_view(document, bytes);
    if (target != GltfTarget::none)
        document.json["bufferViews"][static_cast<std::size_t>(view)]["target"] = static_cast<int>(target);
    GltfJson accessor = {{"bufferView", view},
                         {"componentType", static_cast<int>(component)},
                         {"count", values.rows()},
                         {"type", type_of_width(values.cols())}};
    if (bounds) {
        for (Eigen::Index c = 0; c < values.cols(); ++c) {
            // Of the numbers as stored.
            accessor["min"].push_back(static_cast<double>(static_cast<float>(values.col(c).minCoeff())));
            accessor["max"].push_back(static_cast<double>(static_cast<float>(values.col(c).maxCoeff())));
        }
    }
    GltfJson& accessors = document.json["accessors"];
    accessors.push_back(std::move(accessor));
    return static_cast<std::int64_t>(accessors.size()) - 1;
}

void take_images_in(GltfDocument& document) {
    std::map<std::filesystem::path, std::int64_t> views;
    for (std::size_t i = 0; i < document.count("images"); ++i) {
        GltfJson& image = document.json["images"][i];
        if (!image.is_object() || !image.contains("uri")) continue;
        const auto uri = image["uri"].get<std::string>();
        const std::string what = fmt::format("the texture image {}", i);
        const GltfUri parsed = parse_uri(document, uri, what);
        if (parsed.kind != GltfUri::Kind::file) continue;
        const auto [view, is_new] = views.try_emplace(parsed.file.lexically_normal(), 0);
        if (is_new) view->second = append_view(document, load_uri(document, uri, what));
        if (!image.contains("mimeType")) image["mimeType"] = mime_type(uri);
        image["bufferView"] = view->second;
        image.erase("uri");
    }
}

std::string gltf_bytes(GltfDocument document, bool binary) {
    take_images_in(document);
    merge_buffers(document);
    if (binary) return glb_bytes(document);
    if (!document.buffers.empty()) {
        document.json["buffers"][0]["uri"] =
            "data:application/octet-stream;base64," + to_base64(document.buffers[0]);
    }
    return document.json.dump(2, ' ', false, GltfJson::error_handler_t::replace) + "\n";
}

}  // namespace counterpart::io
