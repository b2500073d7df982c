// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/spectral/prepared_shape.hpp"

#include <string>
#include <string_view>

namespace counterpart::spectral_match {

/// A shape as bytes, the same for the same shape; machines of one byte order understand each other's.
/// About 2.4 kB for each vertex that is matched and 60 B for each of a larger mesh. O(size).
/// `tuning` is what it was prepared with.
std::string to_bytes(const PreparedShape& shape, const PreparationTuning& tuning = {});

/// The shape, exactly. Throws InvalidInput with a reason for bytes of another version or tuning, cut short or
/// longer, and for anything that to_bytes cannot have written: numbers out of range, sizes that disagree,
/// values that are not finite. No memory beyond twice the size of the bytes. O(size).
PreparedShape shape_from_bytes(std::string_view bytes, const PreparationTuning& tuning = {});

}  // namespace counterpart::spectral_match
