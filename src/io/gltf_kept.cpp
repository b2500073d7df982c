// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// A glTF document as bytes, for whoever keeps a mesh elsewhere than in a file: CBOR (RFC 8949) of its JSON
// and buffers.
#include "io/gltf_document.hpp"
#include "platform/files.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/io/gltf.hpp>

namespace counterpart {

using namespace io;

std::string io::GltfContent::to_bytes() const {
    GltfJson kept = {{"name", gltf_.name},
                     {"folder", platform::utf8_name(gltf_.folder)},
                     {"allow_external", gltf_.options.allow_external},
                     {"file_size", gltf_.file_size},
                     {"json", gltf_.json},
                     {"buffers", GltfJson::array()}};
    for (const std::string& buffer : gltf_.buffers)
        kept["buffers"].push_back(GltfJson::binary({buffer.begin(), buffer.end()}));
    std::string bytes;
    GltfJson::to_cbor(kept, bytes);
    return bytes;
}

std::shared_ptr<const Document> document_from_bytes(std::string_view bytes) {
    try {
        GltfJson kept = GltfJson::from_cbor(bytes.begin(), bytes.end());
        GltfDocument document;
        document.name = kept.at("name").get<std::string>();
        document.folder = platform::path_of(kept.at("folder").get<std::string>());
        document.options.allow_external = kept.at("allow_external").get<bool>();
        document.file_size = kept.at("file_size").get<std::size_t>();
        document.json = std::move(kept.at("json"));
        for (const GltfJson& buffer : kept.at("buffers")) {
            const auto& binary = buffer.get_binary();
            document.buffers.emplace_back(binary.begin(), binary.end());
        }
        return std::make_shared<const GltfContent>(std::move(document));
    } catch (const GltfJson::exception& error) {
        throw InvalidInput(std::string("not the bytes of a glTF document: ") + error.what());
    }
}

}  // namespace counterpart
