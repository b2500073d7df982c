// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// VTK's XML format of POLYDATA (VTK file formats, "XML file formats"): arrays as text, in base64, or appended
// behind the XML, as they are or by zlib.
#include "base/base64.hpp"
#include "io/byte_order.hpp"
#include "io/inflate.hpp"
#include "io/vtk_data.hpp"
#include "io/xml.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace counterpart::io {
namespace {

class XmlReader {
  public:
    XmlReader(std::string_view bytes, const std::string& name) : name_(name) {
        // What is appended raw is no XML: it begins behind the first underscore of its element.
        const std::size_t element = bytes.find("<AppendedData");
        const std::size_t begin = element == bytes.npos ? element : bytes.find('_', element);
        if (begin == bytes.npos) {
            parse_xml(bytes, name, xml_);
        } else {
            parse_xml(std::string(bytes.substr(0, begin)) + "</AppendedData></VTKFile>", name, xml_);
            appended_ = bytes.substr(begin + 1);
        }
        const pugi::xml_node file = xml_.child("VTKFile");
        if (!file) fail("not a VTK file: there is no element VTKFile");
        if (file.attribute("type").value() != std::string_view("PolyData"))
            fail(fmt::format("only PolyData is supported, not {}", shown(file.attribute("type").value())));
        const std::string_view order = file.attribute("byte_order").value();
        order_ = order == "BigEndian" ? std::endian::big : std::endian::little;
        const std::string_view header = file.attribute("header_type").as_string("UInt32");
        if (header != "UInt32" && header != "UInt64") fail("header_type must be UInt32 or UInt64");
        header_size_ = header == "UInt64" ? 8 : 4;
        const std::string_view compressor = file.attribute("compressor").value();
        is_compressed_ = !compressor.empty();
        if (is_compressed_ && compressor != "vtkZLibDataCompressor")
            fail(fmt::format("{} is not supported: save it with zlib or uncompressed", shown(compressor)));
        appended_is_raw_ =
            file.child("AppendedData").attribute("encoding").as_string("raw") == std::string_view("raw");
    }

    Cells read() {
        Cells cells;
        for (const pugi::xml_node piece : xml_.child("VTKFile").child("PolyData").children("Piece"))
            add_piece(piece, cells);
        if (cells.coordinates.empty()) fail("there is no Piece with points");
        return cells;
    }

