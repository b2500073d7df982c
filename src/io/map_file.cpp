// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "io/decimal.hpp"
#include "io/text_cursor.hpp"
#include "io/whole_file.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/io/atomic_file.hpp>
#include <counterpart/io/map_file.hpp>
#include <counterpart/io/npy.hpp>

#include <algorithm>
#include <limits>
#include <string>

#include <fmt/format.h>

namespace counterpart {
namespace {

bool is_npy(const std::filesystem::path& file) { return file.extension() == ".npy"; }

// From the number in a file to the image; `refuse` is called with the reason if it is none.
template <class Refuse>
Index image_of(std::int64_t number, IndexBase base, const Refuse& refuse) {
    if (number == VertexMap::unmatched) return VertexMap::unmatched;
    const auto first = static_cast<std::int64_t>(base);
    if (number < first || number - first >= std::numeric_limits<Index>::max())
        refuse(fmt::format("vertex {} is out of range; vertices count from {}, -1 means unmatched", number,
                           first));
    return static_cast<Index>(number - first);
}

}  // namespace

VertexMap read_vertex_map(const std::filesystem::path& file, IndexBase base) {
    VertexMap map;
    if (is_npy(file)) {
        map.image = read_npy_indices(file);
        for (std::size_t v = 0; v < map.image.size(); ++v) {
            map.image[v] = image_of(map.image[v], base, [&](const std::string& reason) {
                throw IoError(fmt::format("{}: entry {}: {}", file.string(), v, reason));
            });
        }
    } else {
        const std::string bytes = read_whole_file(file);
        TextCursor text(bytes, file.string());
        while (text.next_content()) {
            const std::int64_t number = text.integer("target vertex");
            map.image.push_back(
                image_of(number, base, [&](const std::string& reason) { text.fail(reason); }));
            if (!text.at_line_end()) text.fail("expected one whole number, found more");
        }
    }
    for (const Index image : map.image) map.target_size = std::max(map.target_size, image + 1);
    return map;
}

void write_vertex_map(const VertexMap& map, const std::filesystem::path& file, IndexBase base) {
    std::vector<Index> numbers = map.image;
    for (Index& number : numbers)
        if (number != VertexMap::unmatched) number += static_cast<Index>(base);
    if (is_npy(file)) return write_npy(numbers, file);
    std::string text;
    for (const Index number : numbers) {
        append_decimal(text, number);
        text += '\n';
    }
    write_file(text, file);
}

}  // namespace counterpart
