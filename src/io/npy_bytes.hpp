// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// The readers of counterpart/io/npy.hpp, on the bytes of a whole file; `file` is for messages.
#pragma once

#include <counterpart/base/types.hpp>
#include <counterpart/io/file.hpp>

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace counterpart::io {

/// Whether the name says that the file is a NumPy array.
inline bool is_npy(const std::filesystem::path& file) { return lower_extension(file) == ".npy"; }

Matrix parse_npy(std::string_view bytes, const std::filesystem::path& file);
std::vector<Index> parse_npy_indices(std::string_view bytes, const std::filesystem::path& file);
std::string npy_bytes(const Matrix& matrix);
std::string npy_bytes(const Vector& vector);
std::string npy_bytes(std::span<const Index> numbers);

}  // namespace counterpart::io
