// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "platform/process.hpp"

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <thread>

#include <windows.h>
// After it.
#include <fcntl.h>
#include <io.h>
#include <process.h>
#include <psapi.h>
#include <shellapi.h>

namespace counterpart::platform {
namespace {

std::atomic<bool> interrupted = false;
std::atomic<unsigned> code_of_interrupted = 1, seconds_left = 1;

// On a thread of its own.
BOOL WINAPI on_interrupt(DWORD /*event*/) {
    if (!interrupted.exchange(true)) Sleep(1000 * seconds_left);
    ExitProcess(code_of_interrupted);
}

std::string utf8(const wchar_t* text) {
    const int size =
        WideCharToMultiByte(CP_UTF8, 0, text, -1, nullptr, 0, nullptr, nullptr);  // with the final 0
    std::string result(static_cast<std::size_t>(std::max(size, 1)), '\0');
    WideCharToMultiByte(CP_UTF8, 0, text, -1, result.data(), size, nullptr, nullptr);
    result.pop_back();
    return result;
}

std::wstring wide(const std::string& text) {
    return std::filesystem::path(std::u8string(text.begin(), text.end())).native();
}

// As CommandLineToArgvW reads it: quoted, with the backslashes before a quote doubled.
std::wstring quoted(const std::wstring& word) {
    std::wstring result = L"\"";
    std::size_t backslashes = 0;
    for (const wchar_t c : word) {
        if (c == L'"') result.append(backslashes + 1, L'\\');
        backslashes = c == L'\\' ? backslashes + 1 : 0;
        result += c;
    }
    return result.append(backslashes, L'\\') + L"\"";
}

std::filesystem::path own_folder() {
    std::wstring name(32768, L'\0');
    name.resize(GetModuleFileNameW(nullptr, name.data(), static_cast<DWORD>(name.size())));
    return std::filesystem::path(name).parent_path();
}

}  // namespace

int n_processors() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency())); }

long process_number() { return static_cast<long>(GetCurrentProcessId()); }

std::vector<std::string> command_line(int argc, char** argv) {
    SetConsoleOutputCP(CP_UTF8);
    _setmode(_fileno(stdout), _O_BINARY);
    _setmode(_fileno(stderr), _O_BINARY);
    int count = 0;
    wchar_t** const words = CommandLineToArgvW(GetCommandLineW(), &count);
    if (words == nullptr) return {argv, argv + argc};
    std::vector<std::string> result;
    for (int i = 0; i < count; ++i) result.push_back(utf8(words[i]));
    LocalFree(static_cast<void*>(words));
    return result;
}

bool is_terminal() {
    const HANDLE console = GetStdHandle(STD_ERROR_HANDLE);
    DWORD mode = 0;
    return GetConsoleMode(console, &mode) != 0 &&
           SetConsoleMode(console, mode | ENABLE_VIRTUAL_TERMINAL_PROCESSING) != 0;
}

double peak_memory() {
    PROCESS_MEMORY_COUNTERS counters = {};
    GetProcessMemoryInfo(GetCurrentProcess(), &counters, sizeof counters);
    return static_cast<double>(counters.PeakWorkingSetSize);
}

void replace_by_program(std::vector<std::string> words) {
    // No process takes the place of another here: this one waits, and ends as that does.
    const std::wstring file = wide(words.front()) + L".exe";
    std::vector<std::wstring> given;
    for (const std::string& word : words) given.push_back(quoted(wide(word)));
    std::vector<const wchar_t*> arguments;
    for (const std::wstring& word : given) arguments.push_back(word.c_str());
    arguments.push_back(nullptr);
    intptr_t code = _wspawnv(_P_WAIT, (own_folder() / file).c_str(), arguments.data());
    if (code == -1) code = _wspawnvp(_P_WAIT, file.c_str(), arguments.data());
    if (code != -1) std::exit(static_cast<int>(code));
}

void note_interrupts(int exit_code, unsigned patience) {
    code_of_interrupted = static_cast<unsigned>(exit_code);
    seconds_left = patience;
    SetConsoleCtrlHandler(on_interrupt, TRUE);
}

bool was_interrupted() { return interrupted; }

}  // namespace counterpart::platform
