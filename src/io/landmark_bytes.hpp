// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// The reader of counterpart/io/landmark_file.hpp, on the bytes of a whole file; `name` leads messages.
#pragma once

#include <counterpart/io/landmark_file.hpp>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace counterpart::io {

std::vector<std::pair<Index, Index>> parse_landmarks(std::string_view bytes, const std::string& name,
                                                     MeshView source, MeshView target);

}  // namespace counterpart::io
