// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "io/obj_scanner.hpp"

#include "io/mesh_collector.hpp"

#include <charconv>
#include <limits>

#include <fmt/format.h>

namespace counterpart::io {
namespace {

constexpr std::int64_t no_row = std::numeric_limits<std::int64_t>::max();  // before the first

}  // namespace

bool ObjScanner::next() {
    if (!key_word_.empty()) text_.next_statement();
    if (!text_.next_content()) return false;
    key_word_ = text_.word();
    n_vertices_ += key_word_ == "v";
    n_textures_ += key_word_ == "vt";
    n_normals_ += key_word_ == "vn";
    return true;
}

Index ObjScanner::read_vertex() {
    const std::int64_t number = text_.integer("vertex of a face", '/');
    if (number > 0 && number <= max_count) {
        if (number > largest_vertex_) largest_vertex_ = number, line_of_largest_ = text_.line();
        return static_cast<Index>(number - 1);
    }
    if (number < 0 && number >= -n_vertices_) return static_cast<Index>(n_vertices_ + number);
    text_.fail(number == 0 ? "the face names vertex 0, but OBJ counts vertices from 1"
                           : fmt::format("the face names vertex {}, but only {} vertices precede it", number,
                                         n_vertices_));
}

const ObjFace& ObjScanner::face() {
    face_.vertices.clear();
    face_.rows.clear();
    while (!text_.at_line_end()) {
        face_.vertices.push_back(read_vertex());
        face_.rows.push_back(text_.peek() == '/' ? text_.word() : std::string_view());
    }
    if (face_.vertices.size() < 3)
        text_.fail(fmt::format("a face needs at least 3 corners, this one has {}", face_.vertices.size()));
    return face_;
}

ObjRows ObjScanner::rows(std::string_view text) const {
    const std::array counts = {n_textures_, n_normals_};
    ObjRows rows = {-1, -1};
    for (std::size_t k = 0; k < rows.size() && !text.empty(); ++k) {
        text.remove_prefix(1);  // the slash
        const std::string_view digits = text.substr(0, text.find('/'));
        text.remove_prefix(digits.size());
        if (digits.empty()) continue;
        std::int64_t number = 0;
        const bool has_plus = digits.size() > 1 && digits[0] == '+' && digits[1] != '-';  // not of from_chars
        const auto [end, error] =
            std::from_chars(digits.data() + (has_plus ? 1 : 0), digits.data() + digits.size(), number);
        if (error != std::errc() || end != digits.data() + digits.size() || number == 0)
            text_.fail(fmt::format("'{}' is no number of a texture coordinate or normal", shown(digits)));
        rows[k] = number > 0 ? number - 1 : number < -counts[k] ? no_row : counts[k] + number;
    }
    return rows;
}

void ObjScanner::require_vertices() const {
    if (largest_vertex_ > n_vertices_)
        text_.fail_at(line_of_largest_,
                      fmt::format("the face names vertex {}, but the file has only {} vertices",
                                  largest_vertex_, n_vertices_));
}

}  // namespace counterpart::io
