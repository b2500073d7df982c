// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/progress.hpp>

#include <chrono>
#include <string>
#include <vector>

namespace counterpart {

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
