// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "io/byte_order.hpp"
#include "io/text_cursor.hpp"

#include <counterpart/io/mesh_file.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

namespace counterpart {
namespace {

using Beginning = std::pair<std::string_view, const char*>;

// Of formats that begin with words of their own.
constexpr std::array<Beginning, 8> beginnings = {{{"ply", ".ply"},
                                                  {"glTF", ".glb"},
                                                  {"{", ".gltf"},
                                                  {"# vtk DataFile", ".vtk"},
                                                  {"$", ".msh"},
                                                  {"MeshVersionFormatted", ".mesh"},
                                                  {"solid", ".stl"},
                                                  {"OFF", ".off"}}};

// What the lines of an OBJ begin with.
constexpr std::array<std::string_view, 11> obj_words = {"v", "vn", "vt", "vp",     "f",     "l",
                                                        "o", "g",  "s",  "mtllib", "usemtl"};

bool is_binary_stl(std::string_view bytes) {
    constexpr std::size_t prefix = 84, facet = 50;
    if (bytes.size() < prefix) return false;
    const auto n_facets = io::load_number<std::uint32_t>(bytes.data() + prefix - sizeof(std::uint32_t));
    return bytes.size() - prefix == facet * std::size_t{n_facets};
}

}  // namespace

std::string recognized_extension(std::string_view bytes) {
    if (is_binary_stl(bytes)) return ".stl";
    std::string_view text = io::without_mark(bytes);
    text.remove_prefix(std::min(text.size(), text.find_first_not_of(" \t\r\n")));
    for (const auto& [words, extension] : beginnings)
        if (text.starts_with(words)) return extension;
    constexpr std::size_t prolog = 4096;  // of an XML file: its declaration and comments
    const std::string_view head = text.substr(0, prolog);
    if (text.starts_with("<") && head.find("<VTKFile") != head.npos) return ".vtp";
    if (text.starts_with("<") && head.find("<GIFTI") != head.npos) return ".gii";
    io::TextCursor cursor(bytes, "");
    if (!cursor.next_content()) return "";
    const std::string_view word = cursor.word();
    if (std::find(obj_words.begin(), obj_words.end(), word) != obj_words.end()) return ".obj";
    return word.ends_with("OFF") ? ".off" : "";
}

}  // namespace counterpart
