// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "io/chosen_object.hpp"
#include "io/corner_rows.hpp"
#include "io/format_table.hpp"
#include "io/left_out.hpp"
#include "platform/files.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/io/mesh_file.hpp>
#include <counterpart/io/mesh_objects.hpp>

#include <algorithm>
#include <array>
#include <string_view>

#include <fmt/format.h>

namespace counterpart {

using namespace io;

namespace {

template <typename Condition>
std::vector<std::string> extensions_where(const Condition& holds) {
    std::vector<std::string> result;
    for (const MeshFormat& format : mesh_formats())
        if (holds(format)) result.emplace_back(format.extension);
    return result;
}

[[noreturn]] void fail_on_extension(const std::filesystem::path& file, const char* what,
                                    const std::vector<std::string>& extensions) {
    throw IoError(fmt::format("{}: the name of {} must end in {}, which tells the format",
                              platform::utf8_name(file), what, fmt::join(extensions, ", ")));
}

// Files of programs that can save others.
constexpr std::array<std::string_view, 13> scenes = {".fbx", ".usd",   ".usda", ".usdc", ".usdz",
                                                     ".abc", ".blend", ".dae",  ".3ds",  ".max",
                                                     ".ma",  ".mb",    ".3mf"};

void refuse_scene(const std::filesystem::path& file) {
    if (std::find(scenes.begin(), scenes.end(), lower_extension(file)) == scenes.end()) return;
    throw IoError(fmt::format(
        "{}: scenes of this format are not read; open it in Blender, say, and save it as .glb, which keeps "
        "skin, shape keys and materials",
        platform::utf8_name(file)));
}

// What `work` gives; InvalidInput becomes IoError with the file's name and `prefix`.
template <typename Work>
auto naming(const std::filesystem::path& file, const char* prefix, const Work& work) {
    try {
        return work();
    } catch (const InvalidInput& error) {
        throw IoError(fmt::format("{}: {}{}", platform::utf8_name(file), prefix, error.what()));
    }
}

std::string counted(std::size_t n, const char* one, const char* many) {
    return n == 1 ? fmt::format("1 {}", one) : fmt::format("{} {}", n, many);
}

// Without the faces of vertices that are left out; says so, or refuses them.
void leave_out(AttributedMesh& content, std::vector<std::string>& notices, const ReadOptions& options) {
    const std::vector<Index>& left_out = content.mesh.left_out;
    if (left_out.empty()) return;
    if (options.strict)
        throw InvalidInput(fmt::format("vertex {} has a coordinate that is no finite number", left_out[0]));
    const auto n_removed = static_cast<std::size_t>(remove_faces_of_left_out(content));
    notices.push_back(
        fmt::format("{} left out, with {} on {}: vertex {} is the first; maps have no partner for {}",
                    counted(left_out.size(), "vertex whose coordinates are no numbers is",
                            "vertices whose coordinates are no numbers are"),
                    counted(n_removed, "triangle", "triangles"), left_out.size() == 1 ? "it" : "them",
                    left_out[0], left_out.size() == 1 ? "it" : "them"));
}

enum class Attributes { none, all };

// What a file holds, with no attributes but those that come along with its cells, or with all.
AttributedMeshFile read_content(const std::filesystem::path& file, const ReadOptions& options,
                                Attributes attributes) {
    const MeshFormat* const format = find_mesh_format(file);
    if (format == nullptr) {
        refuse_scene(file);
        fail_on_extension(file, "a mesh", mesh_extensions().read);
    }
    return naming(file, "", [&] {
        if (options.object && !format->has_objects) require_single_object(*options.object);
        AttributedMeshFile result =
            attributes == Attributes::all && format->read_attributed != nullptr
                ? format->read_attributed(file, options)
            : format->read != nullptr ? format->read(file, options)
                                      : content_of_cells(format->read_cells(file), platform::utf8_name(file));
        leave_out(result.content, result.notices, options);
        require_valid(result.content.mesh);
        return result;
    });
}

constexpr const char* not_written = "not written: ";

}  // namespace

MeshExtensions mesh_extensions() {
    return {
        extensions_where([](const MeshFormat& f) { return f.read != nullptr || f.read_cells != nullptr; }),
        extensions_where([](const MeshFormat& f) { return f.write != nullptr; }),
        extensions_where([](const MeshFormat& f) { return f.read_cells != nullptr; }),
        extensions_where([](const MeshFormat& f) { return f.write_solid != nullptr; })};
}

MeshFile read_mesh(const std::filesystem::path& file, const ReadOptions& options) {
    AttributedMeshFile read = read_content(file, options, Attributes::none);
    return {std::move(read.content.mesh), std::move(read.notices)};
}

AttributedMeshFile read_attributed_mesh(const std::filesystem::path& file, const ReadOptions& options) {
    return read_content(file, options, Attributes::all);
}

std::vector<MeshObject> mesh_objects(const std::filesystem::path& file, const ReadOptions& options) {
    ReadOptions whole = options;
    whole.object.reset();
    return mesh_objects(read_content(file, whole, Attributes::none).content);
}

std::optional<TetrahedralMeshFile> read_tetrahedral_mesh(const std::filesystem::path& file) {
    const MeshFormat* const format = find_mesh_format(file);
    if (format == nullptr || format->read_cells == nullptr) return std::nullopt;
    return naming(file, "", [&]() -> std::optional<TetrahedralMeshFile> {
        const Cells cells = format->read_cells(file);
        if (cells.tetrahedra.empty()) return std::nullopt;
        return solid_of_cells(cells, platform::utf8_name(file));
    });
}

void write_mesh(MeshView mesh, const std::filesystem::path& file) {
    const MeshFormat* const format = find_mesh_format(file);
    if (format == nullptr || format->write == nullptr)
        fail_on_extension(file, "a mesh", mesh_extensions().written);
    naming(file, not_written, [&] {
        require_valid(mesh);
        format->write(mesh, file);
    });
}

void write_attributed_mesh(const AttributedMesh& content, const std::filesystem::path& file) {
    const MeshFormat* const format = find_mesh_format(file);
    if (format == nullptr || format->write_attributed == nullptr) return write_mesh(content.mesh, file);
    naming(file, not_written, [&] {
        require_consistent(content);
        format->write_attributed(content, file);
    });
}

void write_tetrahedral_mesh(const TetrahedralMesh& mesh, const std::filesystem::path& file) {
    const MeshFormat* const format = find_mesh_format(file);
    if (format == nullptr || format->write_solid == nullptr)
        fail_on_extension(file, "a mesh of tetrahedra", mesh_extensions().written_solids);
    naming(file, not_written, [&] {
        require_valid(mesh);
        format->write_solid(mesh, file);
    });
}

}  // namespace counterpart
