// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "io/byte_order.hpp"
#include "io/npy_bytes.hpp"
#include "platform/files.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/io/file.hpp>
#include <counterpart/io/npy.hpp>

#include <charconv>
#include <limits>
#include <string_view>

#include <fmt/format.h>

namespace counterpart {

using namespace io;

namespace {

constexpr std::string_view magic = "\x93NUMPY";

// An array as stored: the type, one or two dimensions, the numbers' bytes.
struct Array {
    char kind = 'f';  // 'f' or 'i'
    std::size_t width = 8;
    std::endian order = std::endian::little;
    bool column_major = false;
    std::vector<std::size_t> shape;
    std::string_view data;

    std::size_t rows() const { return shape[0]; }
    std::size_t columns() const { return shape.size() == 2 ? shape[1] : 1; }
    const char* at(std::size_t i, std::size_t j) const {
        return data.data() + width * (column_major ? j * rows() + i : i * columns() + j);
    }
};

[[noreturn]] void refuse_array(const std::filesystem::path& file, std::string_view reason) {
    throw IoError(fmt::format("{}: {}", platform::utf8_name(file), reason));
}

// The text behind "'key':" in the header, which is a Python dictionary.
std::string_view entry(std::string_view header, std::string_view key, const std::filesystem::path& file) {
    const std::size_t at = header.find(fmt::format("'{}':", key));
    if (at == header.npos) refuse_array(file, fmt::format("the .npy header has no '{}'", key));
    const std::string_view rest = header.substr(at + key.size() + 3);
    return rest.substr(std::min(rest.find_first_not_of(' '), rest.size()));
}

void parse_type(std::string_view descr, Array& array, const std::filesystem::path& file) {
    const std::string_view type = descr.substr(0, 5);  // quote, byte order, kind, width, quote
    if (type.size() < 5 || (type[1] != '<' && type[1] != '>') || (type[2] != 'f' && type[2] != 'i') ||
        (type[3] != '4' && type[3] != '8') || type[4] != type[0])
        refuse_array(file, "the array must be of type float32, float64, int32 or int64");
    array.order = type[1] == '<' ? std::endian::little : std::endian::big;
    array.kind = type[2];
    array.width = type[3] == '4' ? 4 : 8;
}

// "(3, 4)" or "(3,)". The product is checked against the bytes that are there.
void parse_shape(std::string_view text, Array& array, const std::filesystem::path& file) {
    const std::size_t close = text.find(')');
    if (close == text.npos || text.front() != '(') refuse_array(file, "the .npy header has no shape");
    text = text.substr(1, close - 1);
    std::size_t count = 1;
    for (std::size_t at = 0; (at = text.find_first_not_of(" ,", at)) < text.size();) {
        std::size_t extent = 0;
        const auto [stop, error] = std::from_chars(text.data() + at, text.data() + text.size(), extent);
        if (error != std::errc()) refuse_array(file, "the .npy header has no shape");
        at = static_cast<std::size_t>(stop - text.data());
        array.shape.push_back(extent);
        // An extent of zero may come with any other, within what a matrix can count.
        if (extent > static_cast<std::size_t>(std::numeric_limits<Eigen::Index>::max()))
            refuse_array(file, "the array's shape is out of range");
        if (extent > 0 && count > std::numeric_limits<std::size_t>::max() / extent / array.width)
            refuse_array(file, "the array's shape is out of range");
        count *= extent;
    }
    if (array.shape.empty() || array.shape.size() > 2)
        refuse_array(file,
                     fmt::format("the array must have one or two dimensions, not {}", array.shape.size()));
    if (array.data.size() != count * array.width) {
        refuse_array(
            file,
            fmt::format("the header says {} numbers of {} bytes, but {} bytes follow: the file is damaged",
                        count, array.width, array.data.size()));
    }
}

// `bytes` must outlive the array.
Array parse(std::string_view bytes, const std::filesystem::path& file) {
    if (bytes.size() < 12 || !bytes.starts_with(magic)) refuse_array(file, "not a NumPy .npy file");
    const char major = bytes[magic.size()];
    if (major < 1 || major > 3) refuse_array(file, "unknown version of the .npy format");
    const std::size_t start = major == 1 ? 10 : 12;
    const std::size_t length = major == 1 ? load_number<std::uint16_t>(bytes.data() + 8)
                                          : load_number<std::uint32_t>(bytes.data() + 8);
    if (length > bytes.size() - start) refuse_array(file, "the file ends within its header");
    const std::string_view header = bytes.substr(start, length);
    Array array;
    array.data = bytes.substr(start + length);
    parse_type(entry(header, "descr", file), array, file);
    array.column_major = entry(header, "fortran_order", file).starts_with("True");
    parse_shape(entry(header, "shape", file), array, file);
    return array;
}

double load_real(const Array& array, const char* at) {
    if (array.kind == 'f')
        return array.width == 4 ? load_number<float>(at, array.order) : load_number<double>(at, array.order);
    return array.width == 4 ? load_number<std::int32_t>(at, array.order)
                            : static_cast<double>(load_number<std::int64_t>(at, array.order));
}

// Everything before the numbers; the format wants it padded to a multiple of 64 bytes.
std::string file_start(std::string_view descr, const std::string& shape) {
    std::string header =
        fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': ({}), }}", descr, shape);
    header.append(63 - (10 + header.size()) % 64, ' ');
    header += '\n';
    std::string bytes(magic);
    bytes += {1, 0};
    append_number(bytes, static_cast<std::uint16_t>(header.size()));
    return bytes + header;
}

}  // namespace

std::string io::npy_bytes(const Matrix& matrix) {
    std::string bytes = file_start("<f8", fmt::format("{}, {}", matrix.rows(), matrix.cols()));
    bytes.reserve(bytes.size() + static_cast<std::size_t>(matrix.size()) * sizeof(double));
    for (Eigen::Index i = 0; i < matrix.size(); ++i) append_number(bytes, matrix.data()[i]);
    return bytes;
}

void write_npy(const Matrix& matrix, const std::filesystem::path& file) {
    write_file(npy_bytes(matrix), file);
}

Matrix io::parse_npy(std::string_view bytes, const std::filesystem::path& file) {
    const Array array = parse(bytes, file);
    Matrix matrix(static_cast<Eigen::Index>(array.rows()), static_cast<Eigen::Index>(array.columns()));
    if (matrix.size() == 0) return matrix;  // an extent of zero may come with any other
    for (std::size_t i = 0; i < array.rows(); ++i) {
        for (std::size_t j = 0; j < array.columns(); ++j)
            matrix(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
                load_real(array, array.at(i, j));
    }
    return matrix;
}

std::string io::npy_bytes(const Vector& vector) {
    std::string bytes = file_start("<f8", fmt::format("{},", vector.size()));
    for (const double number : vector) append_number(bytes, number);
    return bytes;
}

void write_npy(const Vector& vector, const std::filesystem::path& file) {
    write_file(npy_bytes(vector), file);
}

std::string io::npy_bytes(std::span<const Index> numbers) {
    std::string bytes = file_start("<i4", fmt::format("{},", numbers.size()));
    for (const Index number : numbers) append_number(bytes, number);
    return bytes;
}

void write_npy(std::span<const Index> numbers, const std::filesystem::path& file) {
    write_file(npy_bytes(numbers), file);
}

NpyLayout read_npy_layout(const std::filesystem::path& file) {
    const std::string bytes = read_whole_file(file);
    const Array array = parse(bytes, file);
    return {array.kind == 'i', static_cast<int>(array.shape.size())};
}

Matrix read_npy(const std::filesystem::path& file) { return parse_npy(read_whole_file(file), file); }

std::vector<Index> io::parse_npy_indices(std::string_view bytes, const std::filesystem::path& file) {
    const Array array = parse(bytes, file);
    if (array.kind != 'i' || array.shape.size() != 1)
        refuse_array(file, "the array must be one-dimensional, of type int32 or int64");
    std::vector<Index> numbers(array.rows());
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const char* at = array.at(i, 0);
        const std::int64_t number = array.width == 4 ? load_number<std::int32_t>(at, array.order)
                                                     : load_number<std::int64_t>(at, array.order);
        if (number != static_cast<Index>(number))
            refuse_array(file, fmt::format("entry {} is out of range: {}", i, number));
        numbers[i] = static_cast<Index>(number);
    }
    return numbers;
}

}  // namespace counterpart
