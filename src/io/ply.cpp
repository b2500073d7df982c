// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// PLY (Turk 1994), text and binary: coordinates from the element `vertex`, corners from the element `face`;
// further columns of both that are asked for; all else is passed over.
#include "io/byte_order.hpp"
#include "io/faces.hpp"
#include "io/formats.hpp"
#include "io/mesh_collector.hpp"
#include "io/ply_columns.hpp"
#include "io/ply_header.hpp"

#include <counterpart/base/errors.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <limits>

#include <fmt/format.h>

namespace counterpart::io {
namespace {

// The values of a text body. Each element has a line of its own.
class TextValues {
  public:
    explicit TextValues(TextCursor& text) : text_(text) {}

    void begin(const PlyElement& element, std::int64_t i) {
        if (!text_.next_content())
            text_.fail(
                fmt::format("the file ends after {} of {} elements '{}'", i, element.count, element.name));
    }
    void end() {
        n_surplus_ += text_.at_line_end() ? 0 : 1;
        text_.next_line();
    }
    double number(const PlyProperty& property) { return text_.number(property.name); }
    std::int64_t integer(PlyType, const PlyProperty& property) { return text_.integer(property.name); }
    void skip(PlyType, const PlyProperty& property) { text_.number(property.name); }

    std::size_t remaining() const { return text_.remaining(); }
    static std::size_t least_size(PlyType) { return 1; }
    [[noreturn]] void fail(std::string_view reason) const { text_.fail(reason); }
    /// Lines with more values than the header says.
    std::int64_t n_surplus() const { return n_surplus_; }

  private:
    TextCursor& text_;
    std::int64_t n_surplus_ = 0;
};

// The values of a binary body.
class BinaryValues {
  public:
    BinaryValues(std::string_view bytes, std::endian order, std::string name)
        : at_(bytes.data()), end_(at_ + bytes.size()), order_(order), name_(std::move(name)) {}

    void begin(const PlyElement& element, std::int64_t i) {
        element_ = &element;
        i_ = i;
    }
    void end() {}
    double number(const PlyProperty& property) { return value<double>(property.type); }
    std::int64_t integer(PlyType type, const PlyProperty&) { return value<std::int64_t>(type); }
    void skip(PlyType type, const PlyProperty&) { take(size_of(type)); }

    std::size_t remaining() const { return static_cast<std::size_t>(end_ - at_); }
    static std::size_t least_size(PlyType type) { return size_of(type); }
    [[noreturn]] void fail(std::string_view reason) const {
        throw IoError(fmt::format("{}: {} {}: {}", name_, element_->name, i_, reason));
    }
    static std::int64_t n_surplus() { return 0; }  // nothing parts one element from the next

  private:
    const char* take(std::size_t size) {
        if (remaining() < size) fail(fmt::format("the file ends here, of {} elements", element_->count));
        at_ += size;
        return at_ - size;
    }
    template <class Number>
    Number load() {
        return load_number<Number>(take(sizeof(Number)), order_);
    }
    template <class Number>
    Number value(PlyType type) {
        switch (type) {
            case PlyType::int8:
                return static_cast<Number>(load<std::int8_t>());
            case PlyType::uint8:
                return static_cast<Number>(load<std::uint8_t>());
            case PlyType::int16:
                return static_cast<Number>(load<std::int16_t>());
            case PlyType::uint16:
                return static_cast<Number>(load<std::uint16_t>());
            case PlyType::int32:
                return static_cast<Number>(load<std::int32_t>());
            case PlyType::uint32:
                return static_cast<Number>(load<std::uint32_t>());
            case PlyType::float32:
                return static_cast<Number>(load<float>());
            case PlyType::float64:
                return static_cast<Number>(load<double>());
        }
        return 0;
    }

