// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// NumPy's array files (numpy.lib.format, versions 1 to 3): numpy.save writes them, numpy.load reads them.
#pragma once

#include <counterpart/base/types.hpp>

#include <filesystem>
#include <span>

namespace counterpart {

/// Writes a matrix as `.npy` (float64, C order). The file appears whole or not at all. Throws IoError.
void write_npy(const Matrix& matrix, const std::filesystem::path& file);
/// Reads a one- or two-dimensional `.npy` of float32, float64, int32 or int64, in either byte order and
/// either memory order; a vector becomes one column. Throws IoError naming the file and the reason.
Matrix read_npy(const std::filesystem::path& file);

/// How a `.npy` stores its numbers.
struct NpyLayout {
    bool is_integer = false;
    int n_dimensions = 2;  ///< 1 or 2
};
/// Of a file that read_npy can read. Throws IoError as that does.
NpyLayout read_npy_layout(const std::filesystem::path& file);

/// Writes a vector as one-dimensional `.npy` (float64).
void write_npy(const Vector& vector, const std::filesystem::path& file);

/// Writes a vector of integers as `.npy` (int32).
void write_npy(std::span<const Index> numbers, const std::filesystem::path& file);

}  // namespace counterpart
