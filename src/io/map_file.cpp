// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include <counterpart/base/errors.hpp>
#include <counterpart/io/atomic_file.hpp>
#include <counterpart/io/map_file.hpp>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <iterator>
#include <string>

#include <fmt/format.h>

namespace counterpart {

VertexMap read_vertex_map(const std::filesystem::path& file, IndexBase base) {
    std::ifstream stream(file);
    if (!stream) throw IoError(fmt::format("{}: cannot be opened", file.string()));
    VertexMap map;
    std::string line;
    for (int number = 1; std::getline(stream, line); ++number) {
        const std::string text = line.substr(0, line.find('#'));
        const std::size_t begin = text.find_first_not_of(" \t\r");
        if (begin == std::string::npos) continue;
        Index value = 0;
        const char* end = text.data() + text.find_last_not_of(" \t\r") + 1;
        const auto [stop, error] = std::from_chars(text.data() + begin, end, value);
        if (error != std::errc() || stop != end) {
            throw IoError(
                fmt::format("{}:{}: expected one whole number, found '{}'", file.string(), number, line));
        }
        if (value != VertexMap::unmatched) value -= static_cast<Index>(base);
        if (value < VertexMap::unmatched)
            throw IoError(fmt::format("{}:{}: vertex {} is out of range", file.string(), number, value));
        map.image.push_back(value);
        map.target_size = std::max(map.target_size, value + 1);
    }
    return map;
}

void write_vertex_map(const VertexMap& map, const std::filesystem::path& file, IndexBase base) {
    std::string text;
    for (const Index image : map.image)
        fmt::format_to(std::back_inserter(text), "{}\n",
                       image == VertexMap::unmatched ? image : image + static_cast<Index>(base));
    write_file(text, file);
}

}  // namespace counterpart