    const char* at_;
    const char* end_;
    std::endian order_;
    std::string name_;
    const PlyElement* element_ = nullptr;
    std::int64_t i_ = 0;
};

bool holds_corners(const PlyProperty& property) {
    return property.is_list && (property.name == "vertex_indices" || property.name == "vertex_index");
}

// Refuses counts that the rest of the file cannot hold, before memory is set aside for them.
template <class Values>
void require_room(const Values& values, const PlyElement& element, const std::string& name) {
    std::size_t size = 0;
    for (const PlyProperty& property : element.properties) {
        size += Values::least_size(property.is_list ? property.count_type : property.type);
        if (element.name == "face" && holds_corners(property)) size += 3 * Values::least_size(property.type);
    }
    if (size > 0 && static_cast<std::size_t>(element.count) > values.remaining() / size) {
        throw IoError(fmt::format("{}: the header says {} elements '{}', more than the file has room for",
                                  name, element.count, element.name));
    }
}

template <class Values>
std::int64_t read_length(Values& values, const PlyProperty& property) {
    const std::int64_t length = values.integer(property.count_type, property);
    if (length < 0) values.fail(fmt::format("the list '{}' has length {}", property.name, length));
    return length;
}

template <class Values>
void skip(Values& values, const PlyProperty& property) {
    const std::int64_t count = property.is_list ? read_length(values, property) : 1;
    for (std::int64_t i = 0; i < count; ++i) values.skip(property.type, property);
}

template <class Values>
std::vector<double> read_vertices(Values& values, const PlyElement& element, const PlyWanted& wanted,
                                  MeshCollector& mesh) {
    static constexpr std::string_view axes = "xyz";
    const auto is_axis = [](const PlyProperty& p) {
        return !p.is_list && p.name.size() == 1 && axes.find(p.name) != axes.npos;
    };
    std::array<double, 3> point = {};
    std::vector<double> columns;
    for (std::int64_t v = 0; v < element.count; ++v) {
        values.begin(element, v);
        for (const PlyProperty& property : element.properties) {
            if (is_axis(property)) {
                point[axes.find(property.name)] = values.number(property);
            } else if (wanted.of_vertices && !property.is_list) {
                columns.push_back(values.number(property));
            } else {
                skip(values, property);
            }
        }
        values.end();
        mesh.add_vertex(point[0], point[1], point[2]);
    }
    return columns;
}

// Texture coordinates of a face's corners; none where there is another number of them.
void add_coordinates(const std::vector<double>& list, std::size_t n_corners, std::vector<double>& all) {
    if (list.size() == 2 * n_corners)
        all.insert(all.end(), list.begin(), list.end());
    else
        all.insert(all.end(), 2 * n_corners, std::numeric_limits<double>::quiet_NaN());
}

template <class Values>
std::vector<double> read_faces(Values& values, const PlyElement& element, std::int64_t n_vertices,
                               const PlyWanted& wanted, MeshCollector& mesh) {
    std::vector<Index> corners;
    std::vector<double> list, all;
    for (std::int64_t f = 0; f < element.count; ++f) {
        values.begin(element, f);
        list.clear();
        for (const PlyProperty& property : element.properties) {
            if (wanted.of_corners && property.is_list && property.name == "texcoord") {
                const std::int64_t size = read_length(values, property);
                for (std::int64_t i = 0; i < size; ++i) list.push_back(values.number(property));
                continue;
            }
            if (!holds_corners(property)) {
                skip(values, property);
                continue;
            }
            const std::int64_t size = read_length(values, property);
            if (size < 3) values.fail(fmt::format("a face needs at least 3 corners, this one has {}", size));
            corners.clear();
            for (std::int64_t i = 0; i < size; ++i) {
                const std::int64_t v = values.integer(property.type, property);
                if (v < 0 || v >= n_vertices) {
                    values.fail(fmt::format("the face names vertex {}, but vertices run from 0 to {}", v,
                                            n_vertices - 1));
                }
                corners.push_back(static_cast<Index>(v));
            }
            mesh.add_face(corners);
        }
        values.end();
        if (wanted.of_corners) add_coordinates(list, corners.size(), all);
    }
    return all;
}

template <class Values>
PlyColumns read_body(Values values, const PlyHeader& header, std::int64_t n_vertices, const PlyWanted& wanted,
                     const std::string& name) {
    MeshCollector mesh;
    PlyColumns result;
    for (const PlyElement& element : header.elements) {
        if (element.properties.empty()) continue;  // nothing is stored for it
        require_room(values, element, name);
        if (element.name == "vertex") {
            mesh.reserve(static_cast<std::size_t>(n_vertices), 0);
            result.of_vertices = read_vertices(values, element, wanted, mesh);
        } else if (element.name == "face") {
            mesh.reserve(0, static_cast<std::size_t>(element.count));
            result.of_corners = read_faces(values, element, n_vertices, wanted, mesh);
        } else {
            for (std::int64_t i = 0; i < element.count; ++i) {
                values.begin(element, i);
                for (const PlyProperty& property : element.properties) skip(values, property);
                values.end();
            }
        }
    }
    result.file = mesh.finish();
    if (values.n_surplus() > 0)
        result.file.notices.push_back(
            fmt::format("{} lines have more values than the header says; what is too much is left out",
                        values.n_surplus()));
    return result;
}

// The only element of that name; null if there is none.
const PlyElement* find_element(const PlyHeader& header, std::string_view wanted, const std::string& name) {
    const PlyElement* found = nullptr;
    for (const PlyElement& element : header.elements) {
        if (element.name != wanted) continue;
        if (found != nullptr) throw IoError(fmt::format("{}: two elements '{}' in the header", name, wanted));
        found = &element;
    }
    return found;
}

// Returns the number of vertices.
std::int64_t check_elements(const PlyHeader& header, const std::string& name) {
    const PlyElement* vertex = find_element(header, "vertex", name);
    const PlyElement* face = find_element(header, "face", name);
    if (vertex == nullptr) throw IoError(fmt::format("{}: the header has no element 'vertex'", name));
    for (const std::string axis : {"x", "y", "z"}) {
        const auto count = std::count_if(vertex->properties.begin(), vertex->properties.end(),
                                         [&](const PlyProperty& p) { return p.name == axis && !p.is_list; });
        if (count != 1)
            throw IoError(
                fmt::format("{}: element 'vertex' needs one property '{}', it has {}", name, axis, count));
    }
    if (face == nullptr && find_element(header, "tristrips", name) != nullptr)
        throw IoError(fmt::format("{}: triangle strips are not supported; save the mesh with faces", name));
    if (face != nullptr && face->count > 0) {
        const auto corners = std::find_if(face->properties.begin(), face->properties.end(), holds_corners);
        if (corners == face->properties.end())
            throw IoError(fmt::format("{}: element 'face' has no list 'vertex_indices'", name));
        if (std::count_if(face->properties.begin(), face->properties.end(), holds_corners) > 1)
            throw IoError(fmt::format("{}: element 'face' has several lists of vertices", name));
        if (corners->type == PlyType::float32 || corners->type == PlyType::float64)
            throw IoError(fmt::format("{}: '{}' must be whole numbers", name, corners->name));
    }
    return vertex->count;
}

}  // namespace

PlyColumns read_ply_columns(std::string_view bytes, const PlyWanted& wanted, const std::string& name) {
    TextCursor text(bytes, name);
    const PlyHeader header = read_ply_header(text);
    const std::int64_t n_vertices = check_elements(header, name);
    const auto order =
        header.format == PlyHeader::Format::little_endian ? std::endian::little : std::endian::big;
    PlyColumns result =
        header.format == PlyHeader::Format::ascii
            ? read_body(TextValues(text), header, n_vertices, wanted, name)
            : read_body(BinaryValues(bytes.substr(bytes.size() - text.remaining()), order, name), header,
                        n_vertices, wanted, name);
    for (const PlyProperty& property : find_element(header, "vertex", name)->properties)
        if (!property.is_list && property.name != "x" && property.name != "y" && property.name != "z")
            result.properties.push_back(property);
    return result;
}

MeshFile read_ply(std::string_view bytes, const std::string& name) {
    return read_ply_columns(bytes, {.of_vertices = false, .of_corners = false}, name).file;
}

std::string ply_bytes(MeshView mesh) {
    const bool large = has_large_faces(mesh);
    std::string bytes = fmt::format(
        "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty double x\nproperty double y\n"
        "property double z\nelement face {}\nproperty list {} int vertex_indices\nend_header\n",
        mesh.n_vertices(), n_faces(mesh), list_size_type(large));
    bytes.reserve(bytes.size() + static_cast<std::size_t>(mesh.n_vertices()) * 24 +
                  static_cast<std::size_t>(mesh.n_triangles()) * 13);
    for (Index v = 0; v < mesh.n_vertices(); ++v)
        for (int k = 0; k < 3; ++k) append_number(bytes, mesh.vertices(v, k));
    for_each_face(mesh, [&](Index, std::span<const Index> corners) {
        append_list_size(bytes, corners.size(), large);
        for (const Index corner : corners) append_number(bytes, mesh.triangles.data()[corner]);
    });
    return bytes;
}

}  // namespace counterpart::io
