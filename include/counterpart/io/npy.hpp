// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/types.hpp>

#include <filesystem>

namespace counterpart {

/// Writes a matrix as NumPy `.npy` (float64, C order). The file appears whole or not at all. Throws IoError.
void write_npy(const Matrix& matrix, const std::filesystem::path& file);
/// Reads a one- or two-dimensional `.npy` of float32, float64, int32 or int64; a vector becomes one column.
Matrix read_npy(const std::filesystem::path& file);

}  // namespace counterpart
