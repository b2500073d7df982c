// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "material_files.hpp"

#include "files.hpp"

#include <counterpart/io/file.hpp>
#include <counterpart/io/mesh_file.hpp>

#include <algorithm>
#include <string>

namespace counterpart::cli {

namespace fs = std::filesystem;

Index n_parts(const AttributedMesh& content) {
    return content.parts.empty() ? 1 : *std::max_element(content.parts.begin(), content.parts.end()) + 1;
}

void carry_material_files(const fs::path& from, const fs::path& to) {
    if (lower_extension(from) != ".obj" || lower_extension(to) != ".obj" || !fs::is_regular_file(to)) return;
    const fs::path folder = fs::absolute(to).parent_path();
    std::string carried;
    for (const std::string& library : material_files(from)) {
        const fs::path name = platform::path_of(library);
        const fs::path file = fs::absolute(from).parent_path() / name;  // an absolute name stays
        const std::string shown = utf8_name(name.is_absolute() ? name : file.lexically_proximate(folder));
        // A backslash at the end would continue the line.
        carried += "mtllib " + shown + (shown.ends_with('\\') ? " \n" : "\n");
    }
    if (!carried.empty()) write_file(carried + read_whole_file(to), to);
}

}  // namespace counterpart::cli
