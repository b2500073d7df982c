// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// A glTF 2.0 file as its JSON and its buffers, with checked access to both.
//
// It works on the JSON itself, not on a library's model of it: what the program does not know (extensions,
// extras, materials) then stays as it was, and every message can name the element.
#pragma once

#include <counterpart/base/types.hpp>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

namespace counterpart {

using GltfJson = nlohmann::ordered_json;

struct GltfDocument {
    std::string name;              ///< the file, for messages
    std::filesystem::path folder;  ///< that file names inside it count from
    GltfJson json;
    std::vector<std::string> buffers;

    [[noreturn]] void fail(const std::string& reason) const;
    /// Element `index` of a top-level list ("accessors", ...); fails by name if there is none.
    const GltfJson& element(const char* list, std::int64_t index) const;
    std::size_t count(const char* list) const;
};

/// The bytes that a URI names: data in it, or a file in the document's folder. `what` is for messages. Throws
/// IoError.
std::string load_uri(const GltfDocument& document, const std::string& uri, const std::string& what);

/// Parses the file and loads its buffers. Throws IoError.
GltfDocument load_gltf(const std::filesystem::path& file);

/// A non-negative whole number under `key`; `otherwise` if absent.
std::int64_t number_at(const GltfDocument& document, const GltfJson& object, const char* key,
                       std::int64_t otherwise);

/// The rows of an accessor as doubles; normalized integers become fractions, sparse entries are put in. Fails
/// unless its type is one of `types` ("SCALAR VEC3 ...").
Matrix read_accessor(const GltfDocument& document, std::int64_t index, std::string_view types);

/// The component types that are written.
enum class GltfComponent { u8 = 5121, u16 = 5123, u32 = 5125, f32 = 5126 };
/// What a buffer view is for.
enum class GltfTarget { none = 0, vertices = 34962, indices = 34963 };

/// Appends an accessor for the rows of `values` (1, 2, 3, 4 or 16 columns), with its data in the first
/// buffer, and returns its number. `bounds` adds min and max.
std::int64_t append_accessor(GltfDocument& document, const Matrix& values, GltfComponent component,
                             GltfTarget target, bool bounds = false);

/// Appends a buffer view of the first buffer and returns its number.
std::int64_t append_view(GltfDocument& document, std::string_view bytes);

/// Images that lie beside the document become part of it. Throws IoError for one that is missing.
void take_images_in(GltfDocument& document);

/// The bytes of the file: one GLB, or one JSON text with its buffer inside. Images that lie beside the
/// document are taken in. Throws IoError, for an image that is missing too.
std::string gltf_bytes(GltfDocument document, bool binary);

}  // namespace counterpart
