// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Files made by others: Debian's package assimp-testmodels, skipped where it is not installed.
#include <counterpart/base/errors.hpp>
#include <counterpart/io/gltf.hpp>

#include <filesystem>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

TEST(AssimpTestModels, EachLoadsOrSaysInOneLineWhyNot) {
    const std::filesystem::path folder = "/usr/share/assimp/models";
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << "the package assimp-testmodels is not installed";
    int loaded = 0, refused = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        const std::string extension = entry.path().extension().string();
        if (extension != ".glb" && extension != ".gltf") continue;
        try {
            EXPECT_GT(read_gltf(entry.path()).content.mesh.n_triangles(), 0) << entry.path();
            ++loaded;
        } catch (const IoError& error) {
            EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
            ++refused;
        }
    }
    EXPECT_GT(loaded, 20);
    EXPECT_GT(refused, 0);
}

}  // namespace
}  // namespace counterpart
