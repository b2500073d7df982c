// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Surfaces in VTK's formats and GIfTI: what those who use them write, and what is damaged.
#include "base/base64.hpp"
#include "io/cells.hpp"
#include "io/inflate.hpp"
#include "support/expect_error.hpp"
#include "support/temporary_folder.hpp"

#include <counterpart/io/file.hpp>
#include <counterpart/io/mesh_file.hpp>
#include <counterpart/mesh/shapes.hpp>

#include <algorithm>
#include <bit>
#include <cstring>

#include <gtest/gtest.h>
#include <zlib.h>

namespace counterpart {
namespace {

using io::Cells;

const std::string vtk_head = "# vtk DataFile Version 3.0\na title\n";
const Triangles two_triangles = (Triangles(2, 3) << 0, 1, 2, 2, 1, 3).finished();

AttributedMeshFile surface_of(const Cells& cells) { return io::content_of_cells(cells, "a.vtk"); }
TriangleMesh legacy_mesh(const std::string& text) {
    return surface_of(io::read_vtk(text, "a.vtk")).content.mesh;
}

template <class Number>
std::string big_endian(std::initializer_list<Number> numbers) {
    std::string bytes;
    for (const Number number : numbers) {
        std::string one(sizeof number, ' ');
        std::memcpy(one.data(), &number, sizeof number);
        if (std::endian::native == std::endian::little) std::reverse(one.begin(), one.end());
        bytes += one;
    }
    return bytes;
}

std::string deflated(const std::string& bytes) {
    uLongf size = compressBound(bytes.size());
    std::string result(size, ' ');
    compress(reinterpret_cast<Bytef*>(result.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
             bytes.size());
    result.resize(size);
    return result;
}

template <class Number>
std::string bytes_of(std::initializer_list<Number> numbers) {
    std::string bytes;
    for (const Number number : numbers) bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
    return bytes;
}

TEST(Vtk, PolygonsAndStripsAsText) {
    const std::string points =
        vtk_head + "ASCII\nDATASET POLYDATA\nPOINTS 4 float\n0 0 0 1 0 0\n0 1 0 1 1 0\n";
    EXPECT_EQ(legacy_mesh(points + "POLYGONS 2 8\n3 0 1 2\n3 2 1 3\n").triangles, two_triangles);
    EXPECT_EQ(legacy_mesh(points + "TRIANGLE_STRIPS 1 5\n4 0 1 2 3\n").triangles, two_triangles);
    EXPECT_EQ(
        legacy_mesh(points + "VERTICES 1 2\n1 0\nLINES 1 3\n2 0 1\nPOLYGONS 1 5\n4 0 1 3 2\n").polygons.first,
        (std::vector<Index>{0, 4}));
    const std::string five =
        "POLYGONS 3 6\nOFFSETS vtktypeint64\n0 3 6\nCONNECTIVITY vtktypeint64\n0 1 2 2 1 3\n";
    EXPECT_EQ(legacy_mesh(points + five).triangles, two_triangles);
    EXPECT_EQ(legacy_mesh(points + "METADATA\nINFORMATION 0\n\n" + five).triangles, two_triangles);
    EXPECT_EQ(legacy_mesh("\xef\xbb\xbf" + points + five).triangles, two_triangles);
}

TEST(Vtk, Binary) {
    const std::string points = vtk_head + "BINARY\nDATASET POLYDATA\nPOINTS 4 float\n" +
                               big_endian<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0});
    for (const char* end : {"\n", ""}) {  // some writers end what is binary with a line break
        const std::string four =
            end + std::string("POLYGONS 2 8\n") + big_endian<std::int32_t>({3, 0, 1, 2, 3, 2, 1, 3});
        EXPECT_EQ(legacy_mesh(points + four).triangles, two_triangles);
        const std::string five = end + std::string("POLYGONS 3 6\nOFFSETS vtktypeint64\n") +
                                 big_endian<std::int64_t>({0, 3, 6}) + end + "CONNECTIVITY vtktypeint64\n" +
                                 big_endian<std::int64_t>({0, 1, 2, 2, 1, 3});
        const TriangleMesh mesh = legacy_mesh(points + five);
        EXPECT_EQ(mesh.triangles, two_triangles);
        EXPECT_EQ(mesh.vertices.row(3), Eigen::RowVector3d(1, 1, 0));
        const std::string grid = vtk_head + "BINARY\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 float\n" +
                                 points.substr(points.size() - 48) + end +
                                 "CELLS 3 6\nOFFSETS vtktypeint64\n" + big_endian<std::int64_t>({0, 3, 6}) +
                                 end + "CONNECTIVITY vtktypeint64\n" +
                                 big_endian<std::int64_t>({0, 1, 2, 2, 1, 3}) + end + "CELL_TYPES 2\n" +
                                 big_endian<std::int32_t>({5, 5});
        EXPECT_EQ(legacy_mesh(grid).triangles, two_triangles);
    }
}

TEST(Vtk, ArraysOfPoints) {
    const std::string text =
        vtk_head +
        "ASCII\nDATASET POLYDATA\nPOINTS 4 float\n0 0 0 1 0 0 0 1 0 1 1 0\nPOLYGONS 1 5\n4 0 1 3 2\n"
        "CELL_DATA 1\nSCALARS region int 1\nLOOKUP_TABLE default\n7\n"
        "POINT_DATA 4\nNORMALS n float\n0 0 1 0 0 1 0 0 1 0 0 1\n"
        "SCALARS two%20words int\nLOOKUP_TABLE default\n4 3 2 1\n"
        "COLOR_SCALARS c 3\n1 0 0 0 1 0 0 0 1 1 1 1\n"
        "TEXTURE_COORDINATES uv 2 float\n0 0 1 0 0 1 1 1\n"
        "FIELD f 2\nthick 1 4 double\n.5 .25 1 2\nMETADATA\nINFORMATION 0\n\nflow 2 4 float\n1 2 3 4 5 6 7 "
        "8\n";
    const AttributedMeshFile file = surface_of(io::read_vtk(text, "a.vtk"));
    const AttributedMesh& content = file.content;
    EXPECT_EQ(content.normals.values, (Matrix(4, 3) << 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1).finished());
    ASSERT_EQ(content.colors.size(), 1U);
    EXPECT_EQ(content.colors[0].values.row(1), Eigen::RowVector3d(0, 1, 0));
    ASSERT_EQ(content.texture_coordinates.size(), 1U);
    EXPECT_EQ(content.texture_coordinates[0].values.row(1), Eigen::RowVector2d(1, 1));  // from the upper edge
    ASSERT_EQ(content.values.size(), 3U);
    EXPECT_EQ(content.values[0].name, "two words");
    EXPECT_EQ(content.values[0].values, (Matrix(4, 1) << 4, 3, 2, 1).finished());
    EXPECT_EQ(content.values[1].values(1, 0), 0.25);
    EXPECT_EQ(content.values[2].values.row(3), Eigen::RowVector2d(7, 8));
    ASSERT_EQ(file.notices.size(), 1U);
    EXPECT_EQ(file.notices[0], "values of cells are left out: 'region'");
    // What is written comes back, in both formats.
    for (const Cells& again :
         {io::read_vtk(io::vtk_bytes(content), "a.vtk"), io::read_vtp(io::vtp_bytes(content), "a.vtp")}) {
        const AttributedMesh read = surface_of(again).content;
        EXPECT_EQ(read.mesh.vertices, content.mesh.vertices);
        EXPECT_EQ(read.mesh.polygons.first, content.mesh.polygons.first);
        EXPECT_EQ(read.normals.values, content.normals.values);
        EXPECT_EQ(read.colors.at(0).values, content.colors[0].values);
        EXPECT_EQ(read.texture_coordinates.at(0).values, content.texture_coordinates[0].values);
        ASSERT_EQ(read.values.size(), 3U);
        for (std::size_t i = 0; i < 3; ++i) {
            EXPECT_EQ(read.values[i].name, content.values[i].name);
            EXPECT_EQ(read.values[i].values, content.values[i].values);
        }
    }
}

TEST(Vtk, DamagedArraysDoNotSpoilTheSurface) {
    const std::string mesh =
        vtk_head + "ASCII\nDATASET POLYDATA\nPOINTS 3 float\n0 0 0 1 0 0 0 1 0\nPOLYGONS 1 4\n3 0 1 2\n";
    for (const char* data : {"POINT_DATA 4\nSCALARS a int\nLOOKUP_TABLE default\n1 2 3 4\n",
                             "POINT_DATA 3\nSCALARS a bit\n", "POINT_DATA 3\nSCALARS a int\n1 2\n",
                             "POINT_DATA 3\nNOTHING a int\n", "POINT_DATA 3\nFIELD f 1\na 9999999 3 int\n"}) {
        const AttributedMeshFile file = surface_of(io::read_vtk(mesh + data, "a.vtk"));
        EXPECT_EQ(file.content.mesh.n_triangles(), 1) << data;
        EXPECT_EQ(file.notices.size(), 1U) << data;
        EXPECT_TRUE(file.content.values.empty()) << data;
    }
}

TEST(Vtk, WhatIsWrongIsNamed) {
    const auto refused = [](const std::string& text, const std::string& part) {
        test::expect_error<IoError>([&] { surface_of(io::read_vtk(text, "a.vtk")); }, part);
    };
    const std::string ascii = vtk_head + "ASCII\nDATASET POLYDATA\n",
                      points = ascii + "POINTS 3 float\n0 0 0 1 0 0 0 1 0\n";
    refused(vtk_head + "ASCII\nDATASET STRUCTURED_GRID\n", "only DATASET POLYDATA and UNSTRUCTURED_GRID");
    refused(vtk_head + "OTHER\n", "a.vtk:3: the third line must be ASCII or BINARY");
    refused(ascii + "POINTS 2000000000 float\n0 0 0", "more than the file has room for");
    refused(ascii + "POINTS 3 complex\n0 0 0", "of type complex");
    refused(points + "POLYGONS 1 4\n3 0 1 3\n", "a.vtk:8: the element names vertex 3");
    refused(points + "POLYGONS 1 3\n2 0 1\n", "with 2 corners");
    refused(points + "POLYGONS 1 4\n3 0 1 2\nPOINTS 1 float\n0 0 0\n",
            "a.vtk:9: the points are given a second time");
    refused(points + "POLYGONS 2 3\nOFFSETS vtktypeint64\n0 4\nCONNECTIVITY vtktypeint64\n0 1 2\n",
            "offset 1");
    refused(points + "POLYGONS 2 3\nOFFSETS vtktypeint64\n0 3\nCONNECTIVITY vtktypeint64\n0 1 -1\n",
            "point -1");
    const std::string binary = vtk_head + "BINARY\nDATASET POLYDATA\nPOINTS 3 float\n";
    refused(binary + "short", "more than the file has room for");
    refused(binary + std::string(36, '\0') + "\nPOLYGONS 1 4\n" + big_endian<std::int32_t>({5, 0, 1, 2}),
            "cell 0 reaches beyond");
}

std::string vtp_text(const std::string& attributes, const std::string& points, const std::string& corners,
                     const std::string& offsets, const std::string& behind = "") {
    return "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" byte_order=\"LittleEndian\" " + attributes +
           "><PolyData><Piece NumberOfPoints=\"4\" NumberOfPolys=\"2\">\n<Points><DataArray type=\"Float32\" "
           "NumberOfComponents=\"3\" " +
           points +
           "</DataArray></Points>\n<Polys><DataArray type=\"Int32\" "
           "Name=\"connectivity\" " +
           corners + "</DataArray><DataArray type=\"Int32\" Name=\"offsets\" " + offsets +
           "</DataArray></Polys></Piece></PolyData>" + behind + "</VTKFile>\n";
}

const std::string points_4 = bytes_of<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}),
                  corners_6 = bytes_of<std::int32_t>({0, 1, 2, 2, 1, 3}),
                  offsets_2 = bytes_of<std::int32_t>({3, 6});

