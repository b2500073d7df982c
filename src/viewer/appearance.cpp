// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "viewer/appearance.hpp"

#include <counterpart/base/errors.hpp>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace counterpart::viewer {
namespace {

bool fits(const CornerAttribute& attribute, MeshView mesh, Eigen::Index least_width) {
    if (attribute.values.rows() == 0) return true;
    return attribute.values.cols() >= least_width && attribute.corners.rows() == mesh.n_triangles() &&
           (attribute.corners.array() >= -1).all() &&
           (attribute.corners.array() < static_cast<Index>(attribute.values.rows())).all();
}

}  // namespace

void require_fit(const ViewerAppearance& appearance, MeshView mesh, const std::string& name) {
    const auto& images = appearance.image_of_triangle;
    const auto n_images = static_cast<Index>(appearance.images.size());
    const bool images_fit = n_images == 0 || (images.size() == static_cast<std::size_t>(mesh.n_triangles()) &&
                                              std::all_of(images.begin(), images.end(),
                                                          [&](Index i) { return i >= -1 && i < n_images; }));
    if (!images_fit || !fits(appearance.texture_coordinates, mesh, 2) || !fits(appearance.colors, mesh, 3))
        throw InvalidInput(fmt::format(
            "the appearance of the {} does not fit it: give one row for each triangle's corners, and one "
            "image for each triangle",
            name));
}

void put_appearance(const ViewerAppearance& appearance, nlohmann::ordered_json& mesh, SceneBuffer& buffer) {
    const CornerAttribute& uv = appearance.texture_coordinates;
    if (!appearance.images.empty() && uv.values.rows() > 0) {
        mesh["uv_offset"] = buffer.start_array();
        for (const Index row : uv.corners.reshaped<Eigen::RowMajor>())
            for (int k = 0; k < 2; ++k) buffer.put(row < 0 ? 0.0F : static_cast<float>(uv.values(row, k)));
        mesh["image_of_triangle_offset"] = buffer.start_array();
        for (const Index image : appearance.image_of_triangle) buffer.put(static_cast<std::uint32_t>(image));
        for (const std::string& image : appearance.images) {
            mesh["images"].push_back({{"offset", buffer.start_array()}, {"bytes", image.size()}});
            buffer.put(image);
        }
    }
    const CornerAttribute& colors = appearance.colors;
    if (colors.values.rows() == 0) return;
    mesh["color_offset"] = buffer.start_array();
    for (const Index row : colors.corners.reshaped<Eigen::RowMajor>())
        for (int k = 0; k < 3; ++k) {
            const double color = row < 0 ? 1 : std::clamp(colors.values(row, k), 0.0, 1.0);
            buffer.put(static_cast<std::uint8_t>(std::lround(255 * color)));
        }
}

}  // namespace counterpart::viewer
