// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "platform/files.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/io/file.hpp>

#include <cerrno>
#include <cstring>
#include <utility>

#include <fmt/format.h>

namespace counterpart {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& file, const char* what, int error) {
    throw WriteError(fmt::format("{}: {} ({})", platform::utf8_name(file), what, std::strerror(error)));
}

struct Destination {
    fs::path file;           // with links followed; the last may lead to a file that is not there yet
    bool is_stream = false;  // a device, a pipe, or what a process has open: written in place
};

Destination destination_of(const fs::path& file) {
    std::error_code ignored;
    const fs::file_status status = fs::status(file, ignored);
    Destination result{
        file, platform::is_nameless_output(file) || (fs::exists(status) && !fs::is_regular_file(status))};
    constexpr int most_links = 40;  // as the kernel follows
    for (int i = 0; i < most_links && fs::is_symlink(fs::symlink_status(result.file, ignored)); ++i) {
        // /dev/stdout leads here, also where the shell sent it to a regular file.
        result.is_stream |= platform::names_open_file(result.file);
        const fs::path target = fs::read_symlink(result.file, ignored);
        result.file = result.file.parent_path() / target;
    }
    return result;
}

void write_in_place(std::string_view bytes, const fs::path& file) {
    const platform::Opened stream = platform::open_stream(file);
    if (stream.error != 0) fail(file, "cannot be written", stream.error);
    const int error = stream.file.write(bytes);
    if (error == EPIPE)
        throw ClosedPipe(fmt::format("{}: nobody reads it any more", platform::utf8_name(file)));
    if (error != 0) fail(file, "could not be written", error);
}

// Files under construction are called NAME.0.part, NAME.1.part, ... Their writers have them alone, which
// ends with the process however it ends: what is nobody's is left over, and whoever writes next takes it.
// So no folder is ever listed, however many files are in it.
fs::path part_of(fs::path file, int number) { return file += fmt::format(".{}.part", number); }

// A new file beside the one to be written; removed with the object unless it takes that one's place.
class Part {
  public:
    explicit Part(const fs::path& file) : file_(file), opened_(open_free()) {
        opened_.take_permissions(file);
    }
    Part(const Part&) = delete;
    Part& operator=(const Part&) = delete;
    ~Part() {
        if (!name_.empty()) opened_.remove(name_);
    }

    void write(std::string_view bytes) {
        if (const int error = opened_.write(bytes); error != 0) fail(file_, "could not be written", error);
    }
    void take_place() {
        if (const int error = opened_.rename(name_, file_); error != 0)
            fail(file_, "could not be written", error);
        name_.clear();
        remove_left_over();
    }

  private:
    static constexpr int most_parts = 10'000;  // of writers at one time, and of what is in the way

    platform::OpenFile open_free() {
        for (number_ = 0; number_ < most_parts; ++number_) {
            name_ = part_of(file_, number_);
            platform::Opened part = platform::open_alone(name_, true);
            if (part.file.is_open()) part.error = part.file.make_empty();
            if (part.error != 0) fail(file_, "cannot be written here", part.error);
            if (part.file.is_open()) return std::move(part.file);
        }
        fail(file_, "cannot be written here", EBUSY);
    }

    // Of more writers at once, all killed: they have the next numbers.
    void remove_left_over() const {
        for (int number = number_ + 1; number < most_parts; ++number) {
            const fs::path name = part_of(file_, number);
            const platform::Opened part = platform::open_alone(name, false);
            if (part.error != 0) return;
            if (part.file.is_open()) part.file.remove(name);
        }
    }

    const fs::path& file_;
    fs::path name_;
    int number_ = 0;
    platform::OpenFile opened_;
};

}  // namespace

void write_file(std::string_view bytes, const fs::path& file) {
    const Destination destination = destination_of(file);
    if (destination.is_stream) return write_in_place(bytes, file);
    if (const int error = platform::error_of_writing(destination.file); error != 0)
        fail(file, "cannot be written here", error);
    Part part(destination.file);
    part.write(bytes);
    part.take_place();
}

}  // namespace counterpart
