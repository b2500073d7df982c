// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "io/corner_rows.hpp"
#include "io/format_table.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/io/mesh_file.hpp>

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
    throw IoError(fmt::format("{}: the name of {} must end in {}, which tells the format", file.string(),
                              what, fmt::join(extensions, ", ")));
}

// What `work` gives; InvalidInput becomes IoError with the file's name and `prefix`.
template <typename Work>
auto naming(const std::filesystem::path& file, const char* prefix, const Work& work) {
    try {
        return work();
    } catch (const InvalidInput& error) {
        throw IoError(fmt::format("{}: {}{}", file.string(), prefix, error.what()));
    }
}

constexpr const char* not_written = "not written: ";

}  // namespace

MeshExtensions mesh_extensions() {
    return {
        extensions_where([](const MeshFormat& f) { return f.read != nullptr || f.read_cells != nullptr; }),
        extensions_where([](const MeshFormat& f) { return f.write != nullptr; }),
        extensions_where([](const MeshFormat& f) { return f.write_solid != nullptr; })};
}

MeshFile read_mesh(const std::filesystem::path& file, const ReadOptions& options) {
    const MeshFormat* const format = find_mesh_format(file);
    if (format == nullptr) fail_on_extension(file, "a mesh", mesh_extensions().read);
    return naming(file, "", [&] {
        MeshFile result = format->read != nullptr ? format->read(file, options)
                                                  : mesh_of_cells(format->read_cells(file), file.string());
        require_valid(result.mesh);
        return result;
    });
}

AttributedMeshFile read_attributed_mesh(const std::filesystem::path& file, const ReadOptions& options) {
    const MeshFormat* const format = find_mesh_format(file);
    if (format == nullptr || format->read_attributed == nullptr) {
        MeshFile plain = read_mesh(file, options);
        AttributedMeshFile result;
        result.content.mesh = std::move(plain.mesh);
        result.notices = std::move(plain.notices);
        return result;
    }
    return naming(file, "", [&] {
        AttributedMeshFile result = format->read_attributed(file, options);
        require_valid(result.content.mesh);
        return result;
    });
}

std::optional<TetrahedralMeshFile> read_tetrahedral_mesh(const std::filesystem::path& file) {
    const MeshFormat* const format = find_mesh_format(file);
    if (format == nullptr || format->read_cells == nullptr) return std::nullopt;
    return naming(file, "", [&]() -> std::optional<TetrahedralMeshFile> {
        const Cells cells = format->read_cells(file);
        if (cells.tetrahedra.empty()) return std::nullopt;
        return solid_of_cells(cells, file.string());
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
