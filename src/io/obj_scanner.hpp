// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "io/text_cursor.hpp"

#include <counterpart/base/types.hpp>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace counterpart::io {

/// The face of an `f` statement, corner by corner.
struct ObjFace {
    std::vector<Index> vertices;         ///< counted from 0
    std::vector<std::string_view> rows;  ///< the text behind them, such as "/2/3"
};

/// The rows of `vt` and `vn` that a corner names, counted from 0. Below 0: none. A row may lie beyond the
/// last one.
using ObjRows = std::array<std::int64_t, 2>;

/// Walks through a Wavefront OBJ file statement by statement: what the lines mean is known here alone.
/// Numbers count from 1 and may name what follows later; negative ones count back from the last so far.
class ObjScanner {
  public:
    ObjScanner(std::string_view bytes, const std::string& name) : text_(bytes, name) {}

    /// Moves to the next statement; false at the end of the file.
    bool next();
    std::string_view key_word() const { return key_word_; }
    TextCursor& text() { return text_; }  ///< behind the key word

    /// The corners that follow `f`, at least 3; valid until the next face.
    const ObjFace& face();
    /// Those of `face().rows`. Throws IoError if they are neither numbers nor left out.
    ObjRows rows(std::string_view text) const;
    /// At the end of the file: throws IoError if a face names a vertex that it does not have.
    void require_vertices() const;

  private:
    Index read_vertex();

    TextCursor text_;
    std::string_view key_word_;
    ObjFace face_;
    std::int64_t n_vertices_ = 0, n_textures_ = 0, n_normals_ = 0;  // so far
    std::int64_t largest_vertex_ = 0;                               // that a face names, and where
    int line_of_largest_ = 0;
};

}  // namespace counterpart::io
