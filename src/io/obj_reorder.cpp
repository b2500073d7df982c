// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include <counterpart/base/errors.hpp>
#include <counterpart/io/obj_reorder.hpp>

#include <charconv>
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
    std::vector<CornerAttributes> corners;                       // three for each triangle
};

std::string_view next_word(std::string_view& line) {
    const auto begin = line.find_first_not_of(" \t");
    if (begin == std::string_view::npos) return line = {};
    const auto end = std::min(line.find_first_of(" \t", begin), line.size());
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

ObjText parse(std::string_view text) {
    ObjText obj;
    std::vector<CornerAttributes> face;
    while (!text.empty()) {
        const auto end = std::min(text.find_first_of("\r\n"), text.size());
        const std::string_view line = text.substr(0, std::min(text.substr(0, end).find('#'), end));
        text.remove_prefix(std::min(end + 1, text.size()));
        std::string_view rest = line;
        const std::string_view word = next_word(rest);
        if (word == "v") obj.positions.push_back(line);
        if (word == "vt") obj.textures.push_back(line);
        if (word == "vn") obj.normals.push_back(line);
        if (word != "f") continue;
        face.clear();
        for (std::string_view corner = next_word(rest); !corner.empty(); corner = next_word(rest))
            face.push_back(parse_corner(corner, obj));
        for (std::size_t c = 2; c < face.size(); ++c)  // the fan that the reader makes of a polygon
            obj.corners.insert(obj.corners.end(), {face[0], face[c - 1], face[c]});
    }
    return obj;
}

void append_corner(std::string& bytes, Index vertex, const CornerAttributes& corner) {
    bytes += fmt::format(" {}", vertex + 1);
    if (corner.texture > 0 || corner.normal > 0) bytes += '/';
    if (corner.texture > 0) bytes += std::to_string(corner.texture);
    if (corner.normal > 0) bytes += fmt::format("/{}", corner.normal);
}

}  // namespace

std::string reorder_obj(std::string_view text, const VertexMap& target_from_source,
                        const Triangles& source_triangles, const Triangles& target_corner_from_source) {
    const ObjText obj = parse(text);
    require_valid(target_from_source, target_from_source.source_size(),
                  static_cast<Index>(obj.positions.size()));
    if (source_triangles.rows() != target_corner_from_source.rows())
        throw InvalidInput("reorder_obj: there must be one row of corners for each source triangle");
    std::string bytes;
    const auto add_line = [&](std::string_view line) { (bytes += line) += '\n'; };
    for (const Index image : target_from_source.image) {
        if (image < 0) throw InvalidInput("reorder_obj: the map leaves source vertices unmatched");
        add_line(obj.positions[static_cast<std::size_t>(image)]);
    }
    for (const std::string_view line : obj.textures) add_line(line);
    for (const std::string_view line : obj.normals) add_line(line);
    for (Eigen::Index t = 0; t < source_triangles.rows(); ++t) {
        bytes += 'f';
        for (int c = 0; c < 3; ++c) {
            const auto corner = static_cast<std::size_t>(target_corner_from_source(t, c));
            if (corner >= obj.corners.size())
                throw InvalidInput(fmt::format("reorder_obj: corner {} of triangle {} has no partner", c, t));
            append_corner(bytes, source_triangles(t, c), obj.corners[corner]);
        }
        bytes += '\n';
    }
    return bytes;
}

}  // namespace counterpart
