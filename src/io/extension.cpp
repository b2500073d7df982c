// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "platform/files.hpp"

#include <counterpart/io/file.hpp>

#include <algorithm>

namespace counterpart {

std::string lower_extension(const std::filesystem::path& file) {
    std::string extension = platform::utf8_name(file.extension());
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return extension;
}

bool is_gltf(const std::filesystem::path& file) {
    const std::string extension = lower_extension(file);
    return extension == ".glb" || extension == ".gltf";
}

}  // namespace counterpart
