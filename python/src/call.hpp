// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/progress.hpp>

#include <chrono>
#include <optional>
#include <string>
#include <utility>

#include <nanobind/nanobind.h>

namespace counterpart::python {

namespace nb = nanobind;

/// Between a running function, which does not hold the interpreter's lock, and the interpreter: Ctrl-C and
/// the caller's callback, whose return of False cancels and whose exception is passed on.
class Monitor {
  public:
    explicit Monitor(nb::object callback) : callback_(std::move(callback)) {}

    Progress progress() {
        return [this](double fraction) { return report(fraction); };
    }
    /// Throws what a callback or Ctrl-C raised, if anything did.
    void raise_pending() {
        if (pending_) throw nb::python_error(std::move(*pending_));
    }

  private:
    bool report(double fraction) {
        // The lock may be busy: not at every step.
        const auto now = std::chrono::steady_clock::now();
        if (fraction < 1 && now - last_ < std::chrono::milliseconds(50)) return true;
        last_ = now;
        const nb::gil_scoped_acquire lock;
        try {
            if (PyErr_CheckSignals() != 0) nb::raise_python_error();
            return callback_.is_none() || !callback_(fraction).is(nb::bool_(false));
        } catch (nb::python_error& error) {
            pending_.emplace(std::move(error));
            return false;
        }
    }

    nb::object callback_;
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
    std::optional<nb::python_error> pending_;
};

/// A UserWarning, unless there is nothing to say. Needs the interpreter's lock.
inline void warn(const std::string& sentence) {
    if (!sentence.empty() && PyErr_WarnEx(PyExc_UserWarning, sentence.c_str(), 1) != 0)
        nb::raise_python_error();
}

/// Runs `work(progress)` without the interpreter's lock. `callback` is None or takes the fraction done.
template <class Work>
auto run(const nb::object& callback, const Work& work) {
    Monitor monitor(callback);
    try {
        const nb::gil_scoped_release release;
        return work(monitor.progress());
    } catch (const Canceled&) {
        monitor.raise_pending();
        throw;
    }
}

/// Runs `work()` without the interpreter's lock.
template <class Work>
auto run(const Work& work) {
    const nb::gil_scoped_release release;
    return work();
}

}  // namespace counterpart::python
