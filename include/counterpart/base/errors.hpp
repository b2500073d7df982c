// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>

namespace counterpart {

/// The caller's data or options cannot be used; the message names the element and what to do about it.
struct InvalidInput : std::invalid_argument {
    using invalid_argument::invalid_argument;
};

/// A valid mesh that this method cannot handle (too few vertices, no area); another method may.
struct UnsuitableMesh : InvalidInput {
    using InvalidInput::InvalidInput;
};

/// A file cannot be read or written; the message names the file, the line where there is one, and the reason.
struct IoError : std::runtime_error {
    using runtime_error::runtime_error;
};

/// A computation on valid input failed (singular system, no convergence).
struct NumericalError : std::runtime_error {
    using runtime_error::runtime_error;
};

}  // namespace counterpart
