// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "io/ply_header.hpp"

#include "io/mesh_collector.hpp"

#include <array>
#include <utility>

#include <fmt/format.h>

namespace counterpart::io {
namespace {

constexpr std::array<std::pair<std::string_view, PlyType>, 16> type_names = {{{"char", PlyType::int8},
                                                                              {"int8", PlyType::int8},
                                                                              {"uchar", PlyType::uint8},
                                                                              {"uint8", PlyType::uint8},
                                                                              {"short", PlyType::int16},
                                                                              {"int16", PlyType::int16},
                                                                              {"ushort", PlyType::uint16},
                                                                              {"uint16", PlyType::uint16},
                                                                              {"int", PlyType::int32},
                                                                              {"int32", PlyType::int32},
                                                                              {"uint", PlyType::uint32},
                                                                              {"uint32", PlyType::uint32},
                                                                              {"float", PlyType::float32},
                                                                              {"float32", PlyType::float32},
                                                                              {"double", PlyType::float64},
                                                                              {"float64", PlyType::float64}}};

PlyType parse_type(TextCursor& text, std::string_view name) {
    for (const auto& [known, type] : type_names)
        if (known == name) return type;
    text.fail(fmt::format("unknown property type '{}'", name));
}

PlyHeader::Format read_format(TextCursor& text) {
    const std::string_view format = text.word();
    if (format == "ascii") return PlyHeader::Format::ascii;
    if (format == "binary_little_endian") return PlyHeader::Format::little_endian;
    if (format == "binary_big_endian") return PlyHeader::Format::big_endian;
    text.fail(fmt::format("unknown format '{}': expected ascii, binary_little_endian or binary_big_endian",
                          format));
}

PlyElement read_element(TextCursor& text) {
    PlyElement element;
    element.name = text.word();
    element.count = text.integer("number of elements");
    if (element.count < 0 || element.count > max_count)
        text.fail(fmt::format("the number of '{}' is out of range: {}", element.name, element.count));
    return element;
}

PlyProperty read_property(TextCursor& text) {
    PlyProperty property;
    std::string_view word = text.word();
    if (word == "list") {
        property.is_list = true;
        property.count_type = parse_type(text, text.word());
        if (property.count_type == PlyType::float32 || property.count_type == PlyType::float64)
            text.fail("the length of a list must be a whole number");
        word = text.word();
    }
    property.type = parse_type(text, word);
    property.name = text.word();
    if (property.name.empty()) text.fail("the property has no name");
    return property;
}

}  // namespace

std::size_t size_of(PlyType type) {
    switch (type) {
        case PlyType::int8:
        case PlyType::uint8:
            return 1;
        case PlyType::int16:
        case PlyType::uint16:
            return 2;
        case PlyType::int32:
        case PlyType::uint32:
        case PlyType::float32:
            return 4;
        case PlyType::float64:
            return 8;
    }
    return 8;
}

PlyHeader read_ply_header(TextCursor& text) {
    if (text.word() != "ply") text.fail("not a PLY file: it does not begin with 'ply'");
    PlyHeader header;
    bool has_format = false;
    for (text.next_line(); text.next_content(); text.next_line()) {
        const std::string_view word = text.word();
        if (word == "end_header") {
            if (!has_format) text.fail("the header has no 'format' line");
            text.next_line();
            return header;
        }
        if (word == "format") {
            header.format = read_format(text);
            has_format = true;
        } else if (word == "element") {
            header.elements.push_back(read_element(text));
        } else if (word == "property") {
            if (header.elements.empty()) text.fail("a property stands before the first element");
            header.elements.back().properties.push_back(read_property(text));
        } else if (word != "comment" && word != "obj_info") {
            text.fail(
                "a PLY header has lines 'format', 'element', 'property', 'comment' and 'end_header', "
                "not this one");
        }
    }
    text.fail("the file ends within its header");
}

}  // namespace counterpart::io
