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
    std::string name;  ///< the file, for messages
    GltfJson json;
    std::vector<std::string> buffers;

    [[noreturn]] void fail(const std::string& reason) const;
    /// Element `index` of a top-level list ("accessors", ...); fails by name if there is none.
    const GltfJson& element(const char* list, std::int64_t index) const;
    std::size_t count(const char* list) const;
};

/// Parses the file and loads its buffers. Throws IoError.
GltfDocument load_gltf(const std::filesystem::path& file);

/// A non-negative whole number under `key`; `otherwise` if absent.
std::int64_t number_at(const GltfDocument& document, const GltfJson& object, const char* key,
                       std::int64_t otherwise);

/// The rows of an accessor as doubles; normalized integers become fractions, sparse entries are put in. Fails
/// unless its type is one of `types` ("SCALAR VEC3 ...").
Matrix read_accessor(const GltfDocument& document, std::int64_t index, std::string_view types);

}  // namespace counterpart
