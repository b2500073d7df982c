// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "io/landmark_bytes.hpp"
#include "support/expect_error.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/mesh/shapes.hpp>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

using Landmarks = std::vector<std::pair<Index, Index>>;

class ReadLandmarks : public testing::Test {
  protected:
    Landmarks read(const std::string& text) const { return io::parse_landmarks(text, "l.txt", mesh, mesh); }

    const TriangleMesh mesh = make_grid(2, 2);
};

TEST_F(ReadLandmarks, VerticesAndPoints) {
    EXPECT_EQ(read("# a comment\n0 3\n\n2 2 # another\n"), (Landmarks{{0, 3}, {2, 2}}));
    const auto text = [&](Index v) {
        std::string words;
        for (int k = 0; k < 3; ++k) words += std::to_string(mesh.vertices(v, k) + 0.01) + ' ';
        return words;
    };
    EXPECT_EQ(read(text(1) + text(4)), (Landmarks{{1, 4}}));
}

TEST_F(ReadLandmarks, NamesTheLineOfWhatIsNone) {
    const auto refused = [&](const std::string& text, const std::string& words) {
        SCOPED_TRACE(text);
        test::expect_error<IoError>([&] { read(text); }, words);
    };
    refused("", "no landmarks in the file");
    refused("0 1\n0 9\n", "l.txt:2: target vertex 9 is out of range: the mesh has 9 vertices");
    refused("-1 0\n", "l.txt:1: source vertex -1 is out of range");
    refused("0.5 1\n", "l.txt:1: 0.5 is not a vertex number");
    refused("0 1 2\n", "a landmark is two vertex numbers or two points");
    refused("1 2 3 4 5 6 7\n", "a landmark is two vertex numbers or two points");
    refused("0 nan\n", "l.txt:1");
}

}  // namespace
}  // namespace counterpart
