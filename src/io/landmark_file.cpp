// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "io/landmark_bytes.hpp"
#include "io/text_cursor.hpp"
#include "platform/files.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/io/file.hpp>
#include <counterpart/io/landmark_file.hpp>

#include <cmath>

#include <fmt/format.h>

namespace counterpart {
namespace {

Index nearest_vertex(MeshView mesh, const Eigen::RowVector3d& point) {
    Eigen::Index nearest = 0;
    (mesh.vertices.rowwise() - point).rowwise().squaredNorm().minCoeff(&nearest);
    return static_cast<Index>(nearest);
}

Index vertex_number(double value, const char* side, MeshView mesh, const io::TextCursor& text) {
    if (value != std::floor(value)) text.fail(fmt::format("{} is not a vertex number", value));
    if (value < 0 || value >= mesh.n_vertices())
        text.fail(fmt::format("{} vertex {} is out of range: the mesh has {} vertices, counted from 0", side,
                              value, mesh.n_vertices()));
    return static_cast<Index>(value);
}

}  // namespace

std::vector<std::pair<Index, Index>> io::parse_landmarks(std::string_view bytes, const std::string& name,
                                                         MeshView source, MeshView target) {
    TextCursor text(bytes, name);
    std::vector<std::pair<Index, Index>> landmarks;
    while (text.next_content()) {
        std::vector<double> values;
        while (!text.at_line_end() && values.size() <= 6) values.push_back(text.coordinate("landmark"));
        if (values.size() == 2) {
            landmarks.emplace_back(vertex_number(values[0], "source", source, text),
                                   vertex_number(values[1], "target", target, text));
        } else if (values.size() == 6) {
            landmarks.emplace_back(nearest_vertex(source, {values[0], values[1], values[2]}),
                                   nearest_vertex(target, {values[3], values[4], values[5]}));
        } else {
            text.fail("a landmark is two vertex numbers or two points (6 numbers)");
        }
        text.next_line();
    }
    if (landmarks.empty()) throw IoError(fmt::format("{}: no landmarks in the file", name));
    return landmarks;
}

std::vector<std::pair<Index, Index>> read_landmarks(const std::filesystem::path& file, MeshView source,
                                                    MeshView target) {
    return io::parse_landmarks(read_whole_file(file), platform::utf8_name(file), source, target);
}

}  // namespace counterpart
