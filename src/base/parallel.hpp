// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// The one place that knows about threads. Work items must be independent and write to places of their own, so
// that the result is the same for any number of threads.
#pragma once

#include <counterpart/base/errors.hpp>

#include <algorithm>
#include <cstddef>
#include <string>

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace counterpart {

/// Runs `work` in an arena of `n_threads` threads (0 = all the machine has) and returns its result. Loops
/// inside use that arena. Throws InvalidInput if n_threads is negative.
template <class Work>
auto with_threads(int n_threads, const Work& work) {
    if (n_threads < 0)
        throw InvalidInput("the number of threads must be 0 (all) or more, not " + std::to_string(n_threads));
    // More threads than the machine has gain nothing, and TBB prints a warning when asked for them.
    const int available = tbb::info::default_concurrency();
    tbb::task_arena arena(n_threads == 0 ? available : std::min(n_threads, available));
    return arena.execute(work);
}

/// body(i) for i in [0, count), in any order, at least `grain` consecutive ones per task.
template <class Body>
void parallel_for(std::size_t count, std::size_t grain, const Body& body) {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, grain), [&](const auto& range) {
        for (std::size_t i = range.begin(); i != range.end(); ++i) body(i);
    });
}

/// body(scratch, i), with one scratch object per thread, made by `make`.
template <class Make, class Body>
void parallel_for_with(std::size_t count, std::size_t grain, const Make& make, const Body& body) {
    using Scratch = decltype(make());
    tbb::enumerable_thread_specific<Scratch> scratch(make);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, grain), [&](const auto& range) {
        Scratch& mine = scratch.local();
        for (std::size_t i = range.begin(); i != range.end(); ++i) body(mine, i);
    });
}

}  // namespace counterpart
