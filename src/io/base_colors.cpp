// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "io/gltf_primitives.hpp"
#include "io/mtl.hpp"
#include "platform/files.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/io/mesh_file.hpp>

#include <map>
#include <utility>

#include <fmt/format.h>

namespace counterpart {

using namespace io;

namespace {

bool is_shown_by_browsers(std::string_view bytes) {
    return bytes.starts_with("\x89PNG") || bytes.starts_with("\xff\xd8\xff") ||
           (bytes.starts_with("RIFF") && bytes.substr(0, 12).ends_with("WEBP"));
}

std::string gltf_image(const GltfDocument& document, std::int64_t number) {
    const GltfJson& image = document.element("images", number);
    if (image.contains("bufferView"))
        return view_bytes(document, number_at(document, image, "bufferView", 0));
    return load_uri(document, image.value("uri", ""), fmt::format("image {}", number));
}

// The image of a primitive's base color; -1: none.
std::int64_t gltf_image_of(const GltfDocument& document, const GltfPrimitive& primitive) {
    const GltfJson& json = document.json["meshes"][primitive.mesh]["primitives"][primitive.number];
    const std::int64_t material = number_at(document, json, "material", -1);
    if (material < 0) return -1;
    const GltfJson& found = document.element("materials", material);
    const GltfJson colors = found.value("pbrMetallicRoughness", GltfJson::object());
    if (!colors.contains("baseColorTexture")) return -1;
    const GltfJson& texture =
        document.element("textures", number_at(document, colors["baseColorTexture"], "index", -1));
    if (texture.contains("source")) return number_at(document, texture, "source", -1);
    const GltfJson extensions = texture.value("extensions", GltfJson::object());
    return number_at(document, extensions.value("EXT_texture_webp", GltfJson::object()), "source", -1);
}

// Collects images, each once, by a key of its own.
template <typename Key>
class Collection {
  public:
    explicit Collection(BaseColors& colors) : colors_(colors) {}

    template <typename Load>
    Index number(const Key& key, const Load& load) {
        const auto [known, is_new] = numbers_.try_emplace(key, -1);
        if (!is_new) return known->second;
        try {
            std::string bytes = load();
            if (!is_shown_by_browsers(bytes)) {
                colors_.notices.push_back("an image that is no PNG, JPEG or WebP file is not shown");
                return -1;
            }
            colors_.images.push_back(std::move(bytes));
            return known->second = static_cast<Index>(colors_.images.size()) - 1;
        } catch (const IoError& error) {
            colors_.notices.push_back(fmt::format("an image is not shown: {}", error.what()));
            return -1;
        }
    }

  private:
    BaseColors& colors_;
    std::map<Key, Index> numbers_;
};

std::vector<Index> images_of_parts(const GltfDocument& document, BaseColors& colors) {
    std::vector<Index> result;
    std::vector<std::string> ignored;
    Collection<std::int64_t> images(colors);
    for (const GltfPrimitive& primitive : read_primitives(document, ignored)) {
        const std::int64_t image = gltf_image_of(document, primitive);
        result.push_back(image < 0 ? -1 : images.number(image, [&] { return gltf_image(document, image); }));
    }
    return result;
}

std::vector<Index> images_of_parts(const AttributedMesh& content, const GltfDocument& beside,
                                   const std::filesystem::path& file, BaseColors& colors) {
    std::vector<Index> result;
    Collection<std::string> images(colors);
    const std::map<std::string, std::string> image_of_material =
        read_material_images(file, beside, colors.notices);
    for (const std::string& material : content.part_names) {
        const auto image = image_of_material.find(material);
        result.push_back(image == image_of_material.end() ? -1 : images.number(image->second, [&] {
            return load_beside(beside, image->second);
        }));
    }
    return result;
}

}  // namespace

BaseColors read_base_colors(const AttributedMesh& content, const std::filesystem::path& file,
                            const ReadOptions& options) {
    BaseColors colors;
    if (content.texture_coordinates.empty()) return colors;
    std::vector<Index> of_part;
    try {
        if (const GltfDocument* document = gltf_of(content))
            of_part = images_of_parts(*document, colors);
        else if (lower_extension(file) == ".obj")
            of_part = images_of_parts(
                content, {platform::utf8_name(file), file.parent_path(), options, 0, {}, {}}, file, colors);
    } catch (const GltfJson::exception& error) {
        throw IoError(
            fmt::format("{}: its materials are not glTF ({})", platform::utf8_name(file), error.what()));
    }
    if (colors.images.empty()) return colors;
    for (Index t = 0; t < content.mesh.n_triangles(); ++t) {
        const auto part =
            static_cast<std::size_t>(content.parts.empty() ? 0 : content.parts[static_cast<std::size_t>(t)]);
        colors.image_of_triangle.push_back(part < of_part.size() ? of_part[part] : -1);
    }
    return colors;
}

}  // namespace counterpart
