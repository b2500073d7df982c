// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace counterpart::test {

/// What differs between the accessors of two glTF files, in what they state or in their bytes; empty:
/// nothing.
std::string accessor_difference(const std::filesystem::path& before, const std::filesystem::path& after);

}  // namespace counterpart::test
