// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "io/inflate.hpp"

#include <limits>

#include <zlib.h>

namespace counterpart::io {

std::optional<std::string> inflate(std::string_view bytes, std::uint64_t size) {
    constexpr std::uint64_t most_per_byte = 1032;  // of deflate (zlib, "Technical details")
    constexpr int any_header = 32;
    if (size / most_per_byte > bytes.size() || bytes.size() > std::numeric_limits<uInt>::max() ||
        size > std::numeric_limits<uInt>::max())
        return std::nullopt;
    z_stream stream = {};
    if (inflateInit2(&stream, MAX_WBITS + any_header) != Z_OK) return std::nullopt;
    std::string result(static_cast<std::size_t>(size), '\0');
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    stream.avail_in = static_cast<uInt>(bytes.size());
    stream.next_out = reinterpret_cast<Bytef*>(result.data());
    stream.avail_out = static_cast<uInt>(size);
    const int end = ::inflate(&stream, Z_FINISH);
    const bool is_whole = end == Z_STREAM_END && stream.avail_out == 0;
    inflateEnd(&stream);
    return is_whole ? std::optional(std::move(result)) : std::nullopt;
}

}  // namespace counterpart::io
