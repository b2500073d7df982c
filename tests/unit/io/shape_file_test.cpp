// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/expect_error.hpp"
#include "support/temporary_folder.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/io/file.hpp>
#include <counterpart/io/shape_file.hpp>
#include <counterpart/mesh/shapes.hpp>

#include <filesystem>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

namespace fs = std::filesystem;

class ShapeFile : public testing::Test {
  protected:
    std::vector<fs::path> files() const {
        std::vector<fs::path> found;
        for (const auto& entry : fs::directory_iterator(cache)) found.push_back(entry.path());
        return found;
    }

    const test::TemporaryFolder folder;
    const fs::path cache = folder / "new/cache";
    const TriangleMesh mesh = make_icosphere(2);
    const SpectralShapeOptions options{.basis_size = 30, .n_samples = 200};
    const std::string expected = SpectralShape(mesh, options).to_bytes();
};

TEST_F(ShapeFile, IsReadAsItWasWritten) {
    const fs::path file = folder / "a.shape";
    write_spectral_shape(SpectralShape(mesh, options), file);
    EXPECT_EQ(read_spectral_shape(file).to_bytes(), expected);
    write_file("OFF\n", file);
    test::expect_error<IoError>([&] { read_spectral_shape(file); }, file.string() + ": not a prepared shape");
}

TEST_F(ShapeFile, CacheKeepsWhatItGives) {
    EXPECT_EQ(cached_spectral_shape(cache, mesh, options).shape.to_bytes(), expected);
    ASSERT_EQ(files().size(), 1U);
    // What is there is what is used: another shape put in its place comes back.
    const fs::path file = files().front();
    std::string kept = read_whole_file(file);
    ASSERT_TRUE(kept.ends_with(expected));
    const std::string other = SpectralShape(make_icosphere(1), options).to_bytes();
    write_file(kept.substr(0, kept.size() - expected.size()) + other, file);
    EXPECT_EQ(cached_spectral_shape(cache, mesh, options).shape.to_bytes(), other);
}

TEST_F(ShapeFile, CacheTellsMeshesAndOptionsApart) {
    cached_spectral_shape(cache, mesh, options);
    TriangleMesh moved = mesh, turned = mesh;
    moved.vertices(7, 1) = std::nextafter(moved.vertices(7, 1), 2);
    turned.triangles.row(3) << mesh.triangles(3, 1), mesh.triangles(3, 2), mesh.triangles(3, 0);
    cached_spectral_shape(cache, moved, options);
    cached_spectral_shape(cache, turned, options);
    EXPECT_EQ(files().size(), 3U);
    cached_spectral_shape(cache, mesh, {.basis_size = 31, .n_samples = 200});
    cached_spectral_shape(cache, mesh, {.basis_size = 30, .n_samples = 201});
    cached_spectral_shape(cache, mesh, {.basis_size = 30, .n_samples = 200, .seed = 1});
    cached_spectral_shape(cache, mesh, {.basis_size = 30, .n_samples = 200, .n_threads = 1});
    EXPECT_EQ(files().size(), 6U);
}

TEST_F(ShapeFile, CacheReplacesDamagedFiles) {
    cached_spectral_shape(cache, mesh, options);
    const fs::path file = files().front();
    const std::string whole = read_whole_file(file);
    for (const std::string& damaged :
         {std::string(), std::string("OFF\n"), whole.substr(0, whole.size() / 2)}) {
        write_file(damaged, file);
        EXPECT_EQ(cached_spectral_shape(cache, mesh, options).shape.to_bytes(), expected);
        EXPECT_EQ(read_whole_file(file), whole);
    }
}

TEST_F(ShapeFile, SeveralThreadsShareOneFolder) {
    std::vector<std::thread> callers;
    for (int i = 0; i < 4; ++i)
        callers.emplace_back(
            [&] { EXPECT_EQ(cached_spectral_shape(cache, mesh, options).shape.to_bytes(), expected); });
    for (std::thread& caller : callers) caller.join();
    EXPECT_EQ(files().size(), 1U);
}

TEST_F(ShapeFile, WhatCannotBeKeptIsUsedWithAWarning) {
    EXPECT_TRUE(cached_spectral_shape(cache, mesh, options).warning.empty());
    const fs::path file = files().front();
    fs::remove(file);
    fs::create_directory(file);  // in the way of what would be kept
    const CachedShape found = cached_spectral_shape(cache, mesh, options);
    EXPECT_EQ(found.shape.to_bytes(), expected);
    EXPECT_TRUE(found.warning.starts_with("the prepared shape is used, but not kept: " + file.string()))
        << found.warning;
}

TEST_F(ShapeFile, NamesAFolderThatIsNone) {
    const fs::path file = folder / "file";
    write_file("x", file);
    test::expect_error<WriteError>([&] { cached_spectral_shape(file, mesh, options); },
                                   file.string() + ": cannot be made a folder for prepared shapes");
    EXPECT_THROW(cached_spectral_shape(cache, TriangleMesh{}, options), InvalidInput);
    EXPECT_TRUE(files().empty());
}

}  // namespace
}  // namespace counterpart
