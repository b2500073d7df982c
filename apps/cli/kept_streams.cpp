// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "kept_streams.hpp"

#include "platform/files.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/io/file.hpp>
#include <counterpart/io/mesh_file.hpp>

#include <random>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace counterpart::cli {
namespace {

namespace fs = std::filesystem;

bool is_read_once(const fs::path& file) {
    std::error_code ignored;
    const fs::file_status status = fs::status(file, ignored);
    return file == platform::standard_input || fs::is_fifo(status) || fs::is_socket(status);
}

// Of this process alone, and closed to other users.
fs::path new_folder() {
    std::random_device random;
    for (int attempt = 0; attempt < 100; ++attempt) {
        fs::path folder =
            fs::temp_directory_path() / fmt::format("counterpart-{:08x}{:08x}", random(), random());
        std::error_code error;
        if (!fs::create_directory(folder, error)) continue;
        fs::permissions(folder, fs::perms::owner_all, error);
        return folder;
    }
    throw WriteError(fmt::format("{}: no folder can be made there for what is read from a pipe",
                                 utf8_name(fs::temp_directory_path())));
}

std::string ending_of(const FileArgument& argument, const fs::path& file, const std::string& bytes) {
    if (file.has_extension()) return lower_extension(file);
    if (bytes.starts_with("\x93NUMPY")) return ".npy";
    if (argument.mesh == nullptr && argument.several == nullptr) return ".txt";  // a map, landmarks
    std::string ending = recognized_extension(bytes);
    if (ending.empty())
        throw InvalidInput(fmt::format("{} {}: no mesh begins so; write it to a file whose name ends in {}",
                                       argument.option, utf8_name(file),
                                       fmt::join(mesh_extensions().read, ", ")));
    return ending;
}

}  // namespace

KeptStreams::KeptStreams(const FileArguments& files) {
    std::string at_standard_input;
    for (const FileArgument& argument : files) {
        if (argument.written) continue;
        for (fs::path* file : argument.names()) {
            if (*file == "-") *file = platform::standard_input;
            if (!is_read_once(*file)) continue;
            if (*file == platform::standard_input && !at_standard_input.empty())
                throw InvalidInput(fmt::format("{} and {} are both standard input, which can be read once",
                                               at_standard_input, argument.option));
            if (*file == platform::standard_input) at_standard_input = argument.option;
            keep(argument, *file);
        }
    }
}

KeptStreams::Folder::~Folder() {
    std::error_code ignored;
    if (!path.empty()) fs::remove_all(path, ignored);
}

void KeptStreams::keep(const FileArgument& argument, fs::path& file) {
    const std::string bytes = read_whole_file(file);
    const std::string ending = ending_of(argument, file, bytes);
    if (folder_.path.empty()) folder_.path = new_folder();
    const char* const name = file == platform::standard_input ? "standard_input" : "pipe";
    file = folder_.path / (n_kept_ == 0 ? fmt::format("{}{}", name, ending)
                                        : fmt::format("{}_{}{}", name, n_kept_ + 1, ending));
    ++n_kept_;
    write_file(bytes, file);
}

}  // namespace counterpart::cli
