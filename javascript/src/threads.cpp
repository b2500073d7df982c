// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "base/plain_threads.hpp"

#include <algorithm>
#include <thread>

namespace counterpart::javascript {
namespace {

// Emscripten 3.1.6 leaves a variable of a thread at 0 where its first value is computed.
__attribute__((constructor)) void allow_threads() {
    const unsigned n_cores = std::max(2U, std::thread::hardware_concurrency());
    base::plain_threads::allowed = base::plain_threads::can_start() ? static_cast<int>(n_cores) : 1;
}

}  // namespace
}  // namespace counterpart::javascript
