// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include <gtest/gtest.h>

namespace counterpart::test {

/// The measuring data: environment variable COUNTERPART_DATA, or the folder beside the checkout.
std::filesystem::path data_folder();

}  // namespace counterpart::test

/// Ends the running test as skipped where the measuring data is absent.
#define COUNTERPART_REQUIRE_DATA(subfolder)                                                     \
    if (!std::filesystem::exists(counterpart::test::data_folder() / (subfolder)))               \
    GTEST_SKIP() << "no measuring data at " << (counterpart::test::data_folder() / (subfolder)) \
                 << " (set COUNTERPART_DATA)"
