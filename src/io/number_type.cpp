// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "io/number_type.hpp"

#include "io/byte_order.hpp"

#include <array>
#include <cstdint>
#include <utility>

namespace counterpart::io {
namespace {

template <class Number>
std::vector<double> load_all(std::string_view bytes, std::endian order) {
    std::vector<double> numbers(bytes.size() / sizeof(Number));
    for (std::size_t i = 0; i < numbers.size(); ++i)
        numbers[i] = static_cast<double>(load_number<Number>(bytes.data() + i * sizeof(Number), order));
    return numbers;
}

using Name = std::pair<std::string_view, NumberType>;

template <std::size_t n>
std::optional<NumberType> find(const std::array<Name, n>& names, std::string_view name) {
    for (const Name& known : names)
        if (known.first == name) return known.second;
    return std::nullopt;
}

}  // namespace

std::size_t size_of(NumberType type) {
    constexpr std::array<std::size_t, 10> sizes = {1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
    return sizes[static_cast<std::size_t>(type)];
}

std::vector<double> numbers_of(std::string_view bytes, NumberType type, std::endian order) {
    switch (type) {
        case NumberType::int8:
            return load_all<std::int8_t>(bytes, order);
        case NumberType::uint8:
            return load_all<std::uint8_t>(bytes, order);
        case NumberType::int16:
            return load_all<std::int16_t>(bytes, order);
        case NumberType::uint16:
            return load_all<std::uint16_t>(bytes, order);
        case NumberType::int32:
            return load_all<std::int32_t>(bytes, order);
        case NumberType::uint32:
            return load_all<std::uint32_t>(bytes, order);
        case NumberType::int64:
            return load_all<std::int64_t>(bytes, order);
        case NumberType::uint64:
            return load_all<std::uint64_t>(bytes, order);
        case NumberType::float32:
            return load_all<float>(bytes, order);
        case NumberType::float64:
            return load_all<double>(bytes, order);
    }
    return {};
}

std::optional<NumberType> legacy_vtk_type(std::string_view name) {
    static constexpr std::array<Name, 15> names = {{{"char", NumberType::int8},
                                                    {"signed_char", NumberType::int8},
                                                    {"unsigned_char", NumberType::uint8},
                                                    {"short", NumberType::int16},
                                                    {"unsigned_short", NumberType::uint16},
                                                    {"int", NumberType::int32},
                                                    {"vtkidtype", NumberType::int32},  // as VTK writes it
                                                    {"unsigned_int", NumberType::uint32},
                                                    {"long", NumberType::int64},
                                                    {"unsigned_long", NumberType::uint64},
                                                    {"vtktypeint64", NumberType::int64},
                                                    {"vtktypeuint64", NumberType::uint64},
                                                    {"float", NumberType::float32},
                                                    {"double", NumberType::float64},
                                                    {"vtktypeint32", NumberType::int32}}};
    return find(names, name);
}

std::optional<NumberType> xml_vtk_type(std::string_view name) {
    static constexpr std::array<Name, 10> names = {{{"Int8", NumberType::int8},
                                                    {"UInt8", NumberType::uint8},
                                                    {"Int16", NumberType::int16},
                                                    {"UInt16", NumberType::uint16},
                                                    {"Int32", NumberType::int32},
                                                    {"UInt32", NumberType::uint32},
                                                    {"Int64", NumberType::int64},
                                                    {"UInt64", NumberType::uint64},
                                                    {"Float32", NumberType::float32},
                                                    {"Float64", NumberType::float64}}};
    return find(names, name);
}

}  // namespace counterpart::io
