// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace counterpart::io {

/// What zlib or gzip compressed, by zlib; nothing if it is damaged or not exactly `size` bytes. Memory for
/// `size` is taken only if the bytes can hold so much.
std::optional<std::string> inflate(std::string_view bytes, std::uint64_t size);

}  // namespace counterpart::io
