// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Files made by others: Debian's package assimp-testmodels, skipped where it is not installed.
#include "support/gltf_accessors.hpp"
#include "support/temporary_folder.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/io/gltf.hpp>

#include <filesystem>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

TEST(AssimpTestModels, EachComesBackAsItWasOrTheErrorIsOneLine) {
    const test::TemporaryFolder output;
    const std::filesystem::path folder = "/usr/share/assimp/models";
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << "the package assimp-testmodels is not installed";
    int loaded = 0, written = 0, refused = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        const std::string extension = entry.path().extension().string();
        if (extension != ".glb" && extension != ".gltf") continue;
        try {
            const AttributedMesh content = read_gltf(entry.path()).content;
            EXPECT_GT(content.mesh.n_triangles(), 0) << entry.path();
            ++loaded;
            for (const char* name : {"copy.glb", "copy.gltf"}) {
                write_gltf(content, output / name);
                EXPECT_EQ(test::accessor_difference(entry.path(), output / name), "") << entry.path();
            }
            ++written;
        } catch (const IoError& error) {
            EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
            ++refused;
        }
    }
    EXPECT_GT(loaded, 20);
    EXPECT_GT(written, 20);
    EXPECT_GT(refused, 0);
}

}  // namespace
}  // namespace counterpart
