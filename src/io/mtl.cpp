// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "io/mtl.hpp"

#include "io/text_cursor.hpp"

#include <counterpart/io/file.hpp>

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

namespace counterpart::io {
namespace {

// Calls `take(key word, rest)` for each line that has both.
template <typename Take>
void for_each_line(std::string_view text, const Take& take) {
    text = without_mark(text);
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view line = stripped(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
        const std::size_t key_end = line.find_first_of(" \t");
        if (key_end != line.npos) take(line.substr(0, key_end), stripped(line.substr(key_end)));
    }
}

// The name of the image; options such as "-s 1 1 1" stand before it.
std::string image_name(std::string_view rest) {
    if (rest.starts_with('-')) rest = rest.substr(rest.find_last_of(" \t") + 1);
    std::string name(rest);
    std::replace(name.begin(), name.end(), '\\', '/');
    return name;
}

}  // namespace

std::string load_beside(const GltfDocument& beside, const std::string& name) {
    // Of a URI only its percent signs mean something else than in a file's name.
    std::string uri;
    for (const char c : name) uri += c == '%' ? std::string("%25") : std::string(1, c);
    if (uri.starts_with("data:")) beside.fail(fmt::format("'{}' is no file", name.substr(0, 20)));
    return load_uri(beside, uri, name);
}

std::map<std::string, std::string> read_material_images(const std::filesystem::path& obj,
                                                        const GltfDocument& beside,
                                                        std::vector<std::string>& notices) {
    std::map<std::string, std::string> images;
    const auto read_library = [&](std::string_view name) {
        std::string material;
        for_each_line(load_beside(beside, std::string(name)),
                      [&](std::string_view key, std::string_view rest) {
                          if (key == "newmtl") material = rest;
                          if (key == "map_Kd") images[material] = image_name(rest);
                      });
    };
    for_each_line(read_whole_file(obj), [&](std::string_view key, std::string_view rest) {
        if (key != "mtllib") return;
        try {
            read_library(rest);
        } catch (const IoError& error) {
            notices.push_back(fmt::format("materials are not shown: {}", error.what()));
        }
    });
    return images;
}

}  // namespace counterpart::io
