// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace counterpart {

/// Called from the calling thread between steps with the fraction of the work done, in [0, 1], never
/// decreasing. Return false to stop: the running function then throws Cancelled. May be empty.
using Progress = std::function<bool(double fraction)>;

/// Thrown by a function whose Progress callback returned false.
struct Cancelled : std::runtime_error {
    Cancelled() : std::runtime_error("cancelled by the caller") {}
};

/// Reports `fraction` if there is a callback; throws Cancelled if it returns false.
inline void report(const Progress& progress, double fraction) {
    if (progress && !progress(fraction)) throw Cancelled();
}

/// Wall-clock seconds that one named stage of a method took.
struct StageTime {
    std::string stage;
    double seconds = 0;
};

}  // namespace counterpart
