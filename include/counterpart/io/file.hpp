// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/errors.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace counterpart {

struct ReadOptions {
    /// Follow what a glTF file names outside its own folder: absolute paths, "..", links that lead out. Off,
    /// such a file is refused, because what it names would become part of what is written.
    bool allow_external = false;
    /// Refuse what is else left out with a notice: vertices whose coordinates are no numbers.
    bool strict = false;
    /// Read this object alone: the one of that name or, if none has it, of that number, as mesh_objects lists
    /// them (io/mesh_objects.hpp). Nothing: the whole file.
    std::optional<std::string> object{};
};

/// A file cannot be written: no such folder, no permission, a full disk, a closed pipe.
struct WriteError : IoError {
    using IoError::IoError;
};

/// Who was reading has stopped: nothing worth a message, as in `counterpart manual bash | head`.
struct ClosedPipe : WriteError {
    using WriteError::WriteError;
};

/// The extension in lower case, with its dot: ".obj" for "Mesh.OBJ". It decides the format.
std::string lower_extension(const std::filesystem::path& file);

/// Whether the name ends in .glb or .gltf, in any case.
bool is_gltf(const std::filesystem::path& file);

/// All bytes of a file. Throws IoError naming the file if it does not exist, is a folder, or cannot be read.
std::string read_whole_file(const std::filesystem::path& file);

/// Writes `bytes` to `file` whole or not at all: beside it first, then renamed. Links are followed, and the
/// permissions of a file that is replaced are kept. Devices and pipes (/dev/stdout, a FIFO) are written in
/// place. Several threads and processes may write one file: one of them wins. What a writer that was killed
/// left beside the file is removed. Throws WriteError naming file and reason, also for a file that may not
/// be written; of these ClosedPipe for a pipe that nobody reads any more.
void write_file(std::string_view bytes, const std::filesystem::path& file);

}  // namespace counterpart
