// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// POLYDATA of VTK: legacy 3.0 as text, which every program reads, and XML with numbers in base64.
#include "base/base64.hpp"
#include "io/byte_order.hpp"
#include "io/decimal.hpp"
#include "io/vtk_data.hpp"

#include <cmath>
#include <cstdint>
#include <limits>

#include <fmt/format.h>

namespace counterpart {

using namespace io;

namespace {

// Labels stay whole numbers.
bool are_whole(const Matrix& values) {
    return (values.array() == values.array().round()).all() &&
           (values.array().abs() <= std::numeric_limits<Index>::max()).all();
}

// In one word, as VTK's readers decode it.
std::string encoded(const std::string& name) {
    std::string word;
    for (const char c : name) {
        if (c > ' ' && c <= '~' && c != '%' && c != '"' && c != '#')
            word += c;
        else
            word += fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
    return word;
}

void append_rows(std::string& text, const Matrix& values) {
    for (Eigen::Index i = 0; i < values.rows(); ++i) {
        for (Eigen::Index k = 0; k < values.cols(); ++k) {
            if (k > 0) text += ' ';
            append_decimal(text, values(i, k));
        }
        text += '\n';
    }
}

void append_array(std::string& text, const WrittenArray& array) {
    const std::string name = encoded(array.name);
    if (array.role == "normals")
        text += fmt::format("NORMALS {} double\n", name);
    else if (array.role == "texture coordinates")
        text += fmt::format("TEXTURE_COORDINATES {} 2 double\n", name);
    else if (array.role == "colors")
        text += fmt::format("COLOR_SCALARS {} {}\n", name, array.values.cols());
    else
        text += fmt::format("FIELD FieldData 1\n{} {} {} {}\n", name, array.values.cols(),
                            array.values.rows(), are_whole(array.values) ? "int" : "double");
    append_rows(text, array.values);
}

std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : text) {
        if (c == '<' || c == '>' || c == '&' || c == '"' || static_cast<unsigned char>(c) < ' ')
            result += fmt::format("&#{};", static_cast<unsigned char>(c) < ' ' ? '_' : static_cast<int>(c));
        else
            result += c;
    }
    return result;
}

// <DataArray>: the number of bytes, and the numbers, in one piece of base64.
template <class Number, class Values>
std::string data_array(const char* type, const std::string& name, Eigen::Index width, const Values& values) {
    std::string bytes;
    append_number(bytes, static_cast<std::uint64_t>(values.size()) * sizeof(Number));
    for (const auto value : values) append_number(bytes, static_cast<Number>(value));
    return fmt::format(
        "        <DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" "
        "format=\"binary\">{}</DataArray>\n",
        type, escaped(name), width, to_base64(bytes));
}

std::string data_array(const WrittenArray& array) {
    const auto values = array.values.reshaped<Eigen::RowMajor>();
    if (array.role.empty() && are_whole(array.values))
        return data_array<std::int32_t>("Int32", array.name, array.values.cols(), values);
    if (array.role == "colors") {
        std::vector<std::uint8_t> bytes;
        for (const double value : values)
            bytes.push_back(
                static_cast<std::uint8_t>(std::lround(255 * std::min(1.0, std::max(0.0, value)))));
        return data_array<std::uint8_t>("UInt8", array.name, array.values.cols(), bytes);
    }
    return data_array<double>("Float64", array.name, array.values.cols(), values);
}

// <PointData Normals="..." ...>: which arrays mean what.
std::string point_data(const std::vector<WrittenArray>& arrays) {
    std::string attributes, content;
    for (const WrittenArray& array : arrays) {
        const char* meaning = array.role == "normals"               ? "Normals"
                              : array.role == "texture coordinates" ? "TCoords"
                              : array.role == "colors"              ? "Scalars"
                                                                    : nullptr;
        if (meaning != nullptr) attributes += fmt::format(" {}=\"{}\"", meaning, escaped(array.name));
        content += data_array(array);
    }
    return fmt::format("      <PointData{}>\n{}      </PointData>\n", attributes, content);
}

}  // namespace

std::string io::vtk_bytes(const AttributedMesh& content) {
    const MeshView mesh = content.mesh;
    const FaceList faces = face_list(mesh);
    std::string text =
        fmt::format("# vtk DataFile Version 3.0\ncounterpart\nASCII\nDATASET POLYDATA\nPOINTS {} double\n",
                    mesh.n_vertices());
    append_rows(text, mesh.vertices);
    text += fmt::format("POLYGONS {} {}\n", faces.ends.size(), faces.ends.size() + faces.vertices.size());
    Index begin = 0;
    for (const Index end : faces.ends) {
        append_decimal(text, end - begin);
        for (; begin < end; ++begin) {
            text += ' ';
            append_decimal(text, faces.vertices[static_cast<std::size_t>(begin)]);
        }
        text += '\n';
    }
    const std::vector<WrittenArray> arrays = point_arrays(content);
    if (!arrays.empty()) text += fmt::format("POINT_DATA {}\n", mesh.n_vertices());
    for (const WrittenArray& array : arrays) append_array(text, array);
    return text;
}

std::string io::vtp_bytes(const AttributedMesh& content) {
    const MeshView mesh = content.mesh;
    const FaceList faces = face_list(mesh);
    return fmt::format(
        "<?xml version=\"1.0\"?>\n"
        "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
        "  <PolyData>\n"
        "    <Piece NumberOfPoints=\"{}\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" "
        "NumberOfPolys=\"{}\">\n"
        "{}      <Points>\n{}      </Points>\n      <Polys>\n{}{}      </Polys>\n"
        "    </Piece>\n  </PolyData>\n</VTKFile>\n",
        mesh.n_vertices(), faces.ends.size(), point_data(point_arrays(content)),
        data_array<double>("Float64", "Points", 3, mesh.vertices.reshaped<Eigen::RowMajor>()),
        data_array<std::int32_t>("Int32", "connectivity", 1, faces.vertices),
        data_array<std::int32_t>("Int32", "offsets", 1, faces.ends));
}

}  // namespace counterpart
