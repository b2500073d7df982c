// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// What parallel.hpp needs, where there is one thread only: WebAssembly in a page.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <utility>

namespace counterpart::base::no_threads {

inline int n_allowed() { return 1; }

template <class Work>
auto with_threads(int, const Work& work) {
    return work();
}

template <class First, class Second>
void invoke(const First& first, const Second& second) {
    first();
    second();
}

/// run(begin, end) for [0, count) as a whole.
template <class Run>
void for_pieces(std::size_t count, std::size_t, const Run& run) {
    if (count > 0) run(std::size_t{0}, count);
}

template <class Work>
void isolated(const Work& work) {
    work();
}

/// The scratch object of the one thread.
template <class Scratch>
class PerThread {
  public:
    explicit PerThread(std::function<Scratch()> make) : make_(std::move(make)) {}

    Scratch& local() {
        if (!scratch_) scratch_.emplace(make_());
        return *scratch_;
    }

  private:
    std::function<Scratch()> make_;
    std::optional<Scratch> scratch_;
};

}  // namespace counterpart::base::no_threads
