// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Which of the files of Triangle and TetGen belong together.
#include "io/cells.hpp"
#include "platform/files.hpp"

#include <counterpart/io/file.hpp>

namespace counterpart::io {

Cells read_ele(const std::filesystem::path& file) {
    const auto beside = [&](const char* extension) {
        return std::filesystem::path(file).replace_extension(extension);
    };
    const std::filesystem::path elements = beside(".ele"), poly = beside(".poly"), node = beside(".node");
    const bool has_node = std::filesystem::exists(node);
    if (lower_extension(file) == ".poly" && !std::filesystem::exists(elements))
        return parse_outlines(read_whole_file(poly), has_node ? read_whole_file(node) : "",
                              platform::utf8_name(poly));
    const std::filesystem::path nodes = has_node ? node : poly;
    return parse_ele(read_whole_file(nodes), read_whole_file(elements), platform::utf8_name(nodes),
                     platform::utf8_name(elements));
}

}  // namespace counterpart::io
