// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "io/gltf_document.hpp"

#include "io/byte_order.hpp"
#include "io/whole_file.hpp"

#include <counterpart/base/errors.hpp>

#include <algorithm>
#include <set>

#include <fmt/format.h>

namespace counterpart {
namespace {

constexpr std::string_view glb_magic = "glTF";

int base64_value(char c) {
    if (c >= 'A' && c <= 'Z') return c - 'A';
    if (c >= 'a' && c <= 'z') return c - 'a' + 26;
    if (c >= '0' && c <= '9') return c - '0' + 52;
    return c == '+' ? 62 : c == '/' ? 63 : -1;
}

std::string base64_decoded(const GltfDocument& document, std::string_view text) {
    std::string bytes;
    unsigned bits = 0;
    int n_bits = 0;
    for (const char c : text.substr(0, text.find('='))) {
        const int value = base64_value(c);
        if (value < 0) document.fail("a data URI is not valid base64");
        bits = (bits << 6U) | static_cast<unsigned>(value);
        n_bits += 6;
        if (n_bits < 8) continue;
        n_bits -= 8;
        bytes += static_cast<char>((bits >> static_cast<unsigned>(n_bits)) & 0xffU);
    }
    return bytes;
}

std::string percent_decoded(std::string_view text) {
    std::string result;
    const auto digit = [](char c) {
        const std::size_t value = std::string_view("0123456789abcdef").find(static_cast<char>(c | 0x20));
        return value == std::string_view::npos ? -1 : static_cast<int>(value);
    };
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '%' && i + 2 < text.size() && digit(text[i + 1]) >= 0 && digit(text[i + 2]) >= 0) {
            result += static_cast<char>(16 * digit(text[i + 1]) + digit(text[i + 2]));
            i += 2;
        } else {
            result += text[i];
        }
    }
    return result;
}

struct Glb {
    std::string_view json, binary;
    bool has_binary = false;
};

Glb split_glb(const GltfDocument& document, std::string_view bytes) {
    if (bytes.size() < 20) document.fail("the GLB header is cut off");
    const auto version = load_number<std::uint32_t>(bytes.data() + 4);
    if (version != 2) document.fail(fmt::format("glTF {} is not supported; convert it to glTF 2.0", version));
    if (load_number<std::uint32_t>(bytes.data() + 8) > bytes.size())
        document.fail("the file is shorter than its header says");
    Glb glb;
    for (std::size_t at = 12; at + 8 <= bytes.size();) {
        const std::size_t size = load_number<std::uint32_t>(bytes.data() + at);
        const std::string_view type = bytes.substr(at + 4, 4);
        if (size > bytes.size() - at - 8) document.fail("a chunk is longer than the file");
        const std::string_view data = bytes.substr(at + 8, size);
        if (type == "JSON" && glb.json.empty()) glb.json = data;
        if (type == std::string_view("BIN\0", 4) && !glb.has_binary) {
            glb.binary = data;
            glb.has_binary = true;
        }
        at += 8 + size;
    }
    if (glb.json.empty()) document.fail("the file has no JSON chunk");
    return glb;
}

std::string stated_version(const GltfJson& json) {
    if (!json.contains("asset") || !json["asset"].is_object() || !json["asset"].contains("version"))
        return "";
    const GltfJson& version = json["asset"]["version"];
    return version.is_string() ? version.get<std::string>() : version.dump();
}

void require_supported(const GltfDocument& document) {
    const std::string version = stated_version(document.json);
    if (!version.starts_with("2.")) {
        document.fail(version.empty()
                          ? "this is not glTF 2.0: it states no version"
                          : fmt::format("glTF {} is not supported; convert it to glTF 2.0", version));
    }
    // Only what changes how triangles are stored; the rest is about looks and is carried along.
    static const std::set<std::string> unreadable = {"KHR_draco_mesh_compression", "EXT_meshopt_compression",
                                                     "KHR_meshopt_compression"};
    if (!document.json.contains("extensionsRequired")) return;
    for (const GltfJson& extension : document.json["extensionsRequired"]) {
        if (unreadable.contains(extension.get<std::string>())) {
            document.fail(fmt::format("the extension {} is not supported; export without compression",
                                      extension.get<std::string>()));
        }
    }
}