// With its header, as VTK compresses it in one block.
std::string compressed_header(const std::string& bytes) {
    const auto size = static_cast<std::uint32_t>(bytes.size());
    return bytes_of<std::uint32_t>({1, size, 0, static_cast<std::uint32_t>(deflated(bytes).size())});
}
std::string plain_block(const std::string& bytes) {
    return bytes_of<std::uint32_t>({static_cast<std::uint32_t>(bytes.size())}) + bytes;
}

TriangleMesh read_vtp_mesh(const std::string& text) {
    return io::content_of_cells(io::read_vtp(text, "a.vtp"), "a.vtp").content.mesh;
}

TEST(Vtp, TextBase64AndZlibWithinTheXml) {
    const std::string a = "format=\"ascii\">", b = "format=\"binary\">\n  ";
    EXPECT_EQ(
        read_vtp_mesh(vtp_text("", a + "0 0 0 1 0 0 0 1 0\n1 1 0", a + "0 1 2 2 1 3", a + "3 6")).triangles,
        two_triangles);
    const auto plain = [&](const std::string& bytes) { return b + to_base64(plain_block(bytes)) + "\n"; };
    EXPECT_EQ(read_vtp_mesh(vtp_text("", plain(points_4), plain(corners_6), plain(offsets_2))).triangles,
              two_triangles);
    const auto packed = [&](const std::string& bytes) {
        return b + to_base64(compressed_header(bytes)) + to_base64(deflated(bytes));
    };
    const std::string zlib = "compressor=\"vtkZLibDataCompressor\"";
    const TriangleMesh mesh =
        read_vtp_mesh(vtp_text(zlib, packed(points_4), packed(corners_6), packed(offsets_2)));
    EXPECT_EQ(mesh.triangles, two_triangles);
    EXPECT_EQ(mesh.vertices.row(3), Eigen::RowVector3d(1, 1, 0));
    EXPECT_EQ(
        read_vtp_mesh("\xef\xbb\xbf" + vtp_text("", plain(points_4), plain(corners_6), plain(offsets_2)))
            .triangles,
        two_triangles);
}

