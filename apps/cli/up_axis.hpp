// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "console.hpp"

namespace counterpart::cli {

/// What --up auto means for this mesh, and says so.
std::string guessed_up(MeshView mesh, const CommonOptions& options);

}  // namespace counterpart::cli
