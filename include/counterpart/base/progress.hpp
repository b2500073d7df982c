// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace counterpart {

/// Called between steps, on the calling thread, with the fraction of the work done: in [0, 1] and never
/// decreasing. Return false to cancel: the running function then throws Canceled. May be empty.
using Progress = std::function<bool(double fraction)>;

/// Thrown by a function whose Progress callback returned false.
struct Canceled : std::runtime_error {
    Canceled() : std::runtime_error("canceled by the caller") {}
};

/// Reports `fraction` if there is a callback; throws Canceled if it returns false.
inline void report_progress(const Progress& progress, double fraction) {
    if (progress && !progress(fraction)) throw Canceled();
}

/// The progress of one stage of a longer work: its 0 .. 1 is `begin` .. `end` of the whole. Empty if that is.
inline Progress part_of(const Progress& progress, double begin, double end) {
    if (!progress) return {};
    return [progress, begin, end](double fraction) { return progress(begin + (end - begin) * fraction); };
}

/// Wall-clock seconds that one named stage of a method took.
struct StageTime {
    std::string stage;
    double seconds = 0;
};

/// Wall-clock time of consecutive stages.
class Stopwatch {
  public:
    /// Ends the running stage under `name`; stages of one name add up.
    void lap(const std::string& name) {
        const auto now = std::chrono::steady_clock::now();
        const double seconds = std::chrono::duration<double>(now - last_).count();
        last_ = now;
        for (StageTime& stage : stages_) {
            if (stage.stage == name) {
                stage.seconds += seconds;
                return;
            }
        }
        stages_.push_back({name, seconds});
    }

    const std::vector<StageTime>& stages() const { return stages_; }

  private:
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
    std::vector<StageTime> stages_;
};

}  // namespace counterpart
