// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "io/formats.hpp"
#include "io/text_cursor.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/io/obj_reorder.hpp>

#include <algorithm>
#include <charconv>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace counterpart {
namespace {

// Texture coordinate and normal of one corner, counted from 1; 0 = none.
struct CornerAttributes {
    long texture = 0, normal = 0;
};

struct ObjText {
    std::vector<std::string_view> positions, textures, normals;  // whole lines
    std::vector<CornerAttributes> corners;                       // of all faces, one after another
    Polygons polygons;                                           // empty: all faces are triangles

    Index n_triangles() const {
        return static_cast<Index>(polygons.empty() ? static_cast<Eigen::Index>(corners.size() / 3)
                                                   : polygons.corners.rows());
    }
    // Of a corner of a triangle, 3 * triangle + corner.
    const CornerAttributes& at(Index corner) const {
        const Index in_face = polygons.empty() ? corner : polygons.corners.data()[corner];
        return corners[static_cast<std::size_t>(in_face)];
    }
};

bool ends_line(char c) { return c == '\n' || c == '\r'; }

// A line and those that continue it after a backslash as one line, as read_obj takes them.
std::string with_whole_lines(std::string_view text) {
    std::string result;
    result.reserve(text.size());
    bool in_comment = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        in_comment = !ends_line(text[i]) && (in_comment || text[i] == '#');
        if (text[i] == '\\' && !in_comment && (i + 1 == text.size() || ends_line(text[i + 1]))) {
            i += text.substr(i + 1, 2) == "\r\n" ? 2 : 1;
            result += ' ';
        } else {
            result += text[i];
        }
    }
    return result;
}

struct Line {
    std::string_view whole, content;  // with the comment and without
};
Line take_line(std::string_view& text) {
    const auto end = std::min(text.find_first_of("\r\n"), text.size());
    const std::string_view whole = text.substr(0, end);
    const bool two = text.substr(end, 2) == "\r\n";
    text.remove_prefix(std::min(end + (two ? 2 : 1), text.size()));
    return {whole, whole.substr(0, std::min(whole.find('#'), whole.size()))};
}

std::string_view next_word(std::string_view& line) {
    constexpr const char* blanks = " \t\v\f";
    const auto begin = line.find_first_not_of(blanks);
    if (begin == std::string_view::npos) return line = {};
    const auto end = std::min(line.find_first_of(blanks, begin), line.size());
    const std::string_view word = line.substr(begin, end - begin);
    line.remove_prefix(end);
    return word;
}

// Negative numbers count back from the last of `count`.
long resolve(std::string_view digits, std::size_t count) {
    long number = 0;
    std::from_chars(digits.data(), digits.data() + digits.size(), number);
    return number < 0 ? static_cast<long>(count) + 1 + number : number;
}

CornerAttributes parse_corner(std::string_view word, const ObjText& obj) {
    CornerAttributes corner;
    const auto first = word.find('/');
    if (first == std::string_view::npos) return corner;
    const auto second = word.find('/', first + 1);
    corner.texture = resolve(word.substr(first + 1, second - first - 1), obj.textures.size());
    if (second != std::string_view::npos)
        corner.normal = resolve(word.substr(second + 1), obj.normals.size());
    return corner;
}

// Rows that the file does not have, as read_obj leaves them out.
void leave_out_missing(ObjText& obj) {
    const auto n_textures = static_cast<long>(obj.textures.size()),
               n_normals = static_cast<long>(obj.normals.size());
    for (CornerAttributes& corner : obj.corners) {
        if (corner.texture > n_textures) corner.texture = 0;
        if (corner.normal > n_normals) corner.normal = 0;
    }
}

ObjText parse(std::string_view text) {
    ObjText obj;
    obj.polygons = io::read_obj(text, "reorder_obj").content.mesh.polygons;
    while (!text.empty()) {
        const std::string_view line = take_line(text).content;
        std::string_view rest = line;
        const std::string_view word = next_word(rest);
        if (word == "v") obj.positions.push_back(line);
        if (word == "vt") obj.textures.push_back(line);
        if (word == "vn") obj.normals.push_back(line);
        if (word != "f") continue;
        for (std::string_view corner = next_word(rest); !corner.empty(); corner = next_word(rest))
            obj.corners.push_back(parse_corner(corner, obj));
    }
    leave_out_missing(obj);
    return obj;
}

