// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace counterpart {

/// All bytes of a file. Throws IoError naming the file if it is absent, a folder, or cannot be read.
std::string read_whole_file(const std::filesystem::path& file);

}  // namespace counterpart
