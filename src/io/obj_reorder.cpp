// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "io/formats.hpp"
#include "io/obj_scanner.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/io/obj_reorder.hpp>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace counterpart {
namespace {

struct ObjText {
    std::vector<std::string_view> positions, textures, normals;  // whole lines
    std::vector<io::ObjRows> corners;                            // of all faces, one after another
    Polygons polygons;                                           // empty: all faces are triangles

    Index n_triangles() const {
        return static_cast<Index>(polygons.empty() ? static_cast<Eigen::Index>(corners.size() / 3)
                                                   : polygons.corners.rows());
    }
    // Of a corner of a triangle, 3 * triangle + corner.
    const io::ObjRows& at(Index corner) const {
        const Index in_face = polygons.empty() ? corner : polygons.corners.data()[corner];
        return corners[static_cast<std::size_t>(in_face)];
    }
};

bool ends_line(char c) { return c == '\n' || c == '\r'; }

// Every statement as one line that ends in LF, with the lines that continue it after a backslash.
std::string with_whole_lines(std::string_view text) {
    std::string result;
    result.reserve(text.size());
    bool in_comment = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        in_comment = !ends_line(text[i]) && (in_comment || text[i] == '#');
        if (text[i] == '\\' && !in_comment && (i + 1 == text.size() || ends_line(text[i + 1]))) {
            i += text.substr(i + 1, 2) == "\r\n" ? 2 : 1;
            result += ' ';
        } else if (text[i] == '\r') {
            i += text.substr(i, 2) == "\r\n" ? 1 : 0;
            result += '\n';
        } else {
            result += text[i];
        }
    }
    return result;
}

std::string_view without_comment(std::string_view line) { return line.substr(0, line.find('#')); }

// Calls body(line, key_word, scanner) for each line of a text from `with_whole_lines`, with no key word where
// it holds nothing or a comment.
template <class Body>
void for_each_line(std::string_view text, const Body& body) {
    io::ObjScanner scanner(text, "reorder_obj");
    bool has_more = scanner.next();
    for (int number = 1; !text.empty(); ++number) {
        const std::string_view line = text.substr(0, text.find('\n'));
        text.remove_prefix(std::min(line.size() + 1, text.size()));
        if (has_more && scanner.text().line() == number) {
            body(line, scanner.key_word(), scanner);
            has_more = scanner.next();
        } else {
            body(line, std::string_view(), scanner);
        }
    }
}

// Rows that the file does not have, as read_attributed_obj leaves them out.
void leave_out_missing(ObjText& obj) {
    const std::array counts = {std::ssize(obj.textures), std::ssize(obj.normals)};
    for (io::ObjRows& corner : obj.corners)
        for (std::size_t k = 0; k < counts.size(); ++k)
            if (corner[k] >= counts[k]) corner[k] = -1;
}

ObjText parse(std::string_view text) {
    ObjText obj;
    obj.polygons = io::read_obj(text, "reorder_obj").content.mesh.polygons;
    for_each_line(text, [&](std::string_view line, std::string_view key_word, io::ObjScanner& scanner) {
        if (key_word == "v") obj.positions.push_back(without_comment(line));
        if (key_word == "vt") obj.textures.push_back(without_comment(line));
        if (key_word == "vn") obj.normals.push_back(without_comment(line));
        if (key_word != "f") return;
        for (const std::string_view rows : scanner.face().rows) obj.corners.push_back(scanner.rows(rows));
    });
    leave_out_missing(obj);
    return obj;
}

void append_corner(std::string& bytes, Index vertex, const io::ObjRows& corner) {
    bytes += fmt::format(" {}", vertex + 1);
    if (corner[0] >= 0 || corner[1] >= 0) bytes += '/';
    if (corner[0] >= 0) bytes += std::to_string(corner[0] + 1);
    if (corner[1] >= 0) bytes += fmt::format("/{}", corner[1] + 1);
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
        for_each_line(
            source_text, [&](std::string_view line, std::string_view key_word, io::ObjScanner& scanner) {
                if (key_word == "v") {
                    add_line(target_.positions[static_cast<std::size_t>(map_[n_positions_++])]);
                } else if (key_word == "f") {
                    add_attributes();
                    add_face(scanner.face().vertices.size());
                } else if (key_word != "vt" && key_word != "vn" && !is_line_with_texture(line, key_word)) {
                    add_line(line);
                }
            });
        return std::move(bytes_);
    }

  private:
    void add_line(std::string_view line) { (bytes_ += line) += '\n'; }
    bool keeps_textures() const { return target_.textures.empty(); }
    static bool is_line_with_texture(std::string_view line, std::string_view key_word) {
        return (key_word == "l" || key_word == "p") && without_comment(line).find('/') != line.npos;
    }

    void add_attributes() {
        if (std::exchange(has_attributes_, true)) return;
        for (const std::string_view line : keeps_textures() ? source_.textures : target_.textures)
            add_line(line);
        for (const std::string_view line : target_.normals) add_line(line);
    }

    void add_face(std::size_t n_corners) {
        bytes_ += 'f';
        for (std::size_t k = 0; k < n_corners; ++k) {
            // The triangle's corner that stands for this one.
            const Index at =
                stands_for_.empty() ? n_corners_ : stands_for_[static_cast<std::size_t>(n_corners_)];
            io::ObjRows corner = target_.at(corners_.data()[at]);
            if (keeps_textures()) corner[0] = source_.at(at)[0];
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
