// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// What parallel.hpp needs, by threads of the standard library: for what needs no other library (wheels,
// Windows, WebAssembly), and for the thread sanitizer, which takes every hand-over inside an uninstrumented
// TBB for a race. Simple enough to be seen right.
#pragma once

#include "platform/process.hpp"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <functional>
#include <future>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>

#ifdef __EMSCRIPTEN__
#include <emscripten/threading.h>
#endif

namespace counterpart::base::plain_threads {

/// Whether there are threads: WebAssembly has them only where a page is isolated from others.
inline bool can_start() {
#ifdef __EMSCRIPTEN__
    return emscripten_has_threading_support() != 0;
#else
    return true;
#endif
}

/// What with_threads() has set on this thread; 0: nothing.
inline constinit thread_local int set_number = 0;

/// How many threads a loop that starts on this thread may use.
inline int n_allowed() {
    static const int all = can_start() ? std::max(2, platform::n_processors()) : 1;
    return set_number > 0 ? set_number : all;
}

template <class Work>
auto with_threads(int n_threads, const Work& work) {
    struct Restored {
        int before = set_number;
        ~Restored() { set_number = before; }
    } const restored;
    if (n_threads > 0 && can_start()) set_number = n_threads;
    return work();
}

/// Threads that wait for work. They are kept until the process ends: a page starts none while its code runs.
class Helpers {
  public:
    /// Those of this process. One that was forked has none of its parent's threads, and what it inherited may
    /// be locked for ever: it begins anew.
    static Helpers& all() {
        static std::atomic<Helpers*> current = nullptr;
        Helpers* helpers = current;
        while (helpers == nullptr || helpers->process_ != platform::process_number()) {
            auto fresh = std::make_unique<Helpers>();
            if (current.compare_exchange_strong(helpers, fresh.get())) helpers = fresh.release();
        }
        return *helpers;
    }

    /// work() on this thread and on up to `n_others` more, each when it is free; returns once all are done.
    /// It lets no exception through. Nobody waits for a thread that has not begun, so that works may share
    /// within.
    void share(int n_others, const std::function<void()>& work) {
        const auto job = std::make_shared<Job>(Job{work, n_others});
        post(job);
        work();
        std::unique_lock lock(mutex_);
        take_back(*job);
        changed_.wait(lock, [&] { return job->n_running == 0; });
    }

    /// work() on another thread.
    void start(std::function<void()> work) { post(std::make_shared<Job>(Job{std::move(work), 1})); }

  private:
    struct Job {
        std::function<void()> work;
        int n_wanted = 0;  // threads that may still come
        int n_running = 0;
    };

    void post(const std::shared_ptr<Job>& job) {
        {
            const std::lock_guard lock(mutex_);
            jobs_.push_back(job);
            n_needed_ += job->n_wanted;
            for (; n_threads_ < n_needed_; ++n_threads_) std::thread([this] { serve(); }).detach();
        }
        changed_.notify_all();
    }

    void take_back(Job& job) {
        n_needed_ -= std::exchange(job.n_wanted, 0);
        jobs_.remove_if([&](const auto& other) { return other.get() == &job; });
    }

    void serve() {
        std::unique_lock lock(mutex_);
        while (true) {
            changed_.wait(lock, [&] { return !jobs_.empty(); });
            const std::shared_ptr<Job> job = jobs_.back();  // the innermost, for which others wait
            ++job->n_running;
            if (--job->n_wanted == 0) jobs_.pop_back();
            lock.unlock();
            job->work();
            lock.lock();
            --job->n_running;
            --n_needed_;
            changed_.notify_all();
        }
    }

    std::mutex mutex_;
    std::condition_variable changed_;
    std::list<std::shared_ptr<Job>> jobs_;
    int n_threads_ = 0;
    int n_needed_ = 0;  // threads that work or are wanted
    const long process_ = platform::process_number();
};

/// work() on another thread, with as many threads as it could use on this one.
template <class Work>
auto start(const Work& work) {
    const auto task = std::make_shared<std::packaged_task<decltype(work())()>>(
        [work, share = n_allowed()] { return plain_threads::with_threads(share, work); });
    auto result = task->get_future();
    Helpers::all().start([task] { (*task)(); });
    return result;
}

/// run(begin, end) for pieces of [0, count) of at least `grain` items, each by the thread that is free first;
/// these have their share of the threads for loops inside.
template <class Run>
void for_pieces(std::size_t count, std::size_t grain, const Run& run) {
    if (count == 0) return;
    const int allowed = n_allowed();
    if (allowed == 1) return run(std::size_t{0}, count);
    // Several for each thread, as some take longer than others.
    const std::size_t piece =
        std::max({grain, std::size_t{1}, count / (16 * static_cast<std::size_t>(allowed))});
    const std::size_t n_pieces = (count + piece - 1) / piece;
    const int n_threads = static_cast<int>(std::min(n_pieces, static_cast<std::size_t>(allowed)));
    std::atomic<std::size_t> next = 0;
    const auto work = [&, share = std::max(1, allowed / n_threads)] {
        plain_threads::with_threads(share, [&] {
            for (std::size_t i = next++; i < n_pieces; i = next++)
                run(i * piece, std::min(count, (i + 1) * piece));
        });
    };
    if (n_threads == 1) return work();
    Helpers::all().share(n_threads - 1, work);
}

template <class First, class Second>
void invoke(const First& first, const Second& second) {
    for_pieces(2, 1, [&](std::size_t begin, std::size_t end) {
        if (begin == 0) first();
        if (end == 2) second();
    });
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
