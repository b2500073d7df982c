// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string_view>

namespace counterpart {

/// Writes `bytes` to `file` whole or not at all: beside it first, then renamed. Throws IoError naming file
/// and reason.
void write_file(std::string_view bytes, const std::filesystem::path& file);

}  // namespace counterpart
