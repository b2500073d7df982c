// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/match/spectral.hpp>

#include <filesystem>
#include <string>

namespace counterpart {

/// Reads a shape that write_spectral_shape wrote. Throws IoError naming the file and the reason, also for a
/// shape that another version of the project wrote.
SpectralShape read_spectral_shape(const std::filesystem::path& file);

/// Whole or not at all. Throws WriteError.
void write_spectral_shape(const SpectralShape& shape, const std::filesystem::path& file);

struct CachedShape {
    SpectralShape shape;
    std::string warning{};  ///< a sentence, if it could not be kept: a full disk
};

/// The prepared shape of the mesh, from a file in `folder` if there is one for exactly this mesh (every
/// digit, in this order) and these options, else prepared and kept there: N meshes matched with each other
/// are prepared N times, not N^2. The folder is made if it is missing. Any number of threads and processes
/// may share it; a file that is damaged or of another version is replaced. Nothing is ever removed: delete
/// the folder. Throws what SpectralShape throws, and WriteError if the folder cannot be made.
CachedShape cached_spectral_shape(const std::filesystem::path& folder, MeshView mesh,
                                  const SpectralShapeOptions& options = {});

}  // namespace counterpart
