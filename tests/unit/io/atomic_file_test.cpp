// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "io/whole_file.hpp"
#include "support/temporary_folder.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/io/atomic_file.hpp>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

TEST(AtomicFile, WritesAndReplaces) {
    const test::TemporaryFolder folder;
    write_file("one", folder / "a");
    write_file(std::string_view("two\0lines\n", 10), folder / "a");
    EXPECT_EQ(read_whole_file(folder / "a"), std::string("two\0lines\n", 10));
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder / "."), {}), 1);
}

TEST(AtomicFile, LeavesNothingBehindWhenItFails) {
    const test::TemporaryFolder folder;
    std::filesystem::create_directory(folder / "taken");
    write_file("x", folder / "taken" / "file");
    EXPECT_THROW(write_file("y", folder / "taken"), IoError);
    EXPECT_THROW(write_file("y", folder / "absent" / "file"), IoError);
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder / "."), {}), 1);
}

}  // namespace
}  // namespace counterpart
