// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// What parallel.hpp needs, by plain threads: for the thread sanitizer, which takes every hand-over inside an
// uninstrumented TBB for a race. Slow, and simple enough to be seen right.
#pragma once

#include "platform/process.hpp"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <functional>
#include <map>
#include <mutex>
#include <thread>
#include <vector>

namespace counterpart::base::plain_threads {

/// How many threads a loop that starts on this thread may use.
inline thread_local int allowed = std::max(2, platform::n_processors());

inline int n_allowed() { return allowed; }

template <class Work>
auto with_threads(int n_threads, const Work& work) {
    struct Restored {
        int before = allowed;
        ~Restored() { allowed = before; }
    } const restored;
    if (n_threads > 0) allowed = n_threads;
    return work();
}

/// work() on so many threads, this one among them, each with its share of the threads for loops inside. The
/// first exception reaches the caller.
template <class Work>
void on_each(int n_threads, const Work& work) {
    std::exception_ptr first;
    std::mutex mutex;
    const int share = std::max(1, allowed / n_threads);
    const auto guarded = [&] {
        try {
            with_threads(share, work);
        } catch (...) {
            const std::lock_guard lock(mutex);
            if (!first) first = std::current_exception();
        }
    };
    {
        std::vector<std::jthread> others;
        for (int other = 1; other < n_threads; ++other) others.emplace_back(guarded);
        guarded();
    }
    if (first) std::rethrow_exception(first);
}

/// run(begin, end) for pieces of [0, count) of `grain` items, each by the thread that is free first.
template <class Run>
void for_pieces(std::size_t count, std::size_t grain, const Run& run) {
    if (count == 0) return;
    const std::size_t piece = std::max<std::size_t>(grain, 1), n_pieces = (count + piece - 1) / piece;
    std::atomic<std::size_t> next = 0;
    on_each(static_cast<int>(std::min(n_pieces, static_cast<std::size_t>(allowed))), [&] {
        for (std::size_t i = next++; i < n_pieces; i = next++)
            run(i * piece, std::min(count, (i + 1) * piece));
    });
}

template <class First, class Second>
void invoke(const First& first, const Second& second) {
    for_pieces(2, 1, [&](std::size_t i, std::size_t) { i == 0 ? first() : second(); });
}

/// work(): no thread here takes up another's.
template <class Work>
void isolated(const Work& work) {
    work();
}

/// One scratch object for each thread that asks.
template <class Scratch>
class PerThread {
  public:
    explicit PerThread(std::function<Scratch()> make) : make_(std::move(make)) {}

    Scratch& local() {
        const std::lock_guard lock(mutex_);
        const auto found = scratch_.find(std::this_thread::get_id());
        if (found != scratch_.end()) return found->second;
        return scratch_.emplace(std::this_thread::get_id(), make_()).first->second;
    }

  private:
    std::function<Scratch()> make_;
    std::mutex mutex_;
    std::map<std::thread::id, Scratch> scratch_;
};

}  // namespace counterpart::base::plain_threads
