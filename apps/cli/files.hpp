// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// The files of a command: declared with its options, checked before its work begins.
#pragma once

#include "platform/files.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace counterpart::cli {

using platform::utf8_name;

/// What an output file holds, which decides the endings that fit.
enum class Content { mesh, map, matrix, landmarks, page, picture, table, report, frames, prefix, folder };

/// A mesh file that is read, and the object of it that is meant; nothing: all of them.
struct MeshInput {
    std::filesystem::path file{};
    std::optional<std::string> object{};

    operator const std::filesystem::path&() const { return file; }
    /// "scene.obj" or "scene.obj, object 'arm'".
    std::string words() const;
};

/// An option or positional that names files.
struct FileArgument {
    std::string option;  // "SOURCE", "--map"
    std::filesystem::path* file = nullptr;
    std::vector<std::filesystem::path>* several = nullptr;  // instead of `file`
    std::optional<Content> written;                         // nothing: it is read
    const MeshInput* mesh = nullptr;                        // that it is the file of
    std::string object_option{};                            // "--source-object"

    std::vector<std::filesystem::path*> names() const;
};
using FileArguments = std::vector<FileArgument>;

/// An option or positional that is the name of a file, on every system in UTF-8.
CLI::Option* add_path(CLI::App& command, const std::string& name, std::filesystem::path& path,
                      const std::string& help);
/// An option for a file that is read.
CLI::Option* add_input(CLI::App& command, FileArguments& files, const std::string& name,
                       std::filesystem::path& file, const std::string& help);
CLI::Option* add_input(CLI::App& command, FileArguments& files, const std::string& name,
                       std::vector<std::filesystem::path>& several, const std::string& help);
/// A mesh, and the option `object` that chooses one of its objects; returns the former.
CLI::Option* add_mesh(CLI::App& command, FileArguments& files, const std::string& name,
                      const std::string& object, MeshInput& mesh, const std::string& help);
/// An option for a file that is written; '-' is standard output.
CLI::Option* add_output(CLI::App& command, FileArguments& files, const std::string& name,
                        std::filesystem::path& file, Content content, const std::string& help);

/// Refuses what would be found out only after the work: an output that is an input or another output, an
/// ending that does not fit, a folder that does not exist, a file that may not be written. Replaces '-' by
/// /dev/stdout. Throws InvalidInput naming the options, and WriteError.
void check_files(const FileArguments& files);

/// On standard output; throws WriteError if it cannot be written (a full disk, a closed pipe).
void print(const std::string& text);

}  // namespace counterpart::cli
