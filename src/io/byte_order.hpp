// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <string>

namespace counterpart::io {

/// The number stored at `bytes` in the given byte order.
template <class Number>
Number load_number(const char* bytes, std::endian order = std::endian::little) {
    std::array<char, sizeof(Number)> raw;
    std::memcpy(raw.data(), bytes, raw.size());
    if (order != std::endian::native) std::reverse(raw.begin(), raw.end());
    return std::bit_cast<Number>(raw);
}

/// Appends the number's bytes, least significant first.
template <class Number>
void append_number(std::string& bytes, Number value) {
    auto raw = std::bit_cast<std::array<char, sizeof(Number)>>(value);
    if constexpr (std::endian::native == std::endian::big) std::reverse(raw.begin(), raw.end());
    bytes.append(raw.data(), raw.size());
}

}  // namespace counterpart::io
