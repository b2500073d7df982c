// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "io/map_bytes.hpp"

#include "io/decimal.hpp"
#include "io/npy_bytes.hpp"
#include "io/text_cursor.hpp"
#include "platform/files.hpp"

#include <counterpart/base/errors.hpp>

#include <algorithm>
#include <limits>
#include <string>

#include <fmt/format.h>

namespace counterpart {

using namespace io;

namespace {

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

VertexMap io::parse_vertex_map(std::string_view bytes, const std::filesystem::path& file, IndexBase base,
                               Index target_size) {
    std::vector<Index> map;
    if (is_npy(file)) {
        map = parse_npy_indices(bytes, file);
        for (std::size_t v = 0; v < map.size(); ++v) {
            map[v] = image_of(map[v], base, [&](const std::string& reason) {
                throw IoError(fmt::format("{}: entry {}: {}", platform::utf8_name(file), v, reason));
            });
        }
    } else {
        TextCursor text(bytes, platform::utf8_name(file));
        while (text.next_content()) {
            const std::int64_t number = text.integer("target vertex");
            map.push_back(image_of(number, base, [&](const std::string& reason) { text.fail(reason); }));
            if (!text.at_line_end()) text.fail("expected one whole number, found more");
        }
    }
    if (target_size < 0) {
        target_size = 0;
        for (const Index image : map) target_size = std::max(target_size, image + 1);
    }
    try {
        return {std::move(map), target_size};
    } catch (const InvalidInput& error) {
        throw IoError(fmt::format("{}: {}", platform::utf8_name(file), error.what()));
    }
}

std::string io::vertex_map_bytes(const VertexMap& map, const std::filesystem::path& file, IndexBase base) {
    std::vector<Index> numbers = map.image();
    for (Index& number : numbers)
        if (number != VertexMap::unmatched) number += static_cast<Index>(base);
    if (is_npy(file)) return npy_bytes(numbers);
    std::string text;
    for (const Index number : numbers) {
        append_decimal(text, number);
        text += '\n';
    }
    return text;
}

}  // namespace counterpart
