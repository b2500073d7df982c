// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string_view>

namespace counterpart::fuzz {

/// A function of the library that takes whatever bytes there are: it may refuse them with one of the errors
/// of counterpart/base/errors.hpp, and must do nothing worse.
struct Target {
    std::string_view name;  ///< of the corpus folder and of the program that fuzzes it
    void (*run)(std::string_view bytes);
};

std::span<const Target> reader_targets();
std::span<const Target> matcher_targets();

}  // namespace counterpart::fuzz
