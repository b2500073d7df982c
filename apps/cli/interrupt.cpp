// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "interrupt.hpp"

#include "exit_codes.hpp"

#include <csignal>

#include <unistd.h>

namespace counterpart::cli {
namespace {

// A signal handler can reach nothing but a global.
volatile std::sig_atomic_t interrupted = 0;

constexpr unsigned patience = 1;  // seconds until work that does not report is ended

extern "C" void on_interrupt(int /*signal*/) {
    if (interrupted != 0) _exit(interrupted_code);  // asked twice
    interrupted = 1;
    alarm(patience);
}

extern "C" void on_alarm(int /*signal*/) { _exit(interrupted_code); }

}  // namespace

void cancel_on_interrupt() {
    std::signal(SIGINT, on_interrupt);
    std::signal(SIGTERM, on_interrupt);
    std::signal(SIGALRM, on_alarm);
    std::signal(SIGPIPE, SIG_IGN);  // writing to a closed pipe fails instead: ClosedPipe
}

bool is_interrupted() { return interrupted != 0; }

}  // namespace counterpart::cli
