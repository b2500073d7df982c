// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include <counterpart/base/errors.hpp>
#include <counterpart/io/file.hpp>

#include <cerrno>
#include <cstring>
#include <optional>
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
    const int error = write_all(stream, bytes);
    if (error == EPIPE) throw ClosedPipe(fmt::format("{}: nobody reads it any more", file.string()));
    if (error != 0) fail(file, "could not be written", error);
}

bool is_named(const Descriptor& opened, const fs::path& name) {
    struct stat file = {}, named = {};
    return ::fstat(opened.number(), &file) == 0 && ::lstat(name.c_str(), &named) == 0 &&
           file.st_dev == named.st_dev && file.st_ino == named.st_ino;
}

// Files under construction are called NAME.0.part, NAME.1.part, ... Their writers hold a lock on them, which
// ends with the process however it ends: what is not locked is left over, and whoever writes next takes it.
// So no folder is ever listed, however many files are in it.
fs::path part_of(const fs::path& file, int number) {
    return fmt::format("{}.{}.part", file.string(), number);
}

// Locked, and so ours: nothing if a writer holds it, or if it is no plain file of this name alone.
std::optional<Descriptor> locked(Descriptor part, const fs::path& name) {
    struct stat state = {};
    // Its writer may have ended before it was locked here, and the name be gone or another file's by now.
    if (!part.is_open() || ::flock(part.number(), LOCK_EX | LOCK_NB) != 0 || !is_named(part, name) ||
        ::fstat(part.number(), &state) != 0 || !S_ISREG(state.st_mode) || state.st_nlink != 1)
        return std::nullopt;
    return part;
}

// A new file beside the one to be written, locked; removed with the object unless it takes that one's place.
class Part {
  public:
    explicit Part(const fs::path& file) : file_(file), descriptor_(open_free()) {
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
        remove_left_over();
    }

  private:
    static constexpr int flags = O_WRONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC;
    static constexpr int most_parts = 10'000;  // of writers at one time, and of what is in the way

    Descriptor open_free() {
        for (number_ = 0; number_ < most_parts; ++number_) {
            name_ = part_of(file_, number_);
            Descriptor opened(::open(name_.c_str(), flags | O_CREAT, 0666));
            const int error = errno;
            const bool in_the_way = !opened.is_open() && ::access(name_.c_str(), F_OK) == 0;
            if (!opened.is_open() && !in_the_way && error != ELOOP) {
                name_.clear();
                fail(file_, "cannot be written here", error);
            }
            if (auto part = locked(std::move(opened), name_)) {
                if (::ftruncate(part->number(), 0) != 0) fail(file_, "cannot be written here", errno);
                return *std::move(part);
            }
        }
        name_.clear();
        fail(file_, "cannot be written here", EBUSY);
    }

    // Of more writers at once, all killed: they have the next numbers.
    void remove_left_over() const {
        for (int number = number_ + 1; number < most_parts; ++number) {
            const fs::path name = part_of(file_, number);
            Descriptor opened(::open(name.c_str(), flags));
            if (!opened.is_open() && errno == ENOENT) return;
            if (const auto part = locked(std::move(opened), name))
                ::unlink(name.c_str());  // while it is locked
        }
    }

    const fs::path& file_;
    fs::path name_;
    int number_ = 0;
    Descriptor descriptor_;
};

}  // namespace

void write_file(std::string_view bytes, const fs::path& file) {
    const Destination destination = destination_of(file);
    if (destination.is_stream) return write_in_place(bytes, file);
    if (::access(destination.file.c_str(), W_OK) != 0 && errno != ENOENT)
        fail(file, "cannot be written here", errno);
    Part part(destination.file);
    part.write(bytes);
    part.take_place();
}

}  // namespace counterpart
