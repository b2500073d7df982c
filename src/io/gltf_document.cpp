// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "io/gltf_document.hpp"

#include "io/byte_order.hpp"
#include "platform/files.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/io/file.hpp>

#include <algorithm>
#include <set>

#include <fmt/format.h>

namespace counterpart::io {
namespace {

constexpr std::string_view glb_magic = "glTF";

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

bool names(const GltfJson& json, const std::string& extension) {
    return json.contains("extensions") && json["extensions"].contains(extension);
}

// Whether something is stored in that way only: a primitive whose positions are nowhere else, or a buffer.
bool is_needed(const GltfDocument& document, const std::string& extension) {
    const auto list = [](const GltfJson& json, const char* key) {
        return json.contains(key) ? json[key] : GltfJson::array();
    };
    for (const GltfJson& mesh : list(document.json, "meshes")) {
        for (const GltfJson& primitive : list(mesh, "primitives")) {
            if (!names(primitive, extension) || !primitive.contains("attributes")) continue;
            const std::int64_t positions = number_at(document, primitive["attributes"], "POSITION", -1);
            if (positions >= 0 && !document.element("accessors", positions).contains("bufferView"))
                return true;
        }
    }
    for (const GltfJson& buffer : list(document.json, "buffers"))
        if (names(buffer, extension) && !buffer.contains("uri")) return true;
    return false;
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
    for (const char* list : {"extensionsRequired", "extensionsUsed"}) {
        if (!document.json.contains(list)) continue;
        const bool is_required = list == std::string_view("extensionsRequired");
        for (const GltfJson& extension : document.json[list])
            if (unreadable.contains(extension.get<std::string>()) &&
                (is_required || is_needed(document, extension.get<std::string>())))
                document.fail(fmt::format("the extension {} is not supported; export without compression",
                                          extension.get<std::string>()));
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

// One file cannot be asked for many times.
void load_buffers(GltfDocument& document, const Glb& glb) {
    std::set<std::filesystem::path> files;
    for (std::size_t i = 0; i < document.count("buffers"); ++i) {
        const GltfJson& json = document.element("buffers", static_cast<std::int64_t>(i));
        const std::string what = fmt::format("buffer {}", i);
        if (json.contains("uri")) {
            const GltfUri uri = parse_uri(document, json["uri"].get<std::string>(), what);
            std::error_code ignored;
            if (uri.kind == GltfUri::Kind::file &&
                !files.insert(std::filesystem::weakly_canonical(uri.file, ignored)).second)
                document.fail(fmt::format("{} is the file of another buffer", what));
        }
        document.buffers.push_back(load_buffer(document, i, glb));
    }
}

// Images are read when the document is written; whether they may be is said at once.
void check_images(const GltfDocument& document) {
    for (std::size_t i = 0; i < document.count("images"); ++i) {
        const GltfJson& image = document.element("images", static_cast<std::int64_t>(i));
        if (image.is_object() && image.contains("uri"))
            parse_uri(document, image["uri"].get<std::string>(), fmt::format("the texture image {}", i));
    }
}

// Copying and writing JSON recurse into it, and finding a key takes time in proportion to their number: both
// are bounded here, far above what glTF needs.
GltfJson parse_json(const GltfDocument& document, std::string_view text) {
    constexpr std::size_t most_levels = 64, most_keys = 4096;
    std::vector<std::size_t> n_keys(most_levels + 2, 0);  // of the object that is open at each level
    const auto check = [&](int depth, GltfJson::parse_event_t event, const GltfJson&) {
        const auto level = static_cast<std::size_t>(depth);
        if (level > most_levels) document.fail(fmt::format("the JSON is nested deeper than {}", most_levels));
        if (event == GltfJson::parse_event_t::object_start) n_keys[level + 1] = 0;
        if (event == GltfJson::parse_event_t::key && ++n_keys[level] > most_keys)
            document.fail(fmt::format("a JSON object has more than {} keys", most_keys));
        return true;
    };
    GltfJson json = GltfJson::parse(text, check, false);
    if (json.is_discarded() || !json.is_object()) document.fail("the JSON is damaged");
    return json;
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

std::int64_t whole_number(const GltfDocument& document, const GltfJson& json, std::string_view what) {
    // Some exporters write 12.0 for 12.
    const double value = json.is_number() ? json.get<double>() : -1;
    if (!(value >= 0 && value <= 9e15 && value == static_cast<double>(static_cast<std::int64_t>(value))))
        document.fail(fmt::format("{} must be a whole number of 0 or more", what));
    return static_cast<std::int64_t>(value);
}

std::int64_t number_at(const GltfDocument& document, const GltfJson& object, const char* key,
                       std::int64_t otherwise) {
    if (!object.is_object()) document.fail(fmt::format("an object with '{}' was expected", key));
    const auto found = object.find(key);
    if (found == object.end()) return otherwise;
    return whole_number(document, *found, fmt::format("'{}'", key));
}

GltfBudget::GltfBudget(const GltfDocument& document) : name_(document.name) {
    std::size_t bytes = document.file_size;
    for (const std::string& buffer : document.buffers) bytes += buffer.size();
    // A number takes a byte or more, and some files name one accessor in many primitives.
    constexpr std::int64_t least = 1 << 22, numbers_per_byte = 64;
    left_ = std::max(least, numbers_per_byte * static_cast<std::int64_t>(bytes));
}

void GltfBudget::take(std::int64_t rows, std::int64_t columns) {
    if (columns > 0 && rows > left_ / columns)
        throw IoError(
            fmt::format("{}: it asks for far more numbers than a file of its size can mean", name_));
    left_ -= rows * columns;
}

GltfDocument parse_gltf(std::string_view bytes, const std::filesystem::path& file,
                        const ReadOptions& options) {
    GltfDocument document{platform::utf8_name(file), file.parent_path(), options, bytes.size(), {}, {}};
    Glb glb;
    if (bytes.starts_with(glb_magic))
        glb = split_glb(document, bytes);
    else
        glb.json = bytes;
    document.json = parse_json(document, glb.json);
    try {
        require_supported(document);
        load_buffers(document, glb);
        check_images(document);
    } catch (const GltfJson::exception& error) {
        document.fail(fmt::format("the JSON is not glTF ({})", error.what()));
    }
    return document;
}

GltfDocument load_gltf(const std::filesystem::path& file, const ReadOptions& options) {
    return parse_gltf(read_whole_file(file), file, options);
}

}  // namespace counterpart::io
