// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// GIfTI surfaces (GIFTI Surface Data Format 1.0): points, triangles, and arrays of points, in text or base64,
// as they are or by zlib. Points stay in the space that the file gives them in: its matrices to other spaces
// are not applied.
#include "base/base64.hpp"
#include "io/inflate.hpp"
#include "io/vtk_data.hpp"
#include "io/xml.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>

#include <fmt/format.h>

namespace counterpart::io {
namespace {

class GiftiReader {
  public:
    GiftiReader(std::string_view bytes, const std::string& name) : name_(name) {
        parse_xml(bytes, name, xml_);
    }

    Cells read() {
        const pugi::xml_node root = xml_.child("GIFTI");
        if (!root) fail("not a GIfTI file: there is no element GIFTI");
        for (const pugi::xml_node node : root.children("DataArray")) {
            const std::string_view intent = node.attribute("Intent").value();
            if (intent == "NIFTI_INTENT_POINTSET")
                add_points(node);
            else if (intent == "NIFTI_INTENT_TRIANGLE")
                triangles_.push_back(node);
            else
                values_.push_back(node);
        }
        if (cells_.coordinates.empty())
            fail("there are no points: it holds data of a surface, not the surface");
        for (const pugi::xml_node node : triangles_) add_triangles(node);
        for (const pugi::xml_node node : values_) add_values(node);
        return std::move(cells_);
    }

  private:
    [[noreturn]] void fail(const std::string& reason) const {
        throw IoError(fmt::format("{}: {}", name_, reason));
    }

    struct Array {
        std::size_t rows = 0, columns = 1;
        NumberType type = NumberType::float32;
        std::vector<double> numbers;  // row by row
    };

    void add_points(pugi::xml_node node) {
        if (!cells_.coordinates.empty()) fail("there are two sets of points");
        const Array array = read_array(node);
        if (array.columns != 3) fail(fmt::format("points have {} coordinates, not 3", array.columns));
        cells_.coordinates = array.numbers;
    }

    void add_triangles(pugi::xml_node node) {
        const Array array = read_array(node);
        if (array.columns != 3) fail(fmt::format("triangles have {} corners, not 3", array.columns));
        for (std::size_t i = 0; i < array.numbers.size(); ++i) {
            const double v = array.numbers[i];
            if (!(v >= 0 && v < static_cast<double>(cells_.n_vertices())))
                fail(fmt::format("triangle {} names vertex {}, but vertices run from 0 to {}", i / 3, v,
                                 cells_.n_vertices() - 1));
            cells_.face_corners.push_back(static_cast<Index>(v));
        }
        cells_.face_sizes.insert(cells_.face_sizes.end(), array.rows, 3);
    }

    // What is wrong there does not spoil the surface.
    void add_values(pugi::xml_node node) {
        const std::string array_name = name_of(node);
        try {
            const Array array = read_array(node);
            if (static_cast<std::int64_t>(array.rows) != cells_.n_vertices())
                fail(fmt::format("'{}' has {} rows for {} points", array_name, array.rows,
                                 cells_.n_vertices()));
            const bool is_normals =
                node.attribute("Intent").value() == std::string_view("NIFTI_INTENT_VECTOR") &&
                array.columns == 3;
            add_point_array(cells_.points, is_normals ? "normals" : "", array_name,
                            NumberType::float64,  // no bytes that are colors
                            static_cast<Eigen::Index>(array.columns), array.numbers);
        } catch (const IoError& error) {
            cells_.notices.push_back(fmt::format("values of points are left out: {}", error.what()));
        }
    }

    // What the file calls the array, or what it means: NIFTI_INTENT_SHAPE is "shape".
    static std::string name_of(pugi::xml_node node) {
        for (const pugi::xml_node entry : node.child("MetaData").children("MD"))
            if (entry.child("Name").text().get() == std::string_view("Name"))
                return entry.child("Value").text().get();
        std::string intent = node.attribute("Intent").value();
        constexpr std::string_view prefix = "NIFTI_INTENT_";
        if (intent.starts_with(prefix)) intent.erase(0, prefix.size());
        for (char& c : intent) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
        return intent.empty() ? "values" : intent;
    }

