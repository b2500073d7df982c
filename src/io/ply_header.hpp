// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "io/text_cursor.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace counterpart::io {

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };
std::size_t size_of(PlyType type);

struct PlyProperty {
    std::string name;
    PlyType type = PlyType::float32;  ///< of the value, or of the items of a list
    bool is_list = false;
    PlyType count_type = PlyType::uint8;  ///< of a list's length
};

struct PlyElement {
    std::string name;
    std::int64_t count = 0;
    std::vector<PlyProperty> properties;
};

struct PlyHeader {
    enum class Format { ascii, little_endian, big_endian } format = Format::ascii;
    std::vector<PlyElement> elements;
};

/// Reads from "ply" to "end_header" and leaves the cursor on the first byte behind. Throws IoError with the
/// line.
PlyHeader read_ply_header(TextCursor& text);

}  // namespace counterpart::io
