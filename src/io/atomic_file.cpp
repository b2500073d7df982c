// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include <counterpart/base/errors.hpp>
#include <counterpart/io/atomic_file.hpp>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include <fmt/format.h>
#include <unistd.h>

namespace counterpart {

void write_file(std::string_view bytes, const std::filesystem::path& file) {
    const std::string beside = fmt::format("{}.{}.part", file.string(), getpid());
    std::FILE* stream = std::fopen(beside.c_str(), "wb");
    if (stream == nullptr) {
        throw IoError(fmt::format("{}: cannot be written here ({})", file.string(), std::strerror(errno)));
    }
    const bool written = std::fwrite(bytes.data(), 1, bytes.size(), stream) == bytes.size();
    const bool closed = std::fclose(stream) == 0;
    std::error_code renamed;
    if (written && closed) std::filesystem::rename(beside, file, renamed);
    if (!written || !closed || renamed) {
        const std::string reason = renamed ? renamed.message() : "the disk may be full";
        std::remove(beside.c_str());
        throw IoError(fmt::format("{}: could not be written ({})", file.string(), reason));
    }
}

}  // namespace counterpart
