// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "io/mtl.hpp"

#include "io/obj_scanner.hpp"
#include "platform/files.hpp"

#include <counterpart/io/file.hpp>
#include <counterpart/io/mesh_file.hpp>

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

namespace counterpart::io {
namespace {

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
    const auto read_library = [&](const std::string& name) {
        const std::string text = load_beside(beside, name);
        std::string material;
        for (ObjScanner lines(text, name); lines.next();) {  // they look like those of OBJ
            const std::string_view rest = lines.text().rest_of_line();
            if (lines.key_word() == "newmtl") material = lines.text().rest();
            if (lines.key_word() == "map_Kd" && !rest.empty()) images[material] = image_name(rest);
        }
    };
    for (const std::string& library : material_files(obj)) {
        try {
            read_library(library);
        } catch (const IoError& error) {
            notices.push_back(fmt::format("materials are not shown: {}", error.what()));
        }
    }
    return images;
}

}  // namespace counterpart::io

namespace counterpart {

std::vector<std::string> material_files(const std::filesystem::path& obj) {
    std::vector<std::string> names;
    const std::string text = read_whole_file(obj);
    for (io::ObjScanner lines(text, platform::utf8_name(obj)); lines.next();) {
        const std::string_view name = lines.text().rest_of_line();
        if (lines.key_word() == "mtllib" && !name.empty()) names.emplace_back(name);
    }
    return names;
}

}  // namespace counterpart
