// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// What the program returns, besides 0.
#pragma once

namespace counterpart::cli {

constexpr int refused_code = 1;         // the files or options cannot be used
constexpr int not_understood_code = 2;  // the command line is wrong
constexpr int not_written_code = 3;  // an output could not be written: folder missing, disk full, pipe closed
constexpr int interrupted_code = 130;  // Ctrl-C: 128 + SIGINT

}  // namespace counterpart::cli
