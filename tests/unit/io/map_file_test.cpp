// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/expect_error.hpp"
#include "support/temporary_folder.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/io/map_file.hpp>
#include <counterpart/io/npy.hpp>

#include <gtest/gtest.h>

namespace counterpart::io {
namespace {

using test::TemporaryFolder;

TEST(MapFile, RoundTripsInBothFormatsAndBases) {
    const TemporaryFolder folder;
    const VertexMap map{{4, -1, 0, 2}, 5};
    for (const IndexBase base : {IndexBase::zero, IndexBase::one}) {
        for (const char* name : {"map.txt", "map.npy", "MAP.NPY"}) {
            write_vertex_map(map, folder / name, base);
            EXPECT_EQ(read_vertex_map(folder / name, base), map) << name;
        }
    }
    EXPECT_EQ(read_vertex_map(folder / "map.txt"), (VertexMap{{5, -1, 1, 3}, 6}));
}

TEST(MapFile, TheFormatIsToldInCapitalsToo) {
    const TemporaryFolder folder;
    write_vertex_map({{4, -1}, 5}, folder / "map.Npy");
    EXPECT_EQ(read_npy(folder / "map.Npy"), (Matrix{{4}, {-1}}));
}

TEST(MapFile, TextMayHaveCommentsAndCarriageReturns) {
    const TemporaryFolder folder;
    const auto file = folder.file("map.txt", "# a map\r\n 3 # first\r\n\r\n-1\r\n+0");
    EXPECT_EQ(read_vertex_map(file), (VertexMap{{3, -1, 0}, 4}));
    EXPECT_EQ(read_vertex_map(folder.file("empty.txt", "")), VertexMap{});
}

TEST(MapFile, TheTargetSizeMayBeGivenAndIsChecked) {
    const TemporaryFolder folder;
    for (const char* name : {"map.txt", "map.npy"}) {
        write_vertex_map({{3, -1, 0}, 4}, folder / name);
        EXPECT_EQ(read_vertex_map(folder / name, IndexBase::zero, 9), (VertexMap{{3, -1, 0}, 9})) << name;
        test::expect_error<IoError>([&] { read_vertex_map(folder / name, IndexBase::zero, 3); },
                                    std::string(name) + ": the map takes source vertex 0 to 3");
    }
}

TEST(MapFile, NamesLineAndReason) {
    const TemporaryFolder folder;
    const auto refused = [&](std::string_view text, const std::string& part,
                             IndexBase base = IndexBase::zero) {
        test::expect_error<IoError>([&] { read_vertex_map(folder.file("map.txt", text), base); }, part);
    };
    refused("1\n2.5\n", "map.txt:2: expected a whole number (target vertex), found '2.5'");
    refused("1\n2 3\n", "map.txt:2: expected one whole number, found more");
    refused("1\n-2\n", "map.txt:2: vertex -2 is out of range; vertices count from 0");
    refused("1\n0\n", "map.txt:2: vertex 0 is out of range; vertices count from 1", IndexBase::one);
    refused("2147483647\n", "map.txt:1: vertex 2147483647 is out of range");
    refused("99999999999999999999\n", "map.txt:1: target vertex is out of range");
    test::expect_error<IoError>([&] { read_vertex_map(folder / "absent.txt"); }, "cannot be opened");
    write_vertex_map({{0, 1}, 2}, folder / "map.npy");
    test::expect_error<IoError>([&] { read_vertex_map(folder / "map.npy", IndexBase::one); },
                                "entry 0: vertex 0");
}

}  // namespace
}  // namespace counterpart::io
