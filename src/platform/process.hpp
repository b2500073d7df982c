// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// What a program asks of the system that runs it.
#pragma once

#include <string>
#include <vector>

namespace counterpart::platform {

/// How many threads may run at the same time, at least 1.
int n_processors();

/// The number of this process: another in one that is forked.
long process_number();

/// The words that the program was called with, its name among them, in UTF-8. From here on what it prints is
/// taken for UTF-8, and passes as it is.
std::vector<std::string> command_line(int argc, char** argv);

/// Whether standard error is a terminal, on which lines can be drawn anew.
bool is_terminal();

/// The most memory that the process has held, bytes.
double peak_memory();

/// Lets a program take over whose name is words.front(), where it lies beside this one or on the PATH, with
/// all the words. Returns if there is none.
void replace_by_program(std::vector<std::string> words);

/// From here on being interrupted (Ctrl-C, SIGTERM) is noted; a second time, or `patience` seconds after the
/// first, it ends the process with this code. Writing to a pipe that nobody reads fails and does not end it.
void note_interrupts(int exit_code, unsigned patience);
bool was_interrupted();

}  // namespace counterpart::platform