TEST(Vtp, AppendedRawInBase64AndByZlib) {
    for (const bool is_raw : {true, false}) {
        for (const bool is_compressed : {true, false}) {
            std::string data;
            const auto append = [&](const std::string& bytes) {
                const std::string at = "format=\"appended\" offset=\"" + std::to_string(data.size()) + "\">";
                const std::string header = is_compressed ? compressed_header(bytes) : "";
                const std::string block = is_compressed ? deflated(bytes) : plain_block(bytes);
                data +=
                    is_raw ? header + block : (header.empty() ? "" : to_base64(header)) + to_base64(block);
                return at;
            };
            const std::string a = append(points_4), b = append(corners_6), c = append(offsets_2);
            const std::string behind = std::string("<AppendedData encoding=\"") +
                                       (is_raw ? "raw" : "base64") + "\">\n_" + data + "\n</AppendedData>";
            const std::string zlib = is_compressed ? "compressor=\"vtkZLibDataCompressor\"" : "";
            EXPECT_EQ(read_vtp_mesh(vtp_text(zlib, a, b, c, behind)).triangles, two_triangles)
                << is_raw << is_compressed;
        }
    }
}

TEST(Vtp, WhatIsWrongIsNamed) {
    const std::string a = "format=\"ascii\">", points = a + "0 0 0 1 0 0 0 1 0\n1 1 0";
    const auto refused = [](const std::string& text, const std::string& part) {
        test::expect_error<IoError>([&] { io::content_of_cells(io::read_vtp(text, "a.vtp"), "a.vtp"); },
                                    part);
    };
    refused("<VTKFile", "a.vtp:1: the XML is damaged");
    refused("\n\n<a><b></a>", "a.vtp:3: the XML is damaged");
    refused("<a/>", "there is no element VTKFile");
    refused("<VTKFile type=\"ImageData\"/>", "only PolyData is supported, not ImageData");
    refused("<VTKFile type=\"PolyData\"/>", "no Piece with points");
    refused(vtp_text("compressor=\"vtkLZ4DataCompressor\"", points, a + "0 1 2", a + "3"),
            "vtkLZ4DataCompressor is not supported");
    refused(vtp_text("", points, a + "0 1 4", a + "3"), "a cell names point 4, but points run from 0 to 3");
    refused(vtp_text("", points, a + "0 1 2", a + "4"), "offset 1 of the cells is 4");
    refused(vtp_text("", points, a + "0 1", a + "2"), "face 0 has 2 corners");
    refused(vtp_text("", "format=\"binary\">AAAA", a + "0 1 2", a + "3"), "'Points' is cut off");
    refused(vtp_text("", "format=\"binary\">A*", a + "0 1 2", a + "3"), "'Points' is not valid base64");
    refused(vtp_text("", "format=\"appended\" offset=\"9\">", a + "0 1 2", a + "3"), "lies beyond the end");
    const std::string bomb = to_base64(bytes_of<std::uint32_t>({1, 4'000'000'000, 0, 4})) + to_base64("abcd");
    refused(
        vtp_text("compressor=\"vtkZLibDataCompressor\"", "format=\"binary\">" + bomb, a + "0 1 2", a + "3"),
        "zlib cannot unpack it");
}

TEST(Inflate, OnlyWhatFits) {
    const std::string bytes(100'000, 'x');
    EXPECT_EQ(io::inflate(deflated(bytes), bytes.size()), bytes);
    EXPECT_FALSE(io::inflate(deflated(bytes), bytes.size() - 1));
    EXPECT_FALSE(io::inflate(deflated(bytes), bytes.size() + 1));
    EXPECT_FALSE(io::inflate(deflated(bytes).substr(1), bytes.size()));
    EXPECT_FALSE(io::inflate("abc", std::size_t{1} << 40U));
}

std::string gifti_text(const std::string& points, const std::string& triangles,
                       const std::string& rest = "") {
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!DOCTYPE GIFTI SYSTEM "
           "\"http://www.nitrc.org/frs/download.php/115/gifti.dtd\">\n"
           "<GIFTI Version=\"1.0\" NumberOfDataArrays=\"2\"><DataArray Intent=\"NIFTI_INTENT_POINTSET\" "
           "DataType=\"NIFTI_TYPE_FLOAT32\" "
           "Dimensionality=\"2\" Dim0=\"4\" Dim1=\"3\" Endian=\"LittleEndian\" "
           "ArrayIndexingOrder=\"RowMajorOrder\" " +
           points +
           "</Data></DataArray>\n<DataArray Intent=\"NIFTI_INTENT_TRIANGLE\" DataType=\"NIFTI_TYPE_INT32\" "
           "Dimensionality=\"2\" Dim0=\"2\" "
           "Dim1=\"3\" Endian=\"LittleEndian\" " +
           triangles + "</Data></DataArray>" + rest + "</GIFTI>";
}

TEST(Gifti, TextBase64AndZlib) {
    const auto mesh = [](const std::string& text) {
        return surface_of(io::read_gifti(text, "a.gii")).content;
    };
    const std::string ascii = "Encoding=\"ASCII\"><Data>", base64 = "Encoding=\"Base64Binary\"><Data>",
                      zlib = "Encoding=\"GZipBase64Binary\"><Data>";
    const std::string labels =
        "<DataArray Intent=\"NIFTI_INTENT_LABEL\" DataType=\"NIFTI_TYPE_INT32\" Dimensionality=\"1\" "
        "Dim0=\"4\" " +
        ascii + "1 1 2 9</Data></DataArray>";
    const AttributedMesh text =
        mesh(gifti_text(ascii + "0 0 0 1 0 0 0 1 0 1 1 0", ascii + "0 1 2 2 1 3", labels));
    EXPECT_EQ(text.mesh.triangles, two_triangles);
    ASSERT_EQ(text.values.size(), 1U);
    EXPECT_EQ(text.values[0].name, "label");
    EXPECT_EQ(text.values[0].values(3, 0), 9);
    EXPECT_EQ(mesh(gifti_text(base64 + to_base64(points_4), base64 + to_base64(corners_6))).mesh.vertices,
              text.mesh.vertices);
    EXPECT_EQ(mesh(gifti_text(zlib + to_base64(deflated(points_4)), zlib + to_base64(deflated(corners_6))))
                  .mesh.triangles,
              two_triangles);
    std::string columns = gifti_text(ascii + "0 1 0 1  0 0 1 1  0 0 0 0", ascii + "0 1 2 2 1 3");
    columns.replace(columns.find("RowMajorOrder"), 13, "ColumnMajorOrder");
    EXPECT_EQ(mesh(columns).mesh.vertices, text.mesh.vertices);
    const auto refused = [](const std::string& bytes, const std::string& part) {
        test::expect_error<IoError>([&] { surface_of(io::read_gifti(bytes, "a.gii")); }, part);
    };
    refused(gifti_text(ascii + "0 0 0 1 0 0 0 1 0 1 1 0", ascii + "0 1 2 2 1 4"),
            "triangle 1 names vertex 4, but vertices run from 0 to 3");
    refused(gifti_text(ascii + "0 0 0 1 0 0 0 1 0 1 1", ascii + "0 1 2 2 1 3"),
            "an array has 11 numbers, not 4 x 3");
    refused(gifti_text(base64 + "AAAA", ascii + "0 1 2 2 1 3"), "does not hold 4 x 3 numbers");
    refused(gifti_text("Encoding=\"ExternalFileBinary\" ExternalFileName=\"/etc/passwd\"><Data>", ascii),
            "another file");
    refused("<GIFTI/>", "there are no points");
}

TEST(Vtk, ThroughFiles) {
    const test::TemporaryFolder folder;
    AttributedMesh content;
    content.mesh = make_icosphere(1);
    content.values.push_back({"height", content.mesh.vertices.col(2)});
    for (const char* name : {"a.vtk", "a.VTP"}) {
        write_attributed_mesh(content, folder / name);
        const AttributedMesh again = read_attributed_mesh(folder / name).content;
        EXPECT_EQ(again.mesh.vertices, content.mesh.vertices) << name;
        EXPECT_EQ(again.mesh.triangles, content.mesh.triangles) << name;
        EXPECT_EQ(again.values.at(0).values, content.values[0].values) << name;
        EXPECT_EQ(read_mesh(folder / name).mesh.triangles, content.mesh.triangles) << name;
        write_mesh(content.mesh, folder / name);
        EXPECT_EQ(read_mesh(folder / name).mesh.triangles, content.mesh.triangles) << name;
    }
}

}  // namespace
}  // namespace counterpart
