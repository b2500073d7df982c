// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/expect_error.hpp"
#include "support/temporary_folder.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/io/file.hpp>

#include <csignal>
#include <fstream>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace counterpart::io {
namespace {

namespace fs = std::filesystem;

auto n_files(const test::TemporaryFolder& folder) {
    return std::distance(fs::directory_iterator(folder / "."), {});
}

TEST(AtomicFile, WritesAndReplaces) {
    const test::TemporaryFolder folder;
    write_file("one", folder / "a");
    write_file(std::string_view("two\0lines\n", 10), folder / "a");
    EXPECT_EQ(read_whole_file(folder / "a"), std::string("two\0lines\n", 10));
    EXPECT_EQ(n_files(folder), 1);
}

TEST(AtomicFile, LeavesNothingBehindWhenItFails) {
    const test::TemporaryFolder folder;
    fs::create_directory(folder / "taken");
    write_file("x", folder / "taken" / "file");
    EXPECT_THROW(write_file("y", folder / "taken"), IoError);
    EXPECT_THROW(write_file("y", folder / "absent" / "file"), IoError);
    EXPECT_EQ(n_files(folder), 1);
}

TEST(AtomicFile, FollowsLinks) {
    const test::TemporaryFolder folder;
    fs::create_directory(folder / "real");
    fs::create_directory_symlink("real", folder / "way");
    fs::create_symlink("way/file", folder / "second");
    fs::create_symlink(folder / "second", folder / "first");
    for (const char* text : {"created", "replaced"}) {
        write_file(text, folder / "first");
        EXPECT_EQ(read_whole_file(folder / "real" / "file"), text);
    }
    EXPECT_TRUE(fs::is_symlink(folder / "first") && fs::is_symlink(folder / "second"));
    fs::create_symlink("circle", folder / "circle");
    EXPECT_THROW(write_file("x", folder / "circle"), IoError);
}

TEST(AtomicFile, WritesThroughDevicesAndPipes) {
    const test::TemporaryFolder folder;
    fs::create_symlink("/dev/null", folder / "null");
    write_file("lost", folder / "null");
    EXPECT_TRUE(fs::is_character_file(folder / "null"));

    const fs::path pipe = folder / "pipe";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    std::string received;
    std::thread reader([&] { received = read_whole_file(pipe); });
    const std::string sent(1 << 20, 'x');  // more than a pipe holds
    write_file(sent, pipe);
    reader.join();
    EXPECT_EQ(received, sent);
    EXPECT_TRUE(fs::is_fifo(pipe));

    // What a process has open, as /dev/stdout is.
    const int open_file = open((folder / "open").c_str(), O_RDWR | O_CREAT, 0600);
    ASSERT_GE(open_file, 0);
    fs::create_symlink("/proc/self/fd/" + std::to_string(open_file), folder / "stdout");
    write_file("in place", folder / "stdout");
    std::string read_back(8, ' ');
    EXPECT_EQ(pread(open_file, read_back.data(), 8, 0), 8);
    EXPECT_EQ(read_back, "in place");
    close(open_file);
    EXPECT_EQ(n_files(folder), 4);
}

TEST(AtomicFile, KeepsThePermissionsOfWhatItReplaces) {
    const test::TemporaryFolder folder;
    write_file("before", folder / "a");
    fs::permissions(folder / "a", fs::perms::owner_read | fs::perms::owner_write);
    write_file("after", folder / "a");
    EXPECT_EQ(fs::status(folder / "a").permissions(), fs::perms::owner_read | fs::perms::owner_write);
    fs::permissions(folder / "a", fs::perms::owner_read);
    if (geteuid() != 0) {  // root may write everything
        test::expect_error<IoError>([&] { write_file("x", folder / "a"); }, "cannot be written here");
        EXPECT_EQ(read_whole_file(folder / "a"), "after");
    }
}

TEST(AtomicFile, ThreadsMayWriteOneFile) {
    const test::TemporaryFolder folder;
    constexpr int n_threads = 8, n_rounds = 300;
    constexpr std::size_t size = 20'000;
    std::vector<std::thread> writers;
    for (int i = 0; i < n_threads; ++i) {
        writers.emplace_back([&folder, i] {
            const std::string mine(size, static_cast<char>('a' + i));
            for (int round = 0; round < n_rounds; ++round) {
                write_file(mine, folder / "a");
                const std::string there = read_whole_file(folder / "a");
                EXPECT_EQ(there, std::string(size, there.at(0)));  // somebody's, whole
            }
        });
    }
    for (std::thread& writer : writers) writer.join();
    EXPECT_EQ(n_files(folder), 1);
}

TEST(AtomicFile, WhatKilledWritersLeftIsRemoved) {
    const test::TemporaryFolder folder;
    for (const char* name : {"a.0.part", "a.1.part", "a.2.part", "a.1.part.part", "b.0.part", "a.x.part"})
        std::ofstream(folder / name) << "half, and longer than what comes";
    write_file("whole", folder / "a");
    EXPECT_EQ(read_whole_file(folder / "a"), "whole");
    for (const char* name : {"a.0.part", "a.1.part", "a.2.part"})
        EXPECT_FALSE(fs::exists(folder / name)) << name;
    for (const char* name : {"a.1.part.part", "b.0.part", "a.x.part"})
        EXPECT_TRUE(fs::exists(folder / name)) << name;
    // One whose writer lives is locked.
    const fs::path busy = folder / "a.0.part";
    const int writer = open(busy.c_str(), O_WRONLY | O_CREAT, 0600);
    ASSERT_EQ(flock(writer, LOCK_EX), 0);
    write_file("again", folder / "a");
    EXPECT_TRUE(fs::exists(busy));
    close(writer);
    write_file("again", folder / "a");
    EXPECT_FALSE(fs::exists(busy));
}

TEST(AtomicFile, WhatIsInTheWayIsLeftAlone) {
    const test::TemporaryFolder folder;
    write_file("precious", folder / "other");
    fs::create_symlink("other", folder / "a.0.part");
    fs::create_hard_link(folder / "other", folder / "a.1.part");
    fs::create_directory(folder / "a.2.part");
    ASSERT_EQ(mkfifo((folder / "a.3.part").c_str(), 0600), 0);
    write_file("whole", folder / "a");
    EXPECT_EQ(read_whole_file(folder / "a"), "whole");
    EXPECT_EQ(read_whole_file(folder / "other"), "precious");
    EXPECT_EQ(n_files(folder), 6);
}

// Where many maps go into one folder, listing it at each would take the square of their number.
TEST(AtomicFile, TheFolderIsNotListed) {
    const test::TemporaryFolder folder;
    const fs::path unlisted = folder / "unlisted";
    fs::create_directory(unlisted);
    fs::permissions(folder / ".", fs::perms::all);
    fs::permissions(unlisted, fs::perms(0333));
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
        if (geteuid() == 0 && setuid(65534) != 0) _exit(2);  // root may list every folder, nobody may not
        try {
            write_file("x", unlisted / "a");
        } catch (const std::exception&) {
            _exit(1);
        }
        _exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
    fs::permissions(unlisted, fs::perms::all);
    EXPECT_EQ(read_whole_file(unlisted / "a"), "x");
}

TEST(AtomicFile, AKilledWriterLeavesTheOldFileOrTheNew) {
    const test::TemporaryFolder folder;
    const fs::path file = folder / "a";
    const std::string before(1 << 20, 'b'), after(1 << 20, 'a');
    for (int round = 0; round < 20; ++round) {
        write_file(before, file);
        const pid_t child = fork();
        ASSERT_GE(child, 0);
        if (child == 0) {
            for (;;) write_file(after, file);
        }
        usleep(static_cast<useconds_t>(100 + 137 * round));
        kill(child, SIGKILL);
        waitpid(child, nullptr, 0);
        const std::string there = read_whole_file(file);
        EXPECT_TRUE(there == before || there == after) << round;
    }
    write_file(before, file);
    EXPECT_EQ(n_files(folder), 1);
}

}  // namespace
}  // namespace counterpart::io
