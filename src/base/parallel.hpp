// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// The only code that uses threads. Work items must be independent and write to separate locations, so that
// the result is the same for any number of threads. So is the error: of the items that throw, the first.
#pragma once

#include <counterpart/base/errors.hpp>
#include <counterpart/base/progress.hpp>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <limits>
#include <mutex>
#include <string>

#if defined(COUNTERPART_PLAIN_THREADS)
#include "base/plain_threads.hpp"
#else
#include "base/tbb_threads.hpp"
#endif

namespace counterpart::base {

#if defined(COUNTERPART_PLAIN_THREADS)
namespace threads = plain_threads;
#else
namespace threads = tbb_threads;
#endif

/// More threads than any machine has: what is asked for beyond is a mistake, and would take memory for each.
inline constexpr int max_threads = 1024;

/// Runs `work` with `n_threads` threads (0 = all the machine has) for the loops inside it, and returns its
/// result. Throws InvalidInput if n_threads is negative or above max_threads.
template <class Work>
auto with_threads(int n_threads, const Work& work) {
    if (n_threads < 0 || n_threads > max_threads)
        throw InvalidInput("the number of threads must be 0 (all) to " + std::to_string(max_threads) +
                           ", not " + std::to_string(n_threads));
    return threads::with_threads(n_threads, work);
}

/// The exception of the first of the works that throw, in their order. Works run under its guard let no
/// exception through to the scheduler, which would abandon the loops inside of all others half-way.
class FirstException {
  public:
    /// Runs the work, unless one before it in order has thrown.
    template <class Work>
    void guard(std::size_t order, const Work& work) {
        if (order > order_) return;
        try {
            work();
        } catch (...) {
            const std::lock_guard lock(mutex_);
            if (order > order_) return;
            order_ = order;
            exception_ = std::current_exception();
        }
    }
    /// Once all are done.
    void rethrow() const {
        if (exception_) std::rethrow_exception(exception_);
    }

  private:
    std::mutex mutex_;
    std::atomic<std::size_t> order_ = std::numeric_limits<std::size_t>::max();  // of the work that threw
    std::exception_ptr exception_;
};

/// Runs two independent works, at the same time if there are threads.
template <class First, class Second>
void parallel_invoke(const First& first, const Second& second) {
    FirstException exception;
    threads::invoke([&] { exception.guard(0, first); }, [&] { exception.guard(1, second); });
    exception.rethrow();
}

/// run(begin, end) for pieces of [0, count) of at least `grain` items.
template <class Run>
void parallel_for_pieces(std::size_t count, std::size_t grain, const Run& run) {
    FirstException exception;
    threads::for_pieces(count, grain, [&](std::size_t begin, std::size_t end) {
        exception.guard(begin, [&] { run(begin, end); });
    });
    exception.rethrow();
}

/// body(i) for i in [0, count), in any order, at least `grain` consecutive ones per task.
template <class Body>
void parallel_for(std::size_t count, std::size_t grain, const Body& body) {
    parallel_for_pieces(count, grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i != end; ++i) body(i);
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

/// body(scratch, i), with one scratch object per thread, made by `make`. Bodies may have loops of their own:
/// none is entered while another one has its scratch.
template <class Make, class Body>
void parallel_for_with(std::size_t count, std::size_t grain, const Make& make, const Body& body) {
    using Scratch = decltype(make());
    threads::PerThread<Scratch> scratch(make);
    parallel_for_pieces(count, grain, [&](std::size_t begin, std::size_t end) {
        threads::isolated([&] {
            Scratch& mine = scratch.local();
            for (std::size_t i = begin; i != end; ++i) body(mine, i);
        });
    });
}

}  // namespace counterpart::base

namespace counterpart {
using namespace base;  // what every module is written with
}
