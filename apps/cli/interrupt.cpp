// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "interrupt.hpp"

#include "exit_codes.hpp"
#include "platform/process.hpp"

namespace counterpart::cli {

void cancel_on_interrupt() {
    constexpr unsigned patience = 1;  // seconds until work that does not report is ended
    platform::note_interrupts(interrupted_code, patience);
}

bool is_interrupted() { return platform::was_interrupted(); }

}  // namespace counterpart::cli
