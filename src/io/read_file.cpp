// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "platform/files.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/io/file.hpp>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include <fmt/format.h>

namespace counterpart {

std::string read_whole_file(const std::filesystem::path& file) {
    std::error_code ignored;
    if (std::filesystem::is_directory(file, ignored))
        throw IoError(fmt::format("{}: is a folder, not a file", platform::utf8_name(file)));
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream(platform::open_to_read(file), &std::fclose);
    if (!stream)
        throw IoError(
            fmt::format("{}: cannot be opened ({})", platform::utf8_name(file), std::strerror(errno)));
    // The size is only a hint: pipes have none.
    const std::uintmax_t size = std::filesystem::file_size(file, ignored);
    std::string bytes;
    if (!ignored) bytes.reserve(static_cast<std::size_t>(size));
    std::array<char, 1 << 16> block;
    while (const std::size_t count = std::fread(block.data(), 1, block.size(), stream.get()))
        bytes.append(block.data(), count);
    if (std::ferror(stream.get()) != 0)
        throw IoError(
            fmt::format("{}: could not be read ({})", platform::utf8_name(file), std::strerror(errno)));
    return bytes;
}

}  // namespace counterpart
