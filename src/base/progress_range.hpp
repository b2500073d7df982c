// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Progress of work that runs in parallel, told to a callback that must be called from the calling thread.
#pragma once

#include "base/parallel.hpp"

#include <counterpart/base/progress.hpp>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>
#include <future>

namespace counterpart::base {

/// Written by the threads that work, read by the one that reports.
struct WorkState {
    std::atomic<double> fraction = 0;
    std::atomic<bool> canceled = false;
    std::function<void()> reached{};  ///< called after each step, where the one that works also reports
};

/// A share [first, last] of the whole work. Copies speak of the same work; any thread may.
class ProgressRange {
  public:
    ProgressRange() = default;  ///< nobody asks
    explicit ProgressRange(WorkState& state, double first = 0, double last = 1)
        : state_(&state), first_(first), last_(last) {}

    /// The part of this range from `first` to `last`, both in [0, 1].
    ProgressRange part(double first, double last) const {
        ProgressRange range = *this;
        range.first_ = first_ + first * (last_ - first_);
        range.last_ = first_ + last * (last_ - first_);
        return range;
    }
    /// Step `i` of `count` equal ones.
    ProgressRange step(std::size_t i, std::size_t count) const {
        return part(static_cast<double>(i) / static_cast<double>(count),
                    static_cast<double>(i + 1) / static_cast<double>(count));
    }

    /// The same work, of which nothing is reported: for parts that run beside each other.
    ProgressRange unheard() const { return part(0, 0); }

    /// Throws Canceled once the caller wants to stop.
    void check() const {
        if (state_ != nullptr && state_->canceled) throw Canceled();
    }
    /// Says that `fraction` of this range is done, and checks. What is told never decreases.
    void reach(double fraction) const {
        check();
        if (state_ == nullptr) return;
        const double now = first_ + std::clamp(fraction, 0.0, 1.0) * (last_ - first_);
        double before = state_->fraction;
        while (before < now && !state_->fraction.compare_exchange_weak(before, now)) {
        }
        if (state_->reached) state_->reached();
    }
    /// For functions that report themselves.
    Progress callback() const {
        if (state_ == nullptr) return {};
        return [range = *this](double fraction) {
            range.reach(fraction);
            return true;
        };
    }

  private:
    WorkState* state_ = nullptr;
    double first_ = 0, last_ = 1;
};

/// How often progress is told.
inline constexpr std::chrono::milliseconds report_interval(30);

/// work(range) on a thread of its own, while this one reports.
template <class Work>
auto reported_beside(const Progress& progress, const Work& work) {
    WorkState state;
    auto running = threads::start([&] { return work(ProgressRange(state)); });
    try {
        do report_progress(progress, state.fraction);
        while (running.wait_for(report_interval) != std::future_status::ready);
    } catch (...) {
        state.canceled = true;
        running.wait();  // for the work to notice
        throw;
    }
    return running.get();
}

/// work(range), which reports between its steps.
template <class Work>
auto reported_between(const Progress& progress, const Work& work) {
    WorkState state;
    auto last = std::chrono::steady_clock::now() - report_interval;
    state.reached = [&] {
        const auto now = std::chrono::steady_clock::now();
        if (now - last < report_interval) return;
        last = now;
        report_progress(progress, state.fraction);
    };
    return work(ProgressRange(state));
}

/// Returns work(range). With a callback the work runs on a thread of its own, and this one calls `progress`
/// a few times a second with what the work has reached, and at last with 1. Where there is one thread only,
/// it reports between the steps of its work.
template <class Work>
auto with_progress(const Progress& progress, const Work& work) {
    if (!progress) return work(ProgressRange());
    auto result = threads::can_start() ? reported_beside(progress, work) : reported_between(progress, work);
    report_progress(progress, 1);
    return result;
}

}  // namespace counterpart::base

namespace counterpart {
using namespace base;  // what every module is written with
}
