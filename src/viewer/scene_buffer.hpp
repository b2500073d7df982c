// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// The binary part of a viewer page: arrays one after the other, each at a multiple of four bytes, all
// little-endian. viewer/src/scene_data.ts reads them.
#pragma once

#include <counterpart/mesh/triangle_mesh.hpp>

#include <bit>
#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace counterpart::viewer {

class SceneBuffer {
  public:
    /// Appends one number in little-endian order.
    template <std::unsigned_integral T>
    void put(T number) {
        for (std::size_t i = 0; i < sizeof(T); ++i)
            bytes_ += static_cast<char>(static_cast<unsigned char>(number >> (8 * i)));
    }
    void put(float number) { put(std::bit_cast<std::uint32_t>(number)); }

    /// Appends bytes as they are.
    void put(std::string_view bytes) { bytes_ += bytes; }

    /// Where the next array starts, in bytes, after filling up to a multiple of four.
    std::size_t start_array() {
        bytes_.resize((bytes_.size() + 3) / 4 * 4);
        return bytes_.size();
    }

    const std::string& bytes() const { return bytes_; }

  private:
    std::string bytes_;
};

}  // namespace counterpart::viewer
