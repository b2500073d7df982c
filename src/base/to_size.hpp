// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/types.hpp>

#include <cstddef>

namespace counterpart::base {

/// An index that is known not to be negative, for containers of the standard library.
constexpr std::size_t to_size(Index i) { return static_cast<std::size_t>(i); }

}  // namespace counterpart::base

namespace counterpart {
using namespace base;  // what every module is written with
}
