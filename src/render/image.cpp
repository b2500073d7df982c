// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include <counterpart/base/errors.hpp>
#include <counterpart/render/image.hpp>

#include <algorithm>
#include <cmath>

#include <png.h>

namespace counterpart::render {
namespace {

std::uint8_t to_byte(double x) {
    return static_cast<std::uint8_t>(std::lround(255 * std::clamp(x, 0.0, 1.0)));
}

}  // namespace

Image::Image(int width_, int height_, const Color& fill) : width(width_), height(height_) {
    constexpr int most = 16384;
    if (width < 1 || height < 1 || width > most || height > most)
        throw InvalidInput("an image must be 1 to 16384 pixels wide and high, not " + std::to_string(width) +
                           " x " + std::to_string(height));
    rgb.resize(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (std::size_t i = 0; i < rgb.size(); ++i) rgb[i] = to_byte(fill[static_cast<Eigen::Index>(i % 3)]);
}

void Image::set(int column, int row, const Color& color) {
    std::uint8_t* p = &rgb[offset(column, row)];
    for (int c = 0; c < 3; ++c) p[c] = to_byte(color[c]);
}

std::string encode_png(const Image& image) {
    png_image header{};
    header.version = PNG_IMAGE_VERSION;
    header.width = static_cast<png_uint_32>(image.width);
    header.height = static_cast<png_uint_32>(image.height);
    header.format = PNG_FORMAT_RGB;
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(header);
    std::string bytes(size, '\0');
    if (png_image_write_to_memory(&header, bytes.data(), &size, 0, image.rgb.data(), 0, nullptr) == 0)
        throw IoError(std::string("the image cannot be written as PNG: ") + header.message);
    bytes.resize(size);
    return bytes;
}

Image decode_png(std::string_view bytes) {
    png_image header{};
    header.version = PNG_IMAGE_VERSION;
    if (png_image_begin_read_from_memory(&header, bytes.data(), bytes.size()) == 0)
        throw IoError(std::string("not a PNG image: ") + header.message);
    header.format = PNG_FORMAT_RGB;
    Image image(static_cast<int>(header.width), static_cast<int>(header.height), {1, 1, 1});
    const png_color white{255, 255, 255};
    if (png_image_finish_read(&header, &white, image.rgb.data(), 0, nullptr) == 0)
        throw IoError(std::string("the PNG image is damaged: ") + header.message);
    return image;
}

}  // namespace counterpart::render
