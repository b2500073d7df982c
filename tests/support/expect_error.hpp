// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <gtest/gtest.h>

namespace counterpart::test {

/// Expects that `action` throws Error with a one-line message that contains `part`.
template <class Error, class Action>
void expect_error(const Action& action, const std::string& part) {
    try {
        action();
        ADD_FAILURE() << "nothing was thrown; expected a message with: " << part;
    } catch (const Error& error) {
        const std::string message = error.what();
        EXPECT_NE(message.find(part), std::string::npos) << message << "\n  does not contain: " << part;
        EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    }
}

}  // namespace counterpart::test
