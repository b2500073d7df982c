// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// What parallel.hpp needs, by TBB.
#pragma once

#include <cstddef>
#include <future>
#include <optional>

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/task_arena.h>

namespace counterpart::base::tbb_threads {

inline int n_allowed() { return tbb::this_task_arena::max_concurrency(); }

template <class Work>
auto with_threads(int n_threads, const Work& work) {
    // As many as are asked for, also where the machine has fewer: TBB would leave the rest out, with a
    // warning. Only there, since of all such wishes at one time it takes the smallest.
    std::optional<tbb::global_control> control;
    if (n_threads > tbb::info::default_concurrency())
        control.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(n_threads));
    tbb::task_arena arena(n_threads == 0 ? tbb::task_arena::automatic : n_threads);
    return arena.execute(work);
}

constexpr bool can_start() { return true; }

/// work() on another thread.
template <class Work>
auto start(const Work& work) {
    return std::async(std::launch::async, work);
}

template <class First, class Second>
void invoke(const First& first, const Second& second) {
    tbb::parallel_invoke(first, second);
}

/// run(begin, end) for pieces of [0, count) of at least `grain` items.
template <class Run>
void for_pieces(std::size_t count, std::size_t grain, const Run& run) {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, grain),
                      [&](const auto& range) { run(range.begin(), range.end()); });
}

/// work(), during which this thread takes up nothing from outside of it while it waits for what is inside.
template <class Work>
void isolated(const Work& work) {
    tbb::this_task_arena::isolate(work);
}

template <class Scratch>
using PerThread = tbb::enumerable_thread_specific<Scratch>;

}  // namespace counterpart::base::tbb_threads
