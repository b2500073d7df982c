// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// What a glTF file names beside itself. A file from a stranger could name any file of the machine, whose
// bytes would then be in what is written: so only those of its own folder are read, unless the caller allows
// others.
#include "base/base64.hpp"
#include "io/gltf_document.hpp"
#include "platform/files.hpp"

#include <counterpart/io/file.hpp>

#include <algorithm>

#include <fmt/format.h>

namespace counterpart::io {
namespace {

namespace fs = std::filesystem;

std::string percent_decoded(std::string_view text) {
    std::string result;
    const auto digit = [](char c) {
        const std::size_t value = std::string_view("0123456789abcdef").find(static_cast<char>(c | 0x20));
        return value == std::string_view::npos ? -1 : static_cast<int>(value);
    };
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '%' && i + 2 < text.size() && digit(text[i + 1]) >= 0 && digit(text[i + 2]) >= 0) {
            result += static_cast<char>(16 * digit(text[i + 1]) + digit(text[i + 2]));
            i += 2;
        } else {
            result += text[i];
        }
    }
    return result;
}

// "https:", "file:" and the like (RFC 3986, section 3.1).
bool has_scheme(std::string_view uri) {
    const auto is_letter = [](char c) { return (c | 0x20) >= 'a' && (c | 0x20) <= 'z'; };
    const auto is_in_scheme = [&](char c) {
        return is_letter(c) || (c >= '0' && c <= '9') || c == '+' || c == '-' || c == '.';
    };
    const std::string_view scheme = uri.substr(0, uri.find(':'));
    return scheme.size() < uri.size() && !scheme.empty() && is_letter(scheme[0]) &&
           std::all_of(scheme.begin(), scheme.end(), is_in_scheme);
}

// Whether the path is relative, does not climb, and stays below the folder when its links are followed.
bool lies_below(const fs::path& relative, const fs::path& folder) {
    if (relative.is_absolute() || std::find(relative.begin(), relative.end(), "..") != relative.end())
        return false;
    std::error_code error;
    const fs::path root = fs::canonical(folder.empty() ? fs::path(".") : folder, error);
    if (error) return false;
    const fs::path file = fs::weakly_canonical(root / relative, error);
    if (error) return false;
    return std::mismatch(root.begin(), root.end(), file.begin(), file.end()).first == root.end();
}

}  // namespace

GltfUri parse_uri(const GltfDocument& document, const std::string& uri, const std::string& what) {
    if (uri.starts_with("data:")) return {GltfUri::Kind::data, {}};
    // Long or unprintable ones are cut for the message.
    std::string shown;
    for (const char c : uri.substr(0, 100)) shown += c >= ' ' && c <= '~' ? c : '?';
    const auto refuse = [&](const char* reason) {
        document.fail(
            fmt::format("{} is '{}', {}: refused unless files outside the folder of this one are allowed",
                        what, shown, reason));
    };
    if (has_scheme(uri)) {
        if (!document.options.allow_external) refuse("which is no file beside this one");
        return {GltfUri::Kind::elsewhere, {}};
    }
    const std::string name = percent_decoded(uri);
    if (name.find('\0') != name.npos) document.fail(fmt::format("{} is '{}', which is no file", what, shown));
    const fs::path path = platform::path_of(name);
    if (!document.options.allow_external && !lies_below(path, document.folder))
        refuse("which leads out of the folder");
    return {GltfUri::Kind::file, document.folder / path};
}

std::string load_uri(const GltfDocument& document, const std::string& uri, const std::string& what) {
    const GltfUri parsed = parse_uri(document, uri, what);
    switch (parsed.kind) {
        case GltfUri::Kind::elsewhere:
            break;
        case GltfUri::Kind::file: {
            std::error_code ignored;
            if (!fs::is_regular_file(parsed.file, ignored))
                document.fail(fmt::format("{} is missing: there is no file {}", what,
                                          platform::utf8_name(parsed.file)));
            return read_whole_file(parsed.file);
        }
        case GltfUri::Kind::data: {
            const std::size_t data = uri.find(";base64,");
            if (data == uri.npos) document.fail(fmt::format("{}: the data URI is not base64", what));
            auto bytes = from_base64(std::string_view(uri).substr(data + 8));
            if (!bytes) document.fail("a data URI is not valid base64");
            return *std::move(bytes);
        }
    }
    document.fail(fmt::format("{} lies elsewhere; save it beside this file", what));
}

}  // namespace counterpart::io
