// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "platform/process.hpp"

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <system_error>
#include <thread>

#include <sys/resource.h>
#include <unistd.h>
#ifdef __linux__
#include <sched.h>
#endif
#ifdef __APPLE__
#include <mach-o/dyld.h>
#endif

namespace counterpart::platform {
namespace {

// A signal handler can reach nothing but a global.
volatile std::sig_atomic_t interrupted = 0;
volatile std::sig_atomic_t interrupted_code = 1, seconds_left = 1;

extern "C" void on_interrupt(int /*signal*/) {
    if (interrupted != 0) _exit(interrupted_code);  // asked twice
    interrupted = 1;
    alarm(static_cast<unsigned>(seconds_left));
}

extern "C" void on_alarm(int /*signal*/) { _exit(interrupted_code); }

// Empty where the system does not say.
std::filesystem::path own_folder() {
#ifdef __APPLE__
    std::string name(4096, '\0');
    auto size = static_cast<std::uint32_t>(name.size());
    if (_NSGetExecutablePath(name.data(), &size) != 0) return {};
    return std::filesystem::path(name.c_str()).parent_path();
#else
    std::error_code none;
    return std::filesystem::read_symlink("/proc/self/exe", none).parent_path();
#endif
}

}  // namespace

int n_processors() {
#ifdef __linux__
    cpu_set_t allowed;  // to this process: by taskset, by a container
    if (sched_getaffinity(0, sizeof allowed, &allowed) == 0) return std::max(1, CPU_COUNT(&allowed));
#endif
    return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

long process_number() { return getpid(); }

std::vector<std::string> command_line(int argc, char** argv) { return {argv, argv + argc}; }

bool is_terminal() { return isatty(STDERR_FILENO) != 0; }

double peak_memory() {
    struct rusage usage = {};
    getrusage(RUSAGE_SELF, &usage);
#ifdef __APPLE__
    constexpr double unit = 1;
#else
    constexpr double unit = 1024;
#endif
    return unit * static_cast<double>(usage.ru_maxrss);
}

void replace_by_program(std::vector<std::string> words) {
    const std::string name = words.front();
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    const std::filesystem::path folder = own_folder();
    if (!folder.empty()) execv((folder / name).c_str(), arguments.data());
    execvp(name.c_str(), arguments.data());
}

void note_interrupts(int exit_code, unsigned patience) {
    interrupted_code = exit_code;
    seconds_left = static_cast<std::sig_atomic_t>(patience);
    std::signal(SIGINT, on_interrupt);
    std::signal(SIGTERM, on_interrupt);
    std::signal(SIGALRM, on_alarm);
    std::signal(SIGPIPE, SIG_IGN);
}

bool was_interrupted() { return interrupted != 0; }

}  // namespace counterpart::platform
