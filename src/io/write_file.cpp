// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include <counterpart/base/errors.hpp>
#include <counterpart/io/file.hpp>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace counterpart {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& file, const char* what, int error) {
    throw WriteError(fmt::format("{}: {} ({})", file.string(), what, std::strerror(error)));
}

class Descriptor {
  public:
    explicit Descriptor(int number) : number_(number) {}
    Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
    Descriptor& operator=(Descriptor&&) = delete;
    ~Descriptor() {
        if (number_ >= 0) ::close(number_);
    }
    int number() const { return number_; }
    bool is_open() const { return number_ >= 0; }

  private:
    int number_;
};

// The error number; 0 if all was written.
int write_all(const Descriptor& to, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t count = ::write(to.number(), bytes.data(), bytes.size());
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return errno;
        bytes.remove_prefix(static_cast<std::size_t>(count));
    }
    return 0;
}

struct Destination {
    fs::path file;           // with links followed; the last may lead to a file that is not there yet
    bool is_stream = false;  // a device, a pipe, or what a process has open: written in place
};

Destination destination_of(const fs::path& file) {
    std::error_code ignored;
    const fs::file_status status = fs::status(file, ignored);
    Destination result{file, fs::exists(status) && !fs::is_regular_file(status)};
    constexpr int most_links = 40;  // as the kernel follows
    for (int i = 0; i < most_links && fs::is_symlink(fs::symlink_status(result.file, ignored)); ++i) {
        // /dev/stdout leads here, also where the shell sent it to a regular file.
        result.is_stream |= result.file.native().starts_with("/proc/");
        const fs::path target = fs::read_symlink(result.file, ignored);
        result.file = result.file.parent_path() / target;
    }
    return result;
}

void write_in_place(std::string_view bytes, const fs::path& file) {
    // Standard output may be a socket, which cannot be opened by its name.
    const Descriptor stream(file == "/dev/stdout" ? ::dup(STDOUT_FILENO)
                                                  : ::open(file.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC));
    if (!stream.is_open()) fail(file, "cannot be written", errno);
    if (const int error = write_all(stream, bytes); error != 0) fail(file, "could not be written", error);
}

// Files under construction are called NAME.PROCESS.NUMBER.part. Their writers hold a lock on them, which ends
// with the process however it ends: what is not locked is left over.
bool is_part_of(const std::string& name, const std::string& file_name) {
    if (!name.starts_with(file_name + '.') || !name.ends_with(".part")) return false;
    const std::string_view middle = std::string_view(name).substr(file_name.size());
    return middle.size() > 6 &&
           middle.substr(0, middle.size() - 5).find_first_not_of("0123456789.") == std::string_view::npos;
}

bool is_named(const Descriptor& opened, const fs::path& name) {
    struct stat file = {}, named = {};
    return ::fstat(opened.number(), &file) == 0 && ::lstat(name.c_str(), &named) == 0 &&
           file.st_dev == named.st_dev && file.st_ino == named.st_ino;
}

void remove_left_over_parts(const fs::path& file) {
    const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
        if (!is_part_of(entry->path().filename().string(), file.filename().string())) continue;
        const Descriptor part(::open(entry->path().c_str(), O_WRONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
        if (!part.is_open() || ::flock(part.number(), LOCK_EX | LOCK_NB) != 0) continue;
        // Its writer may have ended well before it was locked here, and the name be another writer's by now.
        if (is_named(part, entry->path())) ::unlink(entry->path().c_str());
    }
}

// A new file beside the one to be written, locked; removed with the object unless it takes that one's place.
class Part {
  public:
    explicit Part(const fs::path& file) : file_(file), descriptor_(open_new()) {
        struct stat before = {};
        if (::stat(file.c_str(), &before) == 0) ::fchmod(descriptor_.number(), before.st_mode & 0777U);
    }
    Part(const Part&) = delete;
    Part& operator=(const Part&) = delete;
    ~Part() {
        if (!name_.empty()) ::unlink(name_.c_str());
    }

    void write(std::string_view bytes) {
        if (const int error = write_all(descriptor_, bytes); error != 0)
            fail(file_, "could not be written", error);
    }
    void take_place() {
        if (::rename(name_.c_str(), file_.c_str()) != 0) fail(file_, "could not be written", errno);
        name_.clear();
    }

  private:
    Descriptor open_new() {
        for (int number = 0;; ++number) {
            name_ = fmt::format("{}.{}.{}.part", file_.string(), ::getpid(), number);
            Descriptor part(::open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
            if (!part.is_open() && errno == EEXIST) continue;
            if (!part.is_open()) fail(file_, "cannot be written here", errno);
            // Between opening and locking it looks left over, and another writer may have removed it.
            const bool taken = ::flock(part.number(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
            struct stat state = {};
            if (!taken && ::fstat(part.number(), &state) == 0 && state.st_nlink == 1) return part;
        }
    }

    const fs::path& file_;
    std::string name_;
    Descriptor descriptor_;
};

}  // namespace

void write_file(std::string_view bytes, const fs::path& file) {
    const Destination destination = destination_of(file);
    if (destination.is_stream) return write_in_place(bytes, file);
    if (::access(destination.file.c_str(), W_OK) != 0 && errno != ENOENT)
        fail(file, "cannot be written here", errno);
    remove_left_over_parts(destination.file);
    Part part(destination.file);
    part.write(bytes);
    part.take_place();
}

}  // namespace counterpart
