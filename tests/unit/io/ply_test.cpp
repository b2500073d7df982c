// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "io/formats.hpp"
#include "support/expect_error.hpp"
#include "support/temporary_folder.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/io/mesh_file.hpp>

#include <algorithm>
#include <array>
#include <bit>

#include <gtest/gtest.h>

namespace counterpart::io {
namespace {

MeshFile read_ply_bytes(std::string_view bytes) {
    const test::TemporaryFolder folder;
    return read_mesh(folder.file("a.ply", bytes));
}

void expect_ply_refused(std::string_view bytes, const std::string& part) {
    test::expect_error<IoError>([&] { read_ply_bytes(bytes); }, part);
}

std::string header(const std::string& format, const std::string& elements) {
    return "ply\nformat " + format + " 1.0\ncomment made by a test\n" + elements + "end_header\n";
}

const std::string plain_ply =
    "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 1\nproperty list uchar int vertex_indices\n";
const std::string three_vertices = "0 0 0\n1 0 0\n0 1 0\n";

void expect_one_triangle(const MeshFile& file) {
    EXPECT_EQ(file.mesh.vertices, (Points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    EXPECT_EQ(file.mesh.triangles, (Triangles{{0, 1, 2}}));
}

TEST(Ply, ReadsTextWithOtherElementsAndProperties) {
    expect_one_triangle(read_ply_bytes(header("ascii", plain_ply) + three_vertices + "3 0 1 2\n"));
    expect_one_triangle(read_ply_bytes(
        header("ascii",
               "element camera 2\nproperty float f\nproperty list uchar float distortion\n"
               "element vertex 3\nproperty double z\nproperty list uchar int tags\nproperty double x\n"
               "property uchar red\nproperty double y\nelement nothing 5\n"
               "element face 1\nproperty uchar flag\nproperty list int uint vertex_index\n"
               "property list uchar float texcoord\n") +
        "1.5 2 1 2\n1.5 0\n0 0 0 255 0\n0 3 1 2 3 1 255 0\n0 1 7 0 255 1\n\n1 3 0 1 2 6 0 0 1 0 0 1\n"));
}

TEST(Ply, AcceptsCarriageReturns) {
    std::string text = header("ascii", plain_ply) + three_vertices + "3 0 1 2\n";
    for (std::size_t at = 0; (at = text.find('\n', at)) != text.npos; at += 2) text.replace(at, 1, "\r\n");
    expect_one_triangle(read_ply_bytes(text));
}

// Appends values of any type in either byte order.
template <class Number>
void put(std::string& bytes, Number value, bool big) {
    auto raw = std::bit_cast<std::array<char, sizeof(Number)>>(value);
    if (big == (std::endian::native == std::endian::little)) std::reverse(raw.begin(), raw.end());
    bytes.append(raw.data(), raw.size());
}

template <class Coordinate, class Length, class Corner>
std::string binary(bool big, const char* coordinate, const char* length, const char* corner) {
    std::string bytes = header(big ? "binary_big_endian" : "binary_little_endian",
                               std::string("element vertex 3\nproperty short skipped\nproperty ") +
                                   coordinate + " x\nproperty " + coordinate + " y\nproperty " + coordinate +
                                   " z\nelement face 1\nproperty list uchar double weights\nproperty list " +
                                   length + " " + corner + " vertex_indices\n");
    for (const std::array<int, 3> p : {std::array{0, 0, 0}, std::array{1, 0, 0}, std::array{0, 1, 0}}) {
        put(bytes, std::int16_t{-5}, big);
        for (const int x : p) put(bytes, static_cast<Coordinate>(x), big);
    }
    put(bytes, std::uint8_t{1}, big);
    put(bytes, 0.25, big);
    put(bytes, Length{3}, big);
    for (const int v : {0, 1, 2}) put(bytes, static_cast<Corner>(v), big);
    return bytes;
}

TEST(Ply, ReadsBinaryOfEveryTypeInBothByteOrders) {
    for (const bool big : {false, true}) {
        SCOPED_TRACE(big);
        expect_one_triangle(
            read_ply_bytes(binary<float, std::uint8_t, std::int32_t>(big, "float", "uchar", "int")));
        expect_one_triangle(
            read_ply_bytes(binary<double, std::uint32_t, std::uint16_t>(big, "double", "uint", "ushort")));
        expect_one_triangle(
            read_ply_bytes(binary<std::int8_t, std::int8_t, std::uint8_t>(big, "char", "int8", "uint8")));
        expect_one_triangle(
            read_ply_bytes(binary<std::int16_t, std::int16_t, std::int16_t>(big, "int16", "short", "int16")));
        expect_one_triangle(read_ply_bytes(
            binary<std::uint32_t, std::uint16_t, std::uint32_t>(big, "uint32", "uint16", "uint32")));
    }
}

TEST(Ply, BinaryErrorsNameTheElement) {
    const std::string good = binary<float, std::uint8_t, std::int32_t>(false, "float", "uchar", "int");
    expect_ply_refused(std::string_view(good).substr(0, good.size() - 1),
                       "a.ply: face 0: the file ends here");
    std::string bad = good;
    bad[bad.size() - 4] = 3;
    expect_ply_refused(bad, "a.ply: face 0: the face names vertex 3, but vertices run from 0 to 2");
    bad = good;
    bad[bad.size() - 13] = 2;
    expect_ply_refused(bad, "a.ply: face 0: a face needs at least 3 corners, this one has 2");
    const std::string lists = binary<double, std::int32_t, std::int32_t>(false, "double", "int", "int");
    bad = lists;
    bad[bad.size() - 13] = '\x80';  // sign bit of the length
    expect_ply_refused(bad, "the list 'vertex_indices' has length -2147483645");
}

TEST(Ply, HeaderErrorsNameLineAndReason) {
    expect_ply_refused("", "a.ply:1: not a PLY file");
    expect_ply_refused("solid\n", "a.ply:1: not a PLY file");
    expect_ply_refused("ply\nformat ascii 1.0\n", "the file ends within its header");
    expect_ply_refused("ply\nend_header\n", "a.ply:2: the header has no 'format' line");
    expect_ply_refused("ply\nformat binary 1.0\n", "a.ply:2: unknown format 'binary'");
    expect_ply_refused("ply\nformat ascii 1.0\nproperty float x\n",
                       "a.ply:3: a property stands before the first");
    expect_ply_refused("ply\nformat ascii 1.0\nelement vertex -1\n",
                       "a.ply:3: the number of 'vertex' is out of range");
    expect_ply_refused("ply\nformat ascii 1.0\nelement vertex 3\nproperty quad x\n",
                       "a.ply:4: unknown property type");
    expect_ply_refused("ply\nformat ascii 1.0\nelement vertex 3\nproperty float\n",
                       "a.ply:4: the property has no name");
    expect_ply_refused("ply\nformat ascii 1.0\nelement face 3\nproperty list float int vertex_indices\n",
                       "a.ply:4: the length of a list must be a whole number");
    expect_ply_refused("ply\nfromat ascii 1.0\n", "a.ply:2: a PLY header has lines");
    expect_ply_refused(header("ascii", "element face 0\n"), "a.ply: the header has no element 'vertex'");
    expect_ply_refused(header("ascii", "element vertex 1\nproperty float x\nproperty float y\n"),
                       "element 'vertex' needs one property 'z', it has 0");
    expect_ply_refused(header("ascii", plain_ply + plain_ply), "two elements 'vertex'");
    expect_ply_refused(header("ascii",
                              "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
                              "element face 1\nproperty list uchar float vertex_indices\n"),
                       "'vertex_indices' must be whole numbers");
    expect_ply_refused(header("ascii", plain_ply + "property list uchar float vertex_index\n") +
                           three_vertices + "3 0 1 2 3 0 1 nan\n",
                       "element 'face' has several lists of vertices");
    // Each face takes a length and three corners.
    const std::string vertices = plain_ply.substr(0, plain_ply.find("element face"));
    expect_ply_refused(header("binary_little_endian",
                              vertices + "element face 9\nproperty list uchar int vertex_indices\n") +
                           std::string(36 + 9 * 12, '\3'),
                       "9 elements 'face', more than the file has room for");
    expect_ply_refused(header("ascii",
                              "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
                              "element face 1\nproperty list uchar int corners\n"),
                       "element 'face' has no list 'vertex_indices'");
    expect_ply_refused(
        header("binary_little_endian",
               "element vertex 2000000000\nproperty float x\nproperty float y\nproperty float z\n"),
        "the header says 2000000000 elements 'vertex', more than the file has room for");
}

TEST(Ply, TextErrorsNameLineAndReason) {
    const std::string start = header("ascii", plain_ply);  // ten lines
    expect_ply_refused(start + "0 0 0\n1 0\n0 1 0\n3 0 1 2\n",
                       "a.ply:12: expected a number (z), but the line ends");
    expect_ply_refused(start + three_vertices + "3 0 1 3\n", "a.ply:14: the face names vertex 3");
    expect_ply_refused(start + three_vertices + "2 0 1\n", "a.ply:14: a face needs at least 3 corners");
    expect_ply_refused(start + three_vertices + "-3 0 1 2\n",
                       "a.ply:14: the list 'vertex_indices' has length -3");
    expect_ply_refused(start + three_vertices + "3 0 1\n",
                       "a.ply:14: expected a whole number (vertex_indices)");
    expect_ply_refused(start + three_vertices, "more than the file has room for");
    expect_ply_refused(start + three_vertices + "   \n", "the file ends after 0 of 1 elements 'face'");
}

TEST(Ply, LeavesBinaryVerticesOutThatAreNotFinite) {
    std::string bytes = header("binary_little_endian", plain_ply);
    for (int i = 0; i < 9; ++i)
        put(bytes, i == 4 ? std::numeric_limits<float>::quiet_NaN() : float(i), false);
    put(bytes, std::uint8_t{3}, false);
    for (const std::int32_t v : {0, 1, 2}) put(bytes, v, false);
    EXPECT_EQ(io::read_ply(bytes, "a.ply").mesh.left_out, (std::vector<Index>{1}));
}

}  // namespace
}  // namespace counterpart::io
