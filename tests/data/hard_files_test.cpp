// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/data.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/io/mesh_file.hpp>
#include <counterpart/mesh/analyze.hpp>

#include <map>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

TEST(HardFiles, AreReadAndAnalyzedOrRefusedInOneLine) {
    COUNTERPART_REQUIRE_DATA("hard");
    std::map<std::string, std::string> refused;
    for (const auto& entry : std::filesystem::directory_iterator(test::data_folder() / "hard")) {
        SCOPED_TRACE(entry.path().string());
        try {
            const MeshFile file = read_mesh(entry.path());
            const MeshReport report = analyze(file.mesh);
            Index in_pieces = 0;
            for (const ComponentReport& piece : report.components) in_pieces += piece.n_vertices;
            EXPECT_EQ(in_pieces + report.n_isolated_vertices, report.n_vertices);
        } catch (const IoError& error) {
            EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
            refused[entry.path().filename().string()] = error.what();
        }
    }
    EXPECT_TRUE(refused.contains("empty.obj") && refused.contains("empty.ply"));
    EXPECT_NE(refused["notenoughindices.obj"].find(":9: a face needs at least 3 corners"), std::string::npos);
    EXPECT_EQ(refused.size(), 3U);
}

TEST(HardFiles, ReportsWhatIsUnusual) {
    COUNTERPART_REQUIRE_DATA("hard");
    const auto report = [](const char* name) {
        return analyze(read_mesh(test::data_folder() / "hard" / name).mesh);
    };
    EXPECT_FALSE(report("moebius.obj").components.at(0).is_orientable);
    EXPECT_EQ(report("3holes.off").components.at(0).genus(), 3);
    EXPECT_EQ(report("annulus.obj").n_boundary_loops, 2);
    EXPECT_EQ(report("fan3.obj").n_nonmanifold_edges, 1);
    EXPECT_GT(report("hourglass_ico.obj").n_nonmanifold_vertices, 0);
    EXPECT_EQ(report("sliver_tet.ply").n_isolated_vertices, 5009 - 4);
    EXPECT_EQ(report("two_objects.obj").components.size(), 2U);
    EXPECT_EQ(report("suzanne.ply").n_duplicate_vertices, 1461);
    EXPECT_EQ(report("truck.obj").n_nonmanifold_edges, 54);
}

}  // namespace
}  // namespace counterpart
