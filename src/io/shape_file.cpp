// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "base/hash_mixing.hpp"
#include "platform/files.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/io/file.hpp>
#include <counterpart/io/shape_file.hpp>

#include <algorithm>
#include <cstring>
#include <optional>
#include <string>

#include <fmt/format.h>

namespace counterpart {
namespace {

// What a kept file begins with: everything that the shape depends on, so that it is used for nothing else.
std::string key_of(MeshView mesh, const SpectralShapeOptions& options) {
    std::string key = fmt::format(
        "counterpart cache: {} functions, {} samples, seed {}, {} vertices, {} triangles\n",
        options.basis_size, options.n_samples, options.seed, mesh.n_vertices(), mesh.n_triangles());
    const auto append = [&](const auto& array) {
        key.append(reinterpret_cast<const char*>(array.data()),
                   static_cast<std::size_t>(array.size()) * sizeof(*array.data()));
    };
    append(mesh.vertices);
    append(mesh.triangles);
    return key;
}

std::uint64_t hash_of(std::string_view bytes) {
    std::uint64_t hash = bytes.size();
    for (; !bytes.empty(); bytes.remove_prefix(std::min(bytes.size(), sizeof(std::uint64_t)))) {
        std::uint64_t word = 0;
        std::memcpy(&word, bytes.data(), std::min(bytes.size(), sizeof word));
        hash = mixed(word, hash);
    }
    return hash;
}

// Nothing if there is no file, or none that is of use.
std::optional<SpectralShape> kept_shape(const std::filesystem::path& file, std::string_view key) {
    if (!std::filesystem::is_regular_file(file)) return std::nullopt;
    try {
        const std::string bytes = read_whole_file(file);
        if (!bytes.starts_with(key)) return std::nullopt;
        return SpectralShape::from_bytes(std::string_view(bytes).substr(key.size()));
    } catch (const InvalidInput&) {  // damaged, or of another version
        return std::nullopt;
    } catch (const IoError&) {  // gone by now
        return std::nullopt;
    }
}

}  // namespace

SpectralShape read_spectral_shape(const std::filesystem::path& file) {
    const std::string bytes = read_whole_file(file);
    try {
        return SpectralShape::from_bytes(bytes);
    } catch (const InvalidInput& error) {
        throw IoError(fmt::format("{}: {}", platform::utf8_name(file), error.what()));
    }
}

void write_spectral_shape(const SpectralShape& shape, const std::filesystem::path& file) {
    write_file(shape.to_bytes(), file);
}

CachedShape cached_spectral_shape(const std::filesystem::path& folder, MeshView mesh,
                                  const SpectralShapeOptions& options) {
    std::error_code failure;
    std::filesystem::create_directories(folder, failure);
    if (failure || !std::filesystem::is_directory(folder))
        throw WriteError(fmt::format("{}: cannot be made a folder for prepared shapes{}{}",
                                     platform::utf8_name(folder), failure ? ": " : "",
                                     failure ? failure.message() : ""));
    const std::string key = key_of(mesh, options);
    const std::filesystem::path file = folder / fmt::format("{:016x}.shape", hash_of(key));
    if (std::optional<SpectralShape> kept = kept_shape(file, key)) {
        report_progress(options.progress, 1);
        return {*std::move(kept)};
    }
    CachedShape made{SpectralShape(mesh, options)};
    try {
        write_file(key + made.shape.to_bytes(), file);
    } catch (const WriteError& error) {  // what was computed is worth more than that it is kept
        made.warning = fmt::format("the prepared shape is used, but not kept: {}", error.what());
    }
    return made;
}

}  // namespace counterpart
