// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/render/color.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace counterpart::render {

/// Rows from the top, pixels from the left, three bytes each (sRGB).
struct Image {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgb;  ///< 3 * width * height

    /// Throws InvalidInput unless both sides are 1 .. 16384.
    Image(int width, int height, const Color& fill);
    Image() = default;

    Color at(int column, int row) const {
        const std::uint8_t* p = &rgb[offset(column, row)];
        return Color(p[0], p[1], p[2]) / 255.0;
    }
    void set(int column, int row, const Color& color);
    bool operator==(const Image&) const = default;

  private:
    std::size_t offset(int column, int row) const {
        return 3 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                    static_cast<std::size_t>(column));
    }
};

/// The bytes of a PNG file, 8 bits a channel. The same image gives the same bytes.
std::string encode_png(const Image& image);
/// Reads what encode_png wrote, and any other PNG as 8-bit RGB (transparency over white). Throws IoError.
Image decode_png(std::string_view bytes);

}  // namespace counterpart::render
