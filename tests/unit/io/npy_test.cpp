// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/expect_error.hpp"
#include "support/temporary_folder.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/io/map_file.hpp>
#include <counterpart/io/npy.hpp>

#include <gtest/gtest.h>

namespace counterpart::io {
namespace {

using test::TemporaryFolder;

std::string npy(const std::string& header, const std::string& data) {
    std::string bytes = "\x93NUMPY";
    bytes += {1, 0, static_cast<char>(header.size()), 0};
    return bytes + header + data;
}

Matrix read_npy_bytes(const std::string& bytes) {
    const TemporaryFolder folder;
    return read_npy(folder.file("a.npy", bytes));
}

TEST(Npy, MatricesAndVectorsRoundTrip) {
    const TemporaryFolder folder;
    const Matrix matrix{{1, 2.5, -3e300}, {0, 1e-310, 7}};
    write_npy(matrix, folder / "a.npy");
    EXPECT_EQ(read_npy(folder / "a.npy"), matrix);
    EXPECT_EQ(std::filesystem::file_size(folder / "a.npy"), 128U + 48U);

    const std::vector<Index> numbers = {3, -1, 2147483647};
    write_npy(numbers, folder / "b.npy");
    EXPECT_EQ(read_npy(folder / "b.npy"), (Matrix{{3}, {-1}, {2147483647}}));
    EXPECT_TRUE(read_npy_layout(folder / "b.npy").is_integer);
    EXPECT_EQ(read_npy_layout(folder / "b.npy").n_dimensions, 1);
    EXPECT_FALSE(read_npy_layout(folder / "a.npy").is_integer);
    EXPECT_EQ(read_npy_layout(folder / "a.npy").n_dimensions, 2);

    write_npy(Vector{{0.5, -2}}, folder / "d.npy");
    EXPECT_EQ(read_npy(folder / "d.npy"), (Matrix{{0.5}, {-2}}));
    EXPECT_EQ(std::filesystem::file_size(folder / "d.npy"), 128U + 16U);

    write_npy(Matrix(0, 3), folder / "c.npy");
    EXPECT_EQ(read_npy(folder / "c.npy").cols(), 3);
    const auto endless =
        npy("{'descr': '<f8', 'fortran_order': False, 'shape': (999999999999999999, 0), }", "");
    EXPECT_EQ(read_npy_bytes(endless).size(), 0);
}

TEST(Npy, ReadsTypesAndOrders) {
    const std::string one_two("\x01\0\0\0\x02\0\0\0", 8), big("\0\0\0\x01\0\0\0\x02", 8);
    EXPECT_EQ(read_npy_bytes(npy("{'descr': '<i4', 'fortran_order': False, 'shape': (2,), }", one_two)),
              (Matrix{{1}, {2}}));
    EXPECT_EQ(read_npy_bytes(npy("{'descr': '>i4', 'fortran_order': False, 'shape': (1, 2), }", big)),
              (Matrix{{1, 2}}));
    EXPECT_EQ(
        read_npy_bytes(npy("{'descr': '<i4', 'fortran_order': True, 'shape': (2, 2), }", one_two + one_two)),
        (Matrix{{1, 1}, {2, 2}}));
    EXPECT_EQ(read_npy_bytes(npy("{'descr': '<i8', 'fortran_order': False, 'shape': (1,), }", one_two)),
              (Matrix{{8589934593.0}}));
    EXPECT_EQ(
        read_npy_bytes(npy("{'descr': '<f4', 'fortran_order': False, 'shape': (1,), }", {"\0\0\x80\x3f", 4})),
        (Matrix{{1}}));
}

TEST(Npy, RefusesWhatItCannotRead) {
    const auto refused = [](const std::string& bytes, const std::string& part) {
        test::expect_error<IoError>([&] { read_npy_bytes(bytes); }, part);
    };
    const std::string good =
        npy("{'descr': '<f8', 'fortran_order': False, 'shape': (1,), }", std::string(8, 0));
    for (std::size_t size = 0; size < good.size(); ++size) refused(good.substr(0, size), "a.npy: ");
    refused("PK..............", "not a NumPy .npy file");
    refused(npy("{'descr': '<c8', 'fortran_order': False, 'shape': (1,), }", ""), "must be of type float32");
    refused(npy("{'descr': '|O', 'fortran_order': False, 'shape': (1,), }", ""), "must be of type float32");
    refused(npy("{'descr': '<f8', 'fortran_order': False, 'shape': (), }", std::string(8, 0)),
            "one or two dimensions, not 0");
    refused(npy("{'descr': '<f8', 'fortran_order': False, 'shape': (1, 1, 1), }", std::string(8, 0)),
            "one or two dimensions, not 3");
    refused(npy("{'descr': '<f8', 'fortran_order': False, 'shape': (4294967296, 4294967296), }", ""),
            "out of range");
    for (const char* shape :
         {"(0, 18446744073709551615)", "(18446744073709551615, 0)", "(9223372036854775808, 0)"})
        refused(npy(std::string("{'descr': '<f8', 'fortran_order': False, 'shape': ") + shape + ", }", ""),
                "out of range");
    EXPECT_EQ(read_npy_bytes(npy("{'descr': '<f8', 'fortran_order': False, 'shape': (0, 7), }", "")).cols(),
              7);
    refused(npy("{'descr': '<f8', 'fortran_order': False, 'shape': (x,), }", ""), "no shape");
    refused(npy("{'descr': '<f8', 'fortran_order': False}", ""), "has no 'shape'");
}

TEST(Npy, IndicesMustBeWholeNumbersThatFit) {
    const TemporaryFolder folder;
    write_npy(Matrix{{1}}, folder / "a.npy");
    test::expect_error<IoError>([&] { read_vertex_map(folder / "a.npy"); }, "int32 or int64");
    const auto wide = folder.file("b.npy", npy("{'descr': '<i8', 'fortran_order': False, 'shape': (1,), }",
                                               std::string("\0\0\0\0\x01\0\0\0", 8)));
    test::expect_error<IoError>([&] { read_vertex_map(wide); }, "entry 0 is out of range: 4294967296");
}

}  // namespace
}  // namespace counterpart::io
