// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>

namespace counterpart {

/// The caller's data or options cannot be used; the message names the element and what to do about it.
struct InvalidInput : std::invalid_argument {
    using invalid_argument::invalid_argument;
};

/// A file cannot be read or written; the message names the file, the line where there is one, and the reason.
struct IoError : std::runtime_error {
    using runtime_error::runtime_error;
};

/// A computation on valid input broke down (singular system, no convergence where there must be).
struct NumericalError : std::runtime_error {
    using runtime_error::runtime_error;
};

}  // namespace counterpart