std::string load_buffer(const GltfDocument& document, std::size_t i, const Glb& glb) {
    const GltfJson& buffer = document.element("buffers", static_cast<std::int64_t>(i));
    std::string bytes;
    if (buffer.contains("uri")) {
        bytes = load_uri(document, buffer["uri"].get<std::string>(), fmt::format("buffer {}", i));
    } else {
        if (i != 0 || !glb.has_binary) document.fail(fmt::format("buffer {} has no data", i));
        bytes = std::string(glb.binary);
    }
    const std::int64_t wanted = number_at(document, buffer, "byteLength", 0);
    if (wanted > static_cast<std::int64_t>(bytes.size()))
        document.fail(fmt::format("buffer {} has {} bytes where {} are announced", i, bytes.size(), wanted));
    return bytes;
}

}  // namespace

void GltfDocument::fail(const std::string& reason) const { throw IoError(name + ": " + reason); }

const GltfJson& GltfDocument::element(const char* list, std::int64_t index) const {
    if (index < 0 || index >= static_cast<std::int64_t>(count(list)))
        fail(fmt::format("there is no element {} in '{}'", index, list));
    return json[list][static_cast<std::size_t>(index)];
}

std::size_t GltfDocument::count(const char* list) const {
    if (!json.contains(list)) return 0;
    if (!json[list].is_array()) fail(fmt::format("'{}' is not a list", list));
    return json[list].size();
}

std::int64_t number_at(const GltfDocument& document, const GltfJson& object, const char* key,
                       std::int64_t otherwise) {
    if (!object.is_object()) document.fail(fmt::format("an object with '{}' was expected", key));
    const auto found = object.find(key);
    if (found == object.end()) return otherwise;
    // Some exporters write 12.0 for 12.
    const double value = found->is_number() ? found->get<double>() : -1;
    if (!(value >= 0 && value <= 9e15 && value == static_cast<double>(static_cast<std::int64_t>(value))))
        document.fail(fmt::format("'{}' must be a whole number of 0 or more", key));
    return static_cast<std::int64_t>(value);
}

std::string load_uri(const GltfDocument& document, const std::string& uri, const std::string& what) {
    if (!uri.starts_with("data:")) {
        const std::filesystem::path file = document.folder / percent_decoded(uri);
        std::error_code ignored;
        if (!std::filesystem::exists(file, ignored))
            document.fail(fmt::format("{} is missing: there is no file {}", what, file.string()));
        return read_whole_file(file);
    }
    const std::size_t data = uri.find(";base64,");
    if (data == uri.npos) document.fail(fmt::format("{}: the data URI is not base64", what));
    return base64_decoded(document, std::string_view(uri).substr(data + 8));
}

GltfDocument load_gltf(const std::filesystem::path& file) {
    GltfDocument document{file.string(), file.parent_path(), {}, {}};
    const std::string bytes = read_whole_file(file);
    Glb glb;
    if (bytes.starts_with(glb_magic))
        glb = split_glb(document, bytes);
    else
        glb.json = bytes;
    document.json = GltfJson::parse(glb.json, nullptr, false);
    if (document.json.is_discarded() || !document.json.is_object()) document.fail("the JSON is damaged");
    try {
        require_supported(document);
        for (std::size_t i = 0; i < document.count("buffers"); ++i)
            document.buffers.push_back(load_buffer(document, i, glb));
    } catch (const GltfJson::exception& error) {
        document.fail(fmt::format("the JSON is not glTF ({})", error.what()));
    }
    return document;
}

}  // namespace counterpart
