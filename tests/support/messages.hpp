// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/message.hpp>

#include <string>
#include <vector>

namespace counterpart::test {

/// A line for each: "close_runner_up, caution: ..."
inline std::string lines_of(const std::vector<Message>& messages) {
    std::string lines;
    for (const Message& message : messages)
        lines +=
            to_string(message.code) + ", " + to_string(message.severity) + ": " + to_string(message) + "\n";
    return lines;
}

}  // namespace counterpart::test
