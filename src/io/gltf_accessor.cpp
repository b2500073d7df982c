// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "io/byte_order.hpp"
#include "io/gltf_document.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <utility>

#include <fmt/format.h>

namespace counterpart::io {
namespace {

constexpr std::array<std::pair<std::string_view, int>, 5> widths = {
    {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT4", 16}}};

std::optional<std::size_t> size_of_component(std::int64_t type) {
    switch (type) {
        case 5120:
        case 5121:
            return 1;
        case 5122:
        case 5123:
            return 2;
        case 5125:
        case 5126:
            return 4;
        default:
            return {};
    }
}

template <class Integer>
double integer_at(const char* bytes, bool normalized) {
    const auto value = static_cast<double>(load_number<Integer>(bytes));
    return normalized ? std::max(value / static_cast<double>(std::numeric_limits<Integer>::max()), -1.0)
                      : value;
}

double component_at(const char* bytes, std::int64_t type, bool normalized) {
    switch (type) {
        case 5120:
            return integer_at<std::int8_t>(bytes, normalized);
        case 5121:
            return integer_at<std::uint8_t>(bytes, normalized);
        case 5122:
            return integer_at<std::int16_t>(bytes, normalized);
        case 5123:
            return integer_at<std::uint16_t>(bytes, normalized);
        case 5125:
            return integer_at<std::uint32_t>(bytes, normalized);
        default:
            return static_cast<double>(load_number<float>(bytes));
    }
}

// Rows of numbers in a buffer view, checked against the bytes that are there.
struct Rows {
    const char* data = nullptr;
    std::size_t stride = 0, component = 0;
    std::int64_t type = 0;
    bool normalized = false;

    double at(std::size_t row, int column) const {
        return component_at(data + row * stride + static_cast<std::size_t>(column) * component, type,
                            normalized);
    }
};

Rows rows_in_view(const GltfDocument& document, const GltfJson& place, std::int64_t type, int width,
                  std::int64_t n_rows, const std::string& what) {
    const std::optional<std::size_t> component = size_of_component(type);
    if (!component) document.fail(fmt::format("{} has the unknown componentType {}", what, type));
    const GltfJson& view = document.element("bufferViews", number_at(document, place, "bufferView", -1));
    const std::int64_t buffer = number_at(document, view, "buffer", -1);
    if (buffer < 0 || buffer >= static_cast<std::int64_t>(document.buffers.size()))
        document.fail(fmt::format("{}: there is no buffer {}", what, buffer));
    const std::string& bytes = document.buffers[static_cast<std::size_t>(buffer)];
    const auto row_size = static_cast<std::int64_t>(*component) * width;
    const std::int64_t stride = std::max<std::int64_t>(number_at(document, view, "byteStride", 0), 0);
    const std::int64_t step = stride > 0 ? stride : row_size;
    const std::int64_t view_start = number_at(document, view, "byteOffset", 0);
    const std::int64_t view_size = number_at(document, view, "byteLength", 0);
    const std::int64_t start = number_at(document, place, "byteOffset", 0);
    const auto available = static_cast<std::int64_t>(bytes.size());
    const bool view_fits = view_start <= available && view_size <= available - view_start;
    const bool rows_fit = n_rows == 0 || (step >= row_size && start + row_size <= view_size &&
                                          (n_rows - 1) <= (view_size - start - row_size) / step);
    if (!view_fits || !rows_fit)
        document.fail(
            fmt::format("{}: {} rows do not fit into its buffer view; the file is damaged", what, n_rows));
    return {bytes.data() + view_start + start, static_cast<std::size_t>(step), *component, type, false};
}

void put_in_sparse(const GltfDocument& document, const GltfJson& sparse, std::int64_t type, bool normalized,
                   Matrix& values, const std::string& what) {
    const std::int64_t count = number_at(document, sparse, "count", 0);
    const GltfJson& where = sparse.at("indices");
    const Rows rows =
        rows_in_view(document, where, number_at(document, where, "componentType", 0), 1, count, what);
    Rows items =
        rows_in_view(document, sparse.at("values"), type, static_cast<int>(values.cols()), count, what);
    items.normalized = normalized;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
        const double row = rows.at(i, 0);
        if (!(row >= 0 && row < static_cast<double>(values.rows())))
            document.fail(fmt::format("{}: the sparse entry {} is out of range", what, row));
        for (int c = 0; c < values.cols(); ++c) values(static_cast<Eigen::Index>(row), c) = items.at(i, c);
    }
}

}  // namespace

Matrix read_accessor(const GltfDocument& document, std::int64_t index, std::string_view types,
                     GltfBudget& budget) {
    const GltfJson& accessor = document.element("accessors", index);
    const std::string what = fmt::format("accessor {}", index);
    const std::string type = accessor.value("type", "");
    const auto* width =
        std::find_if(widths.begin(), widths.end(), [&](const auto& w) { return w.first == type; });
    if (width == widths.end() || types.find(type) == types.npos)
        document.fail(fmt::format("{} is of type '{}' where {} is needed", what, type, types));
    const std::int64_t count = number_at(document, accessor, "count", 0);
    budget.take(count, width->second);
    const std::int64_t component = number_at(document, accessor, "componentType", 0);
    const bool normalized = accessor.value("normalized", false);
    Matrix values;
    if (accessor.contains("bufferView")) {
        Rows rows = rows_in_view(document, accessor, component, width->second, count, what);
        rows.normalized = normalized;
        values.resize(static_cast<Eigen::Index>(count), width->second);
        for (Eigen::Index i = 0; i < values.rows(); ++i)
            for (int c = 0; c < width->second; ++c) values(i, c) = rows.at(static_cast<std::size_t>(i), c);
    } else {
        if (!accessor.contains("sparse")) document.fail(fmt::format("{} has no data", what));
        values = Matrix::Zero(static_cast<Eigen::Index>(count), width->second);
    }
    if (accessor.contains("sparse"))
        put_in_sparse(document, accessor["sparse"], component, normalized, values, what);
    return values;
}

std::string view_bytes(const GltfDocument& document, std::int64_t view_number) {
    const GltfJson& view = document.element("bufferViews", view_number);
    const auto buffer = static_cast<std::size_t>(number_at(document, view, "buffer", 0));
    const auto start = static_cast<std::size_t>(number_at(document, view, "byteOffset", 0));
    const auto length = static_cast<std::size_t>(number_at(document, view, "byteLength", 0));
    if (buffer >= document.buffers.size() || start > document.buffers[buffer].size() ||
        length > document.buffers[buffer].size() - start)
        document.fail(fmt::format("buffer view {} reaches beyond its buffer", view_number));
    return document.buffers[buffer].substr(start, length);
}

}  // namespace counterpart::io
