// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// VTK's legacy format, text and binary (VTK file formats, "Simple legacy formats"): POLYDATA and
// UNSTRUCTURED_GRID, with arrays of points, of versions 1 to 4 (each cell led by its size) and 5 (OFFSETS and
// CONNECTIVITY). What is binary is big endian.
#include "io/vtk_data.hpp"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>

namespace counterpart::io {
namespace {

std::string in_lower_case(std::string_view word) {
    std::string text(word);
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

// Blanks and percent signs of names are written as %20 and %25.
std::string decoded(std::string_view word) {
    std::string name;
    for (std::size_t i = 0; i < word.size(); ++i) {
        const auto is_digit = [&](std::size_t k) {
            return k < word.size() && std::isxdigit(static_cast<unsigned char>(word[k])) != 0;
        };
        if (word[i] == '%' && is_digit(i + 1) && is_digit(i + 2)) {
            name += static_cast<char>(std::stoi(std::string(word.substr(i + 1, 2)), nullptr, 16));
            i += 2;
        } else {
            name += word[i];
        }
    }
    return name;
}

class LegacyReader {
  public:
    LegacyReader(TextCursor text, bool is_binary) : text_(std::move(text)), is_binary_(is_binary) {}

    Cells read() {
        for (; text_.next_content(); next_line()) {
            const std::string key_word = in_lower_case(text_.word());
            if (key_word == "dataset") require_dataset(in_lower_case(text_.word()));
            if (key_word == "points") read_points();
            if (key_word == "polygons") add_all(read_cells(), static_cast<int>(VtkCell::polygon));
            if (key_word == "triangle_strips")
                add_all(read_cells(), static_cast<int>(VtkCell::triangle_strip));
            if (key_word == "vertices" || key_word == "lines") read_cells();
            if (key_word == "cells") rows_ = read_cells();
            if (key_word == "cell_types") read_types();
            if (key_word == "metadata") skip_metadata();
            if (key_word == "field") read_fields(0, false);
            if (key_word == "point_data" || key_word == "cell_data") {
                try_attributes(key_word == "point_data");
                break;
            }
        }
        return std::move(cells_);
    }

  private:
    void require_dataset(const std::string& kind) {
        if (kind != "polydata" && kind != "unstructured_grid")
            text_.fail("only DATASET POLYDATA and UNSTRUCTURED_GRID are supported");
    }

    // Behind numbers in binary, or none, the cursor stands where the next line begins, or before its break.
    void next_line() {
        if (!at_line_begin_) text_.next_line();
        at_line_begin_ = false;
    }

    // Of `count` numbers, or a refusal where the file has no room for them.
    std::vector<double> read_numbers(std::int64_t count, const std::string& type_name,
                                     std::string_view what) {
        const auto type = legacy_vtk_type(type_name);
        if (!type) text_.fail(fmt::format("the {} are of type {}, which is not supported", what, type_name));
        const std::size_t size = is_binary_ ? size_of(*type) : 2;
        if (static_cast<std::uint64_t>(count) > (text_.remaining() + 1) / size)
            text_.fail(fmt::format("{} {} are announced, more than the file has room for", count, what));
        const auto n = static_cast<std::size_t>(count);
        text_.next_line();
        at_line_begin_ = is_binary_ || n == 0;
        if (is_binary_) return numbers_of(text_.take(n * size, what), *type, std::endian::big);
        std::vector<double> numbers(n);
        for (double& number : numbers) {
            text_.next_content();
            number = text_.number(what);
        }
        return numbers;
    }
    std::int64_t count(std::string_view what) { return read_count(text_, what, 1); }
    std::string type_word() { return in_lower_case(text_.word()); }
    Refuse refuse() {
        return [this](const std::string& reason) { text_.fail(reason); };
    }

    void read_points() {
        // Cells were checked against the first.
        if (cells_.n_vertices() > 0) text_.fail("the points are given a second time");
        const std::int64_t n = count("number of points");
        cells_.coordinates = read_numbers(3 * n, type_word(), "coordinates");
    }

    CellRows read_cells() {
        const std::int64_t n = count("number of cells"), size = count("size of the cells");
        const int line = text_.line();
        text_.next_line();
        if (!is_binary_) text_.next_content();
        if (text_.peek() == 'O' || text_.peek() == 'o') return read_offsets(n, size);
        at_line_begin_ = is_binary_ || n == 0;
        return is_binary_ ? read_sized(n, size, line) : read_sized_text(n);
    }

    // Version 5: n is one more than the number of cells.
    CellRows read_offsets(std::int64_t n, std::int64_t size) {
        if (type_word() != "offsets") text_.fail("OFFSETS are expected here");
        const std::vector<double> offsets = read_numbers(n, type_word(), "offsets");
        next_line();
        text_.next_content();
        if (type_word() != "connectivity") text_.fail("CONNECTIVITY is expected here");
        const std::vector<double> vertices = read_numbers(size, type_word(), "corners");
        return cell_rows(offsets, vertices, cells_.n_vertices(), refuse());
    }

    CellRows read_sized(std::int64_t n, std::int64_t size, int line) {
        const std::size_t each = size_of(NumberType::int32);
        if (static_cast<std::uint64_t>(size) > text_.remaining() / each)
            text_.fail("the cells are announced larger than the rest of the file");
        const std::size_t bytes = static_cast<std::size_t>(size) * each;
        const std::vector<double> numbers =
            numbers_of(text_.take(bytes, "the cells"), NumberType::int32, std::endian::big);
        std::vector<double> offsets{0}, vertices;
        std::size_t at = 0;
        for (std::int64_t i = 0; i < n; ++i) {
            if (at >= numbers.size() || !(numbers[at] >= 0) ||
                numbers[at] > static_cast<double>(numbers.size() - at - 1))
                text_.fail_at(line, fmt::format("cell {} reaches beyond the size of the cells", i));
            const auto begin = numbers.begin() + static_cast<std::ptrdiff_t>(at) + 1;
            const auto length = static_cast<std::ptrdiff_t>(numbers[at]);
            vertices.insert(vertices.end(), begin, begin + length);
            offsets.push_back(static_cast<double>(vertices.size()));
            at += static_cast<std::size_t>(length) + 1;
        }
        return cell_rows(offsets, vertices, cells_.n_vertices(), refuse());
    }

    CellRows read_sized_text(std::int64_t n) {
        CellRows rows;
        for (std::int64_t i = 0; i < n; ++i) {
            if (!text_.next_content()) text_.fail(fmt::format("the file ends after {} of {} cells", i, n));
            rows.lines.push_back(text_.line());
            const std::int64_t size = read_count(text_, "number of corners", 2);
            for (std::int64_t c = 0; c < size; ++c) {
                text_.next_content();
                read_corners(text_, cells_.n_vertices(), 0, 1, rows.corners);
            }
            rows.first.push_back(static_cast<std::int64_t>(rows.corners.size()));
        }
        return rows;
    }

    void add(const CellRows& rows, std::size_t i, std::int64_t type) {
        const auto corners = std::span(rows.corners)
                                 .subspan(static_cast<std::size_t>(rows.first[i]),
                                          static_cast<std::size_t>(rows.first[i + 1] - rows.first[i]));
        const int line = i < rows.lines.size() ? rows.lines[i] : text_.line();
        if (!add_cell(cells_, type, corners, line))
            text_.fail_at(
                line, fmt::format("a cell of type {} with {} corners: only triangles, quads, polygons and "
                                  "tetrahedra are supported, with lines and points, which are left out",
                                  type, corners.size()));
    }
    void add_all(const CellRows& rows, int type) {
        for (std::size_t i = 0; i < rows.count(); ++i) add(rows, i, type);
    }

    void read_types() {
        const std::int64_t n = count("number of cell types");
        if (static_cast<std::size_t>(n) != rows_.count())
            text_.fail(fmt::format("there are {} cells, but {} types", rows_.count(), n));
        const std::vector<double> types = read_numbers(n, "int", "cell types");
        for (std::size_t i = 0; i < types.size(); ++i) {
            if (!(types[i] >= 0 && types[i] < 256)) text_.fail(fmt::format("{} is no cell type", types[i]));
            add(rows_, i, static_cast<std::int64_t>(types[i]));
        }
    }

    // Up to a blank line.
    void skip_metadata() {
        for (text_.next_line(); text_.remaining() > 0 && !text_.at_line_end();) text_.next_line();
    }

    // ---- arrays of points and cells, which come last ----
    // What is wrong there does not spoil the surface.
    void try_attributes(bool of_points) {
        try {
            read_attributes(of_points);
        } catch (const IoError& error) {
            cells_.notices.push_back(fmt::format("values of points or cells are left out: {}", error.what()));
        }
    }
    void read_attributes(bool of_points) {
        for (;;) {
            n_rows_ = read_count(text_, of_points ? "number of points" : "number of cells", 0);
            if (of_points && n_rows_ != cells_.n_vertices())
                text_.fail(fmt::format("POINT_DATA has {} rows for {} points", n_rows_, cells_.n_vertices()));
            text_.next_line();
            std::string next = read_arrays(of_points);
            if (next.empty()) return;
            of_points = next == "point_data";
        }
    }

    // Until the file ends or the other kind of data begins, which is returned.
    std::string read_arrays(bool of_points) {
        for (; text_.next_content(); next_line()) {
            const std::string key_word = in_lower_case(text_.word());
            if (key_word == "point_data" || key_word == "cell_data") return key_word;
            if (key_word == "metadata") {
                skip_metadata();
            } else if (key_word == "field") {
                read_fields(n_rows_, of_points);
            } else if (key_word == "lookup_table") {
                skip_lookup_table();
            } else if (!read_array(key_word, of_points)) {
                cells_.notices.push_back(
                    fmt::format("line {}: '{}' is not known; it and what follows is left out", text_.line(),
                                std::string(key_word).substr(0, 24)));
                return {};
            }
        }
        return {};
    }

    void skip_lookup_table() {
        text_.word();
        const std::int64_t n = read_count(text_, "size of the lookup table", 0);
        read_numbers(4 * n, is_binary_ ? "unsigned_char" : "float", "colors");
    }

    bool read_array(const std::string& kind, bool of_points) {
        const std::string name = decoded(text_.word());
        if (kind == "color_scalars") {
            const std::int64_t width = read_count(text_, "number of colors", 0);
            const std::string type = is_binary_ ? "unsigned_char" : "float";
            keep(of_points, "colors", name, type, width, rows(width, type));
            return true;
        }
        std::int64_t width = kind == "scalars" ? 1 : kind == "vectors" || kind == "normals" ? 3 : 0;
        if (kind == "tensors") width = 9;
        if (kind == "tensors6") width = 6;
        if (kind == "global_ids" || kind == "pedigree_ids") width = 1;
        if (kind == "texture_coordinates") width = read_count(text_, "number of coordinates", 0);
        if (width < 1) return false;
        const std::string type = type_word();
        if (kind == "scalars") {
            if (!text_.at_line_end()) width = read_count(text_, "number of components", 0);
            skip_table_name();
        }
        const std::string role = kind == "normals"               ? "normals"
                                 : kind == "texture_coordinates" ? "texture coordinates"
                                                                 : "";
        keep(of_points, role, name, type, width, rows(width, type));
        return true;
    }
    // LOOKUP_TABLE NAME, in a line of its own before the numbers; may be missing.
    void skip_table_name() {
        const TextCursor before = text_;
        text_.next_line();
        text_.next_content();
        if (in_lower_case(text_.word()) != "lookup_table") text_ = before;
    }
    std::vector<double> rows(std::int64_t width, const std::string& type) {
        constexpr std::int64_t most = 1 << 20;
        if (width < 1 || width > most) text_.fail(fmt::format("an array cannot have {} components", width));
        return read_numbers(width * n_rows_, type, "numbers");
    }
    void keep(bool of_points, const std::string& role, const std::string& name, const std::string& type,
              std::int64_t width, const std::vector<double>& numbers) {
        if (!of_points) {
            cells_.notices.push_back(fmt::format("values of cells are left out: '{}'", name));
            return;
        }
        add_point_array(cells_.points, role, name, *legacy_vtk_type(type), static_cast<Eigen::Index>(width),
                        numbers);
    }

    // FIELD NAME N, then N arrays: name, components, rows, type. n_rows 0: of the whole file, passed over.
    void read_fields(std::int64_t n_rows, bool of_points) {
        text_.word();
        const std::int64_t n = read_count(text_, "number of arrays", 0);
        for (std::int64_t i = 0; i < n; ++i) {
            next_line();
            if (!text_.next_content()) text_.fail(fmt::format("the file ends after {} of {} arrays", i, n));
            const std::string_view first = text_.word();
            if (in_lower_case(first) == "metadata") {
                skip_metadata();
                --i;
                continue;
            }
            const std::string name = decoded(first);
            const std::int64_t width = read_count(text_, "number of components", 0),
                               count = read_count(text_, "number of rows", 0);
            const std::string type = type_word();
            constexpr std::int64_t most = 1 << 20;
            if (width > most) text_.fail(fmt::format("an array cannot have {} components", width));
            const std::vector<double> numbers = read_numbers(width * count, type, "numbers");
            if (n_rows > 0 && count == n_rows && width > 0) keep(of_points, "", name, type, width, numbers);
        }
    }

    TextCursor text_;
    bool is_binary_;
    Cells cells_;
    CellRows rows_;
    std::int64_t n_rows_ = 0;
    bool at_line_begin_ = false;
};

}  // namespace

Cells read_vtk(std::string_view bytes, const std::string& name) {
    const std::string_view text = without_mark(bytes);
    if (!text.starts_with("# vtk DataFile"))
        throw IoError(
            fmt::format("{}:1: not a legacy VTK file: it does not begin with '# vtk DataFile'", name));
    // The second line is a title of any text.
    std::string_view rest = text;
    for (int line = 1; line <= 2; ++line) rest.remove_prefix(std::min(rest.size(), rest.find('\n') + 1));
    TextCursor cursor(rest, name, 3);
    cursor.next_content();
    const std::string kind = in_lower_case(cursor.word());
    if (kind != "ascii" && kind != "binary") cursor.fail("the third line must be ASCII or BINARY");
    cursor.next_line();
    return LegacyReader(std::move(cursor), kind == "binary").read();
}

}  // namespace counterpart::io
