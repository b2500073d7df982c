// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// A glTF 2.0 file as its JSON and its buffers, with checked access to both.
//
// It works on the JSON itself, not on a library's model of it: what the program does not know (extensions,
// extras, materials) then stays as it was, and every message can name the element.
#pragma once

#include <counterpart/base/types.hpp>
#include <counterpart/io/file.hpp>
#include <counterpart/mesh/attributed_mesh.hpp>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

namespace counterpart::io {

using GltfJson = nlohmann::ordered_json;

struct GltfDocument {
    std::string name;              ///< the file, for messages
    std::filesystem::path folder;  ///< that file names inside it count from
    ReadOptions options;
    std::size_t file_size = 0;  ///< in bytes
    GltfJson json;
    std::vector<std::string> buffers;

    [[noreturn]] void fail(const std::string& reason) const;
    /// Element `index` of a top-level list ("accessors", ...); fails by name if there is none.
    const GltfJson& element(const char* list, std::int64_t index) const;
    std::size_t count(const char* list) const;
};

/// What a mesh keeps of the glTF file that it is from.
class GltfContent final : public Document {
  public:
    explicit GltfContent(GltfDocument gltf) : gltf_(std::move(gltf)) {}
    const GltfDocument& gltf() const { return gltf_; }

    std::string to_bytes() const override;
    bool has_materials() const override;
    std::shared_ptr<const Document> without_materials() const override;
    std::shared_ptr<const Document> without_skeleton() const override;
    Assignment with_materials_of(const Document& source, const std::vector<Index>& parts,
                                 const std::vector<Index>& source_parts) const override;

  private:
    GltfDocument gltf_;
};

/// The glTF document that the mesh is from, or null.
const GltfDocument* gltf_of(const AttributedMesh& content);

struct GltfUri {
    enum class Kind { data, file, elsewhere } kind = Kind::data;
    std::filesystem::path file;  ///< whether it is there or not
};
/// What a URI names. Throws IoError for a file that the document's options do not allow; `what` leads the
/// message.
GltfUri parse_uri(const GltfDocument& document, const std::string& uri, const std::string& what);
/// The bytes that a URI names. Throws IoError.
std::string load_uri(const GltfDocument& document, const std::string& uri, const std::string& what);

/// Parses a file's bytes and loads its buffers; `file` tells the folder. Throws IoError.
GltfDocument parse_gltf(std::string_view bytes, const std::filesystem::path& file,
                        const ReadOptions& options = {});
/// The same, of the file.
GltfDocument load_gltf(const std::filesystem::path& file, const ReadOptions& options = {});

/// Bounds how many numbers are made of a document by the bytes that it has: a short file can name one
/// accessor thousands of times, or announce zeros that are stored nowhere.
class GltfBudget {
  public:
    explicit GltfBudget(const GltfDocument& document);
    /// Throws IoError if so many numbers are not left.
    void take(std::int64_t rows, std::int64_t columns);
    std::int64_t left() const { return left_; }

  private:
    std::string name_;
    std::int64_t left_ = 0;
};

/// A non-negative whole number; fails by `what` it should be if it is none.
std::int64_t whole_number(const GltfDocument& document, const GltfJson& json, std::string_view what);
/// A non-negative whole number under `key`; `otherwise` if absent.
std::int64_t number_at(const GltfDocument& document, const GltfJson& object, const char* key,
                       std::int64_t otherwise);

/// The rows of an accessor as doubles; normalized integers become fractions, sparse entries are put in. Fails
/// unless its type is one of `types` ("SCALAR VEC3 ...") and its rows are within the budget.
Matrix read_accessor(const GltfDocument& document, std::int64_t index, std::string_view types,
                     GltfBudget& budget);

/// The bytes of a buffer view. Throws IoError if it reaches beyond its buffer.
std::string view_bytes(const GltfDocument& document, std::int64_t view_number);

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

}  // namespace counterpart::io
