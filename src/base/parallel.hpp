// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// The only code that uses threads. Work items must be independent and write to separate locations, so that
// the result is the same for any number of threads.
#pragma once

#include <counterpart/base/errors.hpp>
#include <counterpart/base/progress.hpp>

#include <algorithm>
#include <cstddef>
#include <string>

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/task_arena.h>

namespace counterpart::base {

/// Runs `work` in an arena of `n_threads` threads (0 = all the machine has) and returns its result. Loops
/// inside use that arena. Throws InvalidInput if n_threads is negative.
template <class Work>
auto with_threads(int n_threads, const Work& work) {
    if (n_threads < 0)
        throw InvalidInput("the number of threads must be 0 (all) or more, not " + std::to_string(n_threads));
    // As many as are asked for, also where the machine has fewer: TBB would leave the rest out, with a
    // warning.
    const auto allowed = static_cast<std::size_t>(std::max(n_threads, tbb::info::default_concurrency()));
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, allowed);
    tbb::task_arena arena(n_threads == 0 ? tbb::task_arena::automatic : n_threads);
    return arena.execute(work);
}

/// Runs two independent works, at the same time if there are threads.
template <class First, class Second>
void parallel_invoke(const First& first, const Second& second) {
    tbb::parallel_invoke(first, second);
}

/// body(i) for i in [0, count), in any order, at least `grain` consecutive ones per task.
template <class Body>
void parallel_for(std::size_t count, std::size_t grain, const Body& body) {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, grain), [&](const auto& range) {
        for (std::size_t i = range.begin(); i != range.end(); ++i) body(i);
    });
}

/// The same in order of blocks of items, with a progress report from the calling thread after each.
template <class Body>
void parallel_for(std::size_t count, std::size_t grain, const Progress& progress, const Body& body) {
    constexpr std::size_t least = 4096;  // items between reports: thousands cost more than a report
    const std::size_t block = std::max(least, count / 50);
    for (std::size_t begin = 0; begin < count; begin += block) {
        const std::size_t end = std::min(count, begin + block);
        parallel_for(end - begin, grain, [&](std::size_t i) { body(begin + i); });
        report_progress(progress, static_cast<double>(end) / static_cast<double>(count));
    }
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

}  // namespace counterpart::base

namespace counterpart {
using namespace base;  // what every module is written with
}