    Array read_array(pugi::xml_node node) const {
        Array array;
        const int dimensionality = node.attribute("Dimensionality").as_int(1);
        if (dimensionality < 1 || dimensionality > 2)
            fail(fmt::format("arrays of {} dimensions are not supported", dimensionality));
        array.rows = dimension(node, "Dim0");
        if (dimensionality == 2) array.columns = dimension(node, "Dim1");
        constexpr std::uint64_t numbers = std::uint64_t{1} << 33U, bytes = 8;
        // No product that overflows.
        constexpr std::uint64_t most =
            std::min<std::uint64_t>(numbers, std::numeric_limits<std::size_t>::max() / bytes);
        if (array.columns > 0 && array.rows > most / array.columns)
            fail(fmt::format("an array of {} x {} numbers is too large", array.rows, array.columns));
        array.type = type_of(node.attribute("DataType").value());
        const std::string_view encoding = node.attribute("Encoding").value();
        const char* text = node.child("Data").text().get();
        array.numbers =
            encoding == "ASCII" ? text_numbers(text, array) : binary_numbers(node, encoding, text, array);
        if (node.attribute("ArrayIndexingOrder").value() == std::string_view("ColumnMajorOrder"))
            transpose(array);
        return array;
    }

    std::size_t dimension(pugi::xml_node node, const char* key) const {
        constexpr long long most = 2'147'483'647;
        const long long n = node.attribute(key).as_llong(-1);
        if (n < 0 || n > most) fail(fmt::format("{} is {}", key, n));
        return static_cast<std::size_t>(n);
    }

    NumberType type_of(std::string_view type) const {
        if (type == "NIFTI_TYPE_FLOAT32") return NumberType::float32;
        if (type == "NIFTI_TYPE_FLOAT64") return NumberType::float64;
        if (type == "NIFTI_TYPE_INT32") return NumberType::int32;
        if (type == "NIFTI_TYPE_UINT32") return NumberType::uint32;
        if (type == "NIFTI_TYPE_UINT8") return NumberType::uint8;
        if (type == "NIFTI_TYPE_INT16") return NumberType::int16;
        if (type == "NIFTI_TYPE_INT64") return NumberType::int64;
        fail(fmt::format("numbers of type '{}' are not supported", std::string(type.substr(0, 24))));
    }

    std::vector<double> text_numbers(std::string_view text, const Array& array) const {
        if (array.rows > text.size() || array.columns > text.size())
            fail("an array is announced that the file has no room for");
        std::vector<double> numbers;
        TextCursor cursor(text, name_ + ": an array");
        while (cursor.next_content()) numbers.push_back(cursor.number("number"));
        if (numbers.size() != array.rows * array.columns)
            fail(fmt::format("an array has {} numbers, not {} x {}", numbers.size(), array.rows,
                             array.columns));
        return numbers;
    }

    std::vector<double> binary_numbers(pugi::xml_node node, std::string_view encoding, std::string_view text,
                                       const Array& array) const {
        if (encoding == "ExternalFileBinary")
            fail("its numbers lie in another file, which is not supported: save it with base64");
        if (encoding != "Base64Binary" && encoding != "GZipBase64Binary")
            fail(fmt::format("encoding '{}' is not known", std::string(encoding.substr(0, 24))));
        auto bytes = from_base64(text);
        if (!bytes) fail("an array is not valid base64");
        const std::size_t size = array.rows * array.columns * size_of(array.type);
        if (encoding == "GZipBase64Binary") bytes = inflate(*bytes, size);
        if (!bytes || bytes->size() != size)
            fail(fmt::format("an array is damaged: it does not hold {} x {} numbers", array.rows,
                             array.columns));
        const bool is_big = node.attribute("Endian").value() == std::string_view("BigEndian");
        return numbers_of(*bytes, array.type, is_big ? std::endian::big : std::endian::little);
    }

    static void transpose(Array& array) {
        const std::vector<double> columns = array.numbers;
        for (std::size_t i = 0; i < array.rows; ++i)
            for (std::size_t k = 0; k < array.columns; ++k)
                array.numbers[i * array.columns + k] = columns[k * array.rows + i];
    }

    std::string name_;
    pugi::xml_document xml_;
    Cells cells_;
    std::vector<pugi::xml_node> triangles_, values_;
};

}  // namespace

Cells read_gifti(std::string_view bytes, const std::string& name) { return GiftiReader(bytes, name).read(); }

}  // namespace counterpart::io