void append_corner(std::string& bytes, Index vertex, const CornerAttributes& corner) {
    bytes += fmt::format(" {}", vertex + 1);
    if (corner.texture > 0 || corner.normal > 0) bytes += '/';
    if (corner.texture > 0) bytes += std::to_string(corner.texture);
    if (corner.normal > 0) bytes += fmt::format("/{}", corner.normal);
}

class Writer {
  public:
    Writer(const ObjText& source, const ObjText& target, const VertexMap& map, TrianglesView triangles,
           TrianglesView corners)
        : source_(source),
          target_(target),
          map_(map),
          triangles_(triangles),
          corners_(corners),
          stands_for_(source.polygons.triangle_corners()) {}

    // The source's lines in their order, with what is the target's in the place of what was the source's.
    std::string run(std::string_view source_text) {
        while (!source_text.empty()) {
            const Line line = take_line(source_text);
            std::string_view rest = line.content;
            const std::string_view word = next_word(rest);
            if (word == "v") {
                add_line(target_.positions[static_cast<std::size_t>(map_[n_positions_++])]);
            } else if (word == "f") {
                add_attributes();
                add_face(rest);
            } else if (word != "vt" && word != "vn" && !is_line_with_texture(word, rest)) {
                add_line(line.whole);
            }
        }
        return std::move(bytes_);
    }

  private:
    void add_line(std::string_view line) { (bytes_ += line) += '\n'; }
    bool keeps_textures() const { return target_.textures.empty(); }
    static bool is_line_with_texture(std::string_view word, std::string_view rest) {
        return (word == "l" || word == "p") && rest.find('/') != std::string_view::npos;
    }

    void add_attributes() {
        if (std::exchange(has_attributes_, true)) return;
        for (const std::string_view line : keeps_textures() ? source_.textures : target_.textures)
            add_line(line);
        for (const std::string_view line : target_.normals) add_line(line);
    }

    void add_face(std::string_view words) {
        Index n = 0;
        while (!next_word(words).empty()) ++n;
        bytes_ += 'f';
        for (Index k = 0; k < n; ++k) {
            // The triangle's corner that stands for this one.
            const Index at =
                stands_for_.empty() ? n_corners_ : stands_for_[static_cast<std::size_t>(n_corners_)];
            CornerAttributes corner = target_.at(corners_.data()[at]);
            if (keeps_textures()) corner.texture = source_.at(at).texture;
            append_corner(bytes_, triangles_.data()[at], corner);
            ++n_corners_;
        }
        bytes_ += '\n';
    }

    const ObjText& source_;
    const ObjText& target_;
    const VertexMap& map_;
    TrianglesView triangles_;
    TrianglesView corners_;
    std::string bytes_;
    std::vector<Index> stands_for_;  // for each corner of a polygon that of a triangle
    Index n_positions_ = 0, n_corners_ = 0;
    bool has_attributes_ = false;
};

}  // namespace

std::string reorder_obj(std::string_view source_text, std::string_view target_text,
                        const VertexMap& target_from_source, TrianglesView source_triangles,
                        TrianglesView target_corner_from_source) {
    const std::string source_lines = with_whole_lines(io::without_mark(source_text)),
                      target_lines = with_whole_lines(io::without_mark(target_text));
    const ObjText source = parse(source_lines), target = parse(target_lines);
    require_valid(target_from_source, static_cast<Index>(source.positions.size()),
                  static_cast<Index>(target.positions.size()));
    for (const Index image : target_from_source.image())
        if (image < 0) throw InvalidInput("reorder_obj: the map leaves source vertices unmatched");
    if (source_triangles.rows() != target_corner_from_source.rows() ||
        source.n_triangles() != source_triangles.rows())
        throw InvalidInput("reorder_obj: there must be one row of corners for each source triangle");
    for (Eigen::Index t = 0; t < source_triangles.rows(); ++t) {
        for (int c = 0; c < 3; ++c)
            if (target_corner_from_source(t, c) < 0 ||
                target_corner_from_source(t, c) >= 3 * target.n_triangles())
                throw InvalidInput(fmt::format("reorder_obj: corner {} of triangle {} has no partner", c, t));
    }
    return Writer(source, target, target_from_source, source_triangles, target_corner_from_source)
        .run(source_lines);
}

std::string reorder_obj(MeshView source, std::string_view target_text, const VertexMap& target_from_source,
                        TrianglesView target_corner_from_source) {
    return reorder_obj(io::obj_bytes(source), target_text, target_from_source, source.triangles,
                       target_corner_from_source);
}

}  // namespace counterpart