  private:
    [[noreturn]] void fail(const std::string& reason) const {
        throw IoError(fmt::format("{}: {}", name_, reason));
    }
    static std::string shown(std::string_view text) {
        std::string word(text.substr(0, 24));
        std::replace_if(
            word.begin(), word.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
        return word;
    }

    void add_piece(pugi::xml_node piece, Cells& cells) {
        const std::int64_t before = cells.n_vertices();
        const Array points = read_array(piece.child("Points").child("DataArray"), "Points");
        if (points.numbers.size() % 3 != 0) fail("the number of coordinates is no multiple of 3");
        cells.coordinates.insert(cells.coordinates.end(), points.numbers.begin(), points.numbers.end());
        const auto n = static_cast<std::int64_t>(points.numbers.size() / 3);
        add_cells(piece.child("Polys"), VtkCell::polygon, before, n, cells);
        add_cells(piece.child("Strips"), VtkCell::triangle_strip, before, n, cells);
        if (before > 0) {  // what pieces hold differs
            cells.points = {};
            return;
        }
        add_point_data(piece.child("PointData"), n, cells);
        for (const pugi::xml_node array : piece.child("CellData").children("DataArray"))
            cells.notices.push_back(
                fmt::format("values of cells are left out: '{}'", shown(array.attribute("Name").value())));
    }

    void add_cells(pugi::xml_node node, VtkCell type, std::int64_t before, std::int64_t n, Cells& cells) {
        if (!node) return;
        std::vector<double> offsets{0}, corners;
        for (const pugi::xml_node array : node.children("DataArray")) {
            const std::string_view role = array.attribute("Name").value();
            if (role == "connectivity") corners = read_array(array, "connectivity").numbers;
            if (role == "offsets") {
                const Array found = read_array(array, "offsets");
                offsets.insert(offsets.end(), found.numbers.begin(), found.numbers.end());
            }
        }
        CellRows rows = cell_rows(offsets, corners, n, [this](const std::string& reason) { fail(reason); });
        if (before + n > max_points) fail("the mesh has more than 2147483647 points");
        for (Index& v : rows.corners) v += static_cast<Index>(before);
        for (std::size_t i = 0; i < rows.count(); ++i) {
            const auto size = static_cast<std::size_t>(rows.first[i + 1] - rows.first[i]);
            const auto one = std::span(rows.corners).subspan(static_cast<std::size_t>(rows.first[i]), size);
            if (!add_cell(cells, static_cast<int>(type), one, 0))
                fail(fmt::format("face {} has {} corners; at least 3 are needed", i, size));
        }
    }

    // What is wrong there does not spoil the surface.
    void add_point_data(pugi::xml_node data, std::int64_t n, Cells& cells) {
        const auto is_named = [&](const char* attribute, std::string_view array) {
            return !array.empty() && data.attribute(attribute).value() == array;
        };
        for (const pugi::xml_node node : data.children("DataArray")) {
            const std::string array_name = node.attribute("Name").value();
            try {
                const Array array = read_array(node, array_name);
                if (static_cast<std::int64_t>(array.numbers.size()) != n * array.width)
                    fail(fmt::format("'{}' has {} numbers for {} points", shown(array_name),
                                     array.numbers.size(), n));
                const char* role = is_named("Normals", array_name)   ? "normals"
                                   : is_named("TCoords", array_name) ? "texture coordinates"
                                                                     : "";
                add_point_array(cells.points, role, array_name, array.type, array.width, array.numbers);
            } catch (const IoError& error) {
                cells.notices.push_back(fmt::format("values of points are left out: {}", error.what()));
            }
        }
    }

    struct Array {
        std::vector<double> numbers;
        NumberType type = NumberType::float64;
        Eigen::Index width = 1;
    };

    Array read_array(pugi::xml_node node, const std::string& what) const {
        if (!node) fail(fmt::format("there is no array '{}'", shown(what)));
        Array array;
        const auto type = xml_vtk_type(node.attribute("type").value());
        if (!type)
            fail(fmt::format("'{}' is of type {}", shown(what), shown(node.attribute("type").value())));
        array.type = *type;
        constexpr int most = 1 << 20;
        array.width = std::clamp(node.attribute("NumberOfComponents").as_int(1), 1, most);
        const std::string_view format = node.attribute("format").as_string("ascii");
        if (format == "ascii") {
            array.numbers = text_numbers(node.text().get(), what);
        } else if (format == "binary") {
            array.numbers = numbers_of(inline_bytes(node.text().get(), what), *type, what);
        } else if (format == "appended") {
            array.numbers = numbers_of(appended_bytes(node, what), *type, what);
        } else {
            fail(fmt::format("'{}' has format {}", shown(what), shown(format)));
        }
        return array;
    }

    std::vector<double> numbers_of(const std::string& bytes, NumberType type, const std::string& what) const {
        if (bytes.size() % size_of(type) != 0) fail(fmt::format("'{}' ends within a number", shown(what)));
        return io::numbers_of(bytes, type, order_);
    }

    std::vector<double> text_numbers(std::string_view text, const std::string& what) const {
        std::vector<double> numbers;
        TextCursor cursor(text, fmt::format("{}: '{}'", name_, shown(what)));
        while (cursor.next_content()) numbers.push_back(cursor.number("a number"));
        return numbers;
    }

    std::uint64_t header_number(std::string_view bytes, std::size_t i) const {
        const char* at = bytes.data() + i * header_size_;
        return header_size_ == 8 ? load_number<std::uint64_t>(at, order_)
                                 : load_number<std::uint32_t>(at, order_);
    }

    std::string decoded(std::string_view text, const std::string& what) const {
        auto bytes = from_base64(text);
        if (!bytes) fail(fmt::format("'{}' is not valid base64", shown(what)));
        return *std::move(bytes);
    }

    // Characters of base64 for so many bytes.
    static std::size_t encoded_size(std::size_t bytes) { return (bytes + 2) / 3 * 4; }

    // Header and data are one piece of base64 each where data is compressed, else one together.
    std::string inline_bytes(std::string_view text, const std::string& what) const {
        const std::size_t first = text.find_first_not_of(" \t\r\n");
        text.remove_prefix(std::min(first, text.size()));
        if (!is_compressed_) return without_header(decoded(text, what), what);
        const std::string count = decoded(text.substr(0, encoded_size(header_size_)), what);
        if (count.size() < header_size_) fail(fmt::format("'{}' is cut off", shown(what)));
        const std::size_t size = header_bytes(header_number(count, 0), text.size(), what);
        const std::size_t header_end = std::min(encoded_size(size), text.size());
        return inflated(decoded(text.substr(0, header_end), what), decoded(text.substr(header_end), what),
                        what);
    }

    std::string appended_bytes(pugi::xml_node node, const std::string& what) const {
        const std::uint64_t offset = node.attribute("offset").as_ullong(~0ULL);
        if (offset > appended_.size()) fail(fmt::format("'{}' lies beyond the end of the file", shown(what)));
        const std::string_view bytes = appended_.substr(static_cast<std::size_t>(offset));
        if (!appended_is_raw_) return inline_bytes(bytes.substr(0, bytes.find('<')), what);
        if (bytes.size() < header_size_) fail(fmt::format("'{}' is cut off", shown(what)));
        if (!is_compressed_) return without_header(bytes, what);
        const std::size_t size = header_bytes(header_number(bytes, 0), bytes.size(), what);
        if (size > bytes.size()) fail(fmt::format("'{}' is cut off", shown(what)));
        return inflated(bytes.substr(0, size), bytes.substr(size), what);
    }

    // Number of bytes, then the bytes.
    std::string without_header(std::string_view bytes, const std::string& what) const {
        if (bytes.size() < header_size_ || header_number(bytes, 0) > bytes.size() - header_size_)
            fail(fmt::format("'{}' is cut off", shown(what)));
        return std::string(bytes.substr(header_size_, static_cast<std::size_t>(header_number(bytes, 0))));
    }

    // Of a header: number of blocks, size of a block, size of the last one if it is not whole, then the
    // compressed size of each.
    std::size_t header_bytes(std::uint64_t n_blocks, std::size_t available, const std::string& what) const {
        if (n_blocks > available / header_size_) fail(fmt::format("'{}' is cut off", shown(what)));
        return (3 + static_cast<std::size_t>(n_blocks)) * header_size_;
    }

    std::string inflated(std::string_view header, std::string_view data, const std::string& what) const {
        const std::uint64_t n_blocks = header_number(header, 0);
        if (header.size() < header_bytes(n_blocks, header.size(), what))
            fail(fmt::format("'{}' is cut off", shown(what)));
        const std::uint64_t whole = header_number(header, 1), last = header_number(header, 2);
        std::string bytes;
        for (std::uint64_t i = 0; i < n_blocks; ++i) {
            const std::uint64_t announced = header_number(header, 3 + static_cast<std::size_t>(i));
            if (announced > data.size()) fail(fmt::format("'{}' is cut off", shown(what)));
            const auto compressed = static_cast<std::size_t>(announced);
            const auto block =
                inflate(data.substr(0, compressed), i + 1 == n_blocks && last > 0 ? last : whole);
            if (!block) fail(fmt::format("'{}' is damaged: zlib cannot unpack it", shown(what)));
            bytes += *block;
            data.remove_prefix(compressed);
        }
        return bytes;
    }

    static constexpr std::int64_t max_points = 2'147'483'647;

    std::string name_;
    pugi::xml_document xml_;
    std::string_view appended_;
    bool appended_is_raw_ = true, is_compressed_ = false;
    std::endian order_ = std::endian::little;
    std::size_t header_size_ = 4;
};

}  // namespace

Cells read_vtp(std::string_view bytes, const std::string& name) { return XmlReader(bytes, name).read(); }

}  // namespace counterpart::io
