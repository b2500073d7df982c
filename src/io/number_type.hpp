// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Numbers as VTK and GIfTI store them: of ten types, in either byte order.
#pragma once

#include <bit>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace counterpart::io {

enum class NumberType { int8, uint8, int16, uint16, int32, uint32, int64, uint64, float32, float64 };

std::size_t size_of(NumberType type);

/// All numbers of the bytes, whose size must be a multiple of that of one. O(n).
std::vector<double> numbers_of(std::string_view bytes, NumberType type, std::endian order);

/// A name of one of VTK's types in its legacy format ("float", "unsigned_char", "vtktypeint64").
std::optional<NumberType> legacy_vtk_type(std::string_view name);
/// The same in its XML ("Float32", "UInt8", "Int64").
std::optional<NumberType> xml_vtk_type(std::string_view name);

}  // namespace counterpart::io
