// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "platform/files.hpp"

#include <cerrno>
#include <cstdlib>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace counterpart::platform {
namespace {

namespace fs = std::filesystem;

int descriptor(std::intptr_t handle) { return static_cast<int>(handle); }

bool is_named(int opened, const fs::path& name) {
    struct stat file = {}, named = {};
    return ::fstat(opened, &file) == 0 && ::lstat(name.c_str(), &named) == 0 && file.st_dev == named.st_dev &&
           file.st_ino == named.st_ino;
}

}  // namespace

OpenFile::~OpenFile() {
    if (is_open()) ::close(descriptor(handle_));
}

int OpenFile::write(std::string_view bytes) const {
    while (!bytes.empty()) {
        const ssize_t count = ::write(descriptor(handle_), bytes.data(), bytes.size());
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return errno;
        bytes.remove_prefix(static_cast<std::size_t>(count));
    }
    return 0;
}

int OpenFile::make_empty() const { return ::ftruncate(descriptor(handle_), 0) == 0 ? 0 : errno; }

void OpenFile::take_permissions(const fs::path& of) const {
    struct stat before = {};
    if (::stat(of.c_str(), &before) == 0) ::fchmod(descriptor(handle_), before.st_mode & 0777U);
}

int OpenFile::rename(const fs::path& from, const fs::path& to) const {
    return ::rename(from.c_str(), to.c_str()) == 0 ? 0 : errno;
}

void OpenFile::remove(const fs::path& name) const { ::unlink(name.c_str()); }

Opened open_stream(const fs::path& file) {
    // Standard output may be a socket, which cannot be opened by its name.
    const int opened = file == standard_output ? ::dup(STDOUT_FILENO)
                                               : ::open(file.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
    return {OpenFile(opened), opened < 0 ? errno : 0};
}

Opened open_alone(const fs::path& name, bool may_be_new) {
    constexpr int flags = O_WRONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC;
    const int opened = ::open(name.c_str(), may_be_new ? flags | O_CREAT : flags, 0666);
    OpenFile file(opened);
    if (opened < 0) {
        const int error = errno;
        const bool in_the_way = error == ELOOP || ::access(name.c_str(), F_OK) == 0;
        return {{}, in_the_way ? 0 : error};
    }
    // Its writer may have ended before it was locked here, and the name be gone or another file's by now.
    struct stat state = {};
    if (::flock(opened, LOCK_EX | LOCK_NB) != 0 || !is_named(opened, name) || ::fstat(opened, &state) != 0 ||
        !S_ISREG(state.st_mode) || state.st_nlink != 1)
        return {};
    return {std::move(file)};
}

std::FILE* open_to_read(const fs::path& file) {
    if (file != standard_input) return std::fopen(file.c_str(), "rb");
    const int opened = ::dup(STDIN_FILENO);  // a socket cannot be opened by its name
    return opened < 0 ? nullptr : ::fdopen(opened, "rb");
}

bool is_nameless_output(const fs::path& /*file*/) { return false; }

bool names_open_file(const fs::path& link) { return link.native().starts_with("/proc/"); }

int error_of_writing(const fs::path& file) {
    return ::access(file.c_str(), W_OK) == 0 || errno == ENOENT ? 0 : errno;
}

int error_of_making_files(const fs::path& folder) {
#ifdef O_TMPFILE  // without a name, which would be left behind if the program is killed here
    const int unnamed = ::open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, S_IRUSR | S_IWUSR);
    if (unnamed >= 0) {
        ::close(unnamed);
        return 0;
    }
    const bool is_supported = errno != EOPNOTSUPP && errno != EISDIR;
    if (is_supported) return errno;
#endif
    std::string name = (folder / ".counterpart-XXXXXX").string();
    const int file = ::mkstemp(name.data());
    if (file < 0) return errno;
    ::close(file);
    ::unlink(name.c_str());
    return 0;
}

}  // namespace counterpart::platform
