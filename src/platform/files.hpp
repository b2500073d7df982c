// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// What the standard library cannot do with files. This folder is the only place that knows the operating
// system: posix/ and windows/ hold the same functions, of which the build takes one set. Errors are numbers
// of <cerrno>, 0 for none.
#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>

namespace counterpart::platform {

/// The names of standard input and output among files, on every system.
inline constexpr const char* standard_input = "/dev/stdin";
inline constexpr const char* standard_output = "/dev/stdout";

/// A name in UTF-8 (where file names are bytes, as they are), for messages and for what is stored in files.
inline std::string utf8_name(const std::filesystem::path& file) {
    const std::u8string name = file.u8string();
    return {name.begin(), name.end()};
}

/// The file of a name in UTF-8.
inline std::filesystem::path path_of(std::string_view utf8_name) {
    return std::filesystem::path(std::u8string(utf8_name.begin(), utf8_name.end()));
}

/// A file opened for writing, closed with the object.
class OpenFile {
  public:
    OpenFile() = default;  ///< none
    explicit OpenFile(std::intptr_t handle) : handle_(handle) {}
    OpenFile(OpenFile&& other) noexcept : handle_(other.handle_) { other.handle_ = none; }
    OpenFile& operator=(OpenFile&&) = delete;
    ~OpenFile();
    bool is_open() const { return handle_ != none; }

    /// All the bytes; EPIPE where nobody reads any more.
    [[nodiscard]] int write(std::string_view bytes) const;
    [[nodiscard]] int make_empty() const;
    /// Those of another file, where it is there.
    void take_permissions(const std::filesystem::path& of) const;
    /// From its present name to that of another file, which is replaced.
    [[nodiscard]] int rename(const std::filesystem::path& from, const std::filesystem::path& to) const;
    void remove(const std::filesystem::path& name) const;

  private:
    static constexpr std::intptr_t none = -1;
    std::intptr_t handle_ = none;
};

/// A file, or why there is none.
struct Opened {
    OpenFile file{};
    int error = 0;
};

/// A device or a pipe, to write at its end; standard output also where that has no name.
Opened open_stream(const std::filesystem::path& file);

/// A plain file of this name alone, which no other process has so opened, however the one that made it ended;
/// made if `may_be_new`. No file and no error: one is in the way, another writer's, a link, a folder.
Opened open_alone(const std::filesystem::path& name, bool may_be_new);

/// For reading, in binary; null with errno set if it cannot be opened. Standard input also where that has no
/// name.
std::FILE* open_to_read(const std::filesystem::path& file);

/// Whether the name stands for standard output though no file has it.
bool is_nameless_output(const std::filesystem::path& file);

/// Whether what a link holds is not a name but what a process has open.
bool names_open_file(const std::filesystem::path& link);

/// Why the file, if it is there, may not be written.
int error_of_writing(const std::filesystem::path& file);

/// Why no file can be made in this folder. Tried, not asked: permissions say nothing of file systems that are
/// read-only or none to write on.
int error_of_making_files(const std::filesystem::path& folder);

}  // namespace counterpart::platform
