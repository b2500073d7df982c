// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Every file below tests/fuzz/cases once through its target: seeds, and what fuzzing found. One that crashes
// ends the program; one that does not end is stopped by the time limit of CTest.
#include "fuzz/targets.hpp"

#include <counterpart/io/file.hpp>

#include <filesystem>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

class FuzzCases : public testing::TestWithParam<fuzz::Target> {};

TEST_P(FuzzCases, EndWithoutACrash) {
    const std::filesystem::path folder = std::filesystem::path(COUNTERPART_FUZZ_CASES) / GetParam().name;
    int n_cases = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        SCOPED_TRACE(entry.path());
        GetParam().run(read_whole_file(entry.path()));
        ++n_cases;
    }
    EXPECT_GT(n_cases, 0);
}

const auto by_name = [](const auto& info) { return std::string(info.param.name); };
INSTANTIATE_TEST_SUITE_P(Readers, FuzzCases,
                         testing::ValuesIn(fuzz::reader_targets().begin(), fuzz::reader_targets().end()),
                         by_name);
#ifndef COUNTERPART_FUZZ_READERS
INSTANTIATE_TEST_SUITE_P(Matchers, FuzzCases,
                         testing::ValuesIn(fuzz::matcher_targets().begin(), fuzz::matcher_targets().end()),
                         by_name);
#endif

}  // namespace
}  // namespace counterpart
