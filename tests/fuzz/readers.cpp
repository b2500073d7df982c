// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// What a reader accepts must be valid, and come back the same when it is written and read again.
#include "fuzz/require.hpp"
#include "fuzz/targets.hpp"
#include "io/cells.hpp"
#include "io/chosen_object.hpp"
#include "io/corner_rows.hpp"
#include "io/formats.hpp"
#include "io/gltf_primitives.hpp"
#include "io/gltf_store.hpp"
#include "io/landmark_bytes.hpp"
#include "io/landmark_formats.hpp"
#include "io/left_out.hpp"
#include "io/map_bytes.hpp"
#include "io/npy_bytes.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/io/mesh_file.hpp>
#include <counterpart/io/mesh_objects.hpp>
#include <counterpart/io/obj_reorder.hpp>
#include <counterpart/transfer/transfer.hpp>

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <vector>

namespace counterpart::fuzz {
namespace {

using namespace io;

const std::string name = "fuzzed";

bool same(const TriangleMesh& a, const TriangleMesh& b) {
    return a.vertices == b.vertices && a.triangles == b.triangles;
}

// Whether the mesh may be used: read_mesh asks this of every reader's.
bool is_valid(const TriangleMesh& mesh) {
    try {
        require_valid(mesh);
        return true;
    } catch (const InvalidInput&) {
        return false;
    }
}

void read_off_bytes(std::string_view bytes) {
    const TriangleMesh mesh = read_off(bytes, name).mesh;
    if (is_valid(mesh)) require(same(mesh, read_off(off_bytes(mesh), name).mesh));
}

// With attributes and without.
void require_attributed(const AttributedMesh& content, const TriangleMesh& plain,
                        const AttributedMesh& again) {
    require(same(content.mesh, plain));
    require(same(content.mesh, again.mesh));
    gltf_bytes(content, true);
}

// In the order that it has.
void require_same_reordered(std::string_view bytes, const TriangleMesh& plain) {
    std::vector<Index> all(static_cast<std::size_t>(plain.n_vertices()));
    std::iota(all.begin(), all.end(), 0);
    Triangles corners(plain.n_triangles(), 3);
    std::iota(corners.data(), corners.data() + corners.size(), 0);
    const std::string again = reorder_obj(bytes, bytes, {all, plain.n_vertices()}, plain.triangles, corners);
    require(same(plain, read_obj(again, name).content.mesh));
}

// Each of the first objects is valid, as large as it is listed, and the only one when it is written again.
void require_objects(const AttributedMeshFile& whole) {
    const std::vector<MeshObject> objects = mesh_objects(whole.content);
    for (std::size_t k = 0; k < std::min<std::size_t>(objects.size(), 3); ++k) {
        AttributedMeshFile one = whole;
        take_object(one, std::to_string(k));
        require(one.content.mesh.n_vertices() == objects[k].n_vertices &&
                one.content.mesh.n_triangles() == objects[k].n_triangles);
        // Else polygons may be cut in another way, since what is left out lies elsewhere.
        if (!is_valid(one.content.mesh) || !one.content.mesh.left_out.empty()) continue;
        require_consistent(one.content);
        require(same(one.content.mesh, read_obj(obj_bytes(one.content), name).content.mesh));
    }
}

void read_obj_bytes(std::string_view bytes) {
    const TriangleMesh plain = read_obj(bytes, name).content.mesh;
    if (!is_valid(plain)) return;
    require(same(plain, read_obj(obj_bytes(plain), name).content.mesh));
    const AttributedMeshFile read = read_attributed_obj(bytes, name);
    const AttributedMesh& content = read.content;
    require_consistent(content);
    require_objects(read);
    require_attributed(content, plain, read_attributed_obj(obj_bytes(content), name).content);
    require_same_reordered(bytes, plain);
}

void read_ply_bytes(std::string_view bytes) {
    const TriangleMesh plain = read_ply(bytes, name).mesh;
    if (!is_valid(plain)) return;
    require(same(plain, read_ply(ply_bytes(plain), name).mesh));
    const AttributedMesh content = read_attributed_ply(bytes, name).content;
    require_consistent(content);
    require_attributed(content, plain, read_attributed_ply(ply_bytes(content), name).content);
}

void read_stl_bytes(std::string_view bytes) {
    const AttributedMesh content = read_stl(bytes, name).content;
    if (!is_valid(content.mesh)) return;
    require_consistent(content);
    read_stl(stl_bytes(content.mesh), name);
    const std::vector<MeshObject> objects = mesh_objects(content);
    const AttributedMesh one = read_stl(bytes, name, {.object = std::to_string(objects.size() - 1)}).content;
    require_consistent(one);
    require(one.mesh.n_vertices() == objects.back().n_vertices);
}

void use_cells(const Cells& cells) {
    AttributedMesh content = content_of_cells(cells, name).content;
    remove_faces_of_left_out(content);
    if (is_valid(content.mesh)) {
        require_consistent(content);
        const auto require_same_surface = [&](const Cells& again) {
            const AttributedMesh read = content_of_cells(again, name).content;
            require(same(read.mesh, content.mesh) && read.values.size() == content.values.size());
        };
        require_same_surface(read_vtk(vtk_bytes(content), name));
        require_same_surface(read_vtp(vtp_bytes(content), name));
    }
    if (cells.tetrahedra.empty()) return;
    const TetrahedralMesh solid = solid_of_cells(cells, name).mesh;
    const auto require_same = [&](const Cells& again) {
        const TetrahedralMesh read = solid_of_cells(again, name).mesh;
        require(read.vertices == solid.vertices && read.tetrahedra == solid.tetrahedra);
    };
    require_same(read_gmsh(gmsh_bytes(solid), name));
    require_same(read_medit(medit_bytes(solid), name));
    require_same(read_vtk(vtk_bytes(solid), name));
}

template <Cells (*read)(std::string_view, const std::string&)>
void read_cells_bytes(std::string_view bytes) {
    use_cells(read(bytes, name));
}

// Two files in one: a form feed parts vertices from elements, a vertical tab outlines from their vertices;
// without them it is outlines that hold their own.
void read_ele_bytes(std::string_view bytes) {
    const std::size_t end = bytes.find_first_of("\f\v");
    const std::string_view first = bytes.substr(0, end);
    if (end == std::string_view::npos)
        use_cells(parse_outlines(first, "", name));
    else if (bytes[end] == '\f')
        use_cells(parse_ele(first, bytes.substr(end + 1), name, name));
    else
        use_cells(parse_outlines(first, bytes.substr(end + 1), name));
}

GltfFile read_gltf_bytes(std::string_view bytes, const std::optional<std::string>& object = {}) {
    // No folder of this name: what the bytes name beside themselves is never there.
    return surface_of(parse_gltf(bytes, "/absent/fuzzed.gltf"), object);
}

// Written as it is, with the materials of another, with all numbers changed, or without what only glTF holds.
AttributedMesh rewritten(const AttributedMesh& content, std::size_t way) {
    AttributedMesh result = content;
    if (way == 1) {
        std::vector<Index> parts(static_cast<std::size_t>(content.mesh.n_triangles()), 0);
        if (!content.parts.empty()) parts.assign(content.parts.rbegin(), content.parts.rend());
        return with_materials(content, content, parts);
    }
    if (way >= 2) {
        result.mesh.vertices *= 0.5;
        for (CornerAttribute& uv : result.texture_coordinates) uv.values *= 0.5;
        for (CornerAttribute& color : result.colors) color.values *= 0.5;
    }
    if (way == 3) {
        result.document = nullptr;
        result.part_names.clear();
    }
    return result;
}

void read_and_write_gltf(std::string_view bytes) {
    const AttributedMesh content = read_gltf_bytes(bytes).content;
    require_valid(content.mesh);
    const std::vector<MeshObject> objects = mesh_objects(content);
    const AttributedMesh one = read_gltf_bytes(bytes, std::to_string(objects.size() - 1)).content;
    require(one.mesh.n_vertices() == objects.back().n_vertices &&
            one.mesh.n_triangles() == objects.back().n_triangles);
    const AttributedMesh written = rewritten(content, bytes.size() % 4);
    const double frames_per_second = bytes.size() % 3 == 0 ? 24 : 0;
    const AttributedMesh again =
        read_gltf_bytes(gltf_bytes(written, bytes.size() % 8 < 4, frames_per_second)).content;
    require(again.mesh.n_triangles() == content.mesh.n_triangles());
    const BaseColors colors = read_base_colors(content, "/absent/fuzzed.gltf");
    for (const Index image : colors.image_of_triangle)
        require(image >= -1 && image < static_cast<Index>(colors.images.size()));
}

// The first byte chooses the kind of file, and what the caller says of the target.
void read_map_bytes(std::string_view bytes) {
    if (bytes.empty()) return;
    const char* file = (bytes[0] & 1) != 0 ? "fuzzed.npy" : "fuzzed.txt";
    const IndexBase base = (bytes[0] & 2) != 0 ? IndexBase::one : IndexBase::zero;
    const Index target_size = (bytes[0] & 4) != 0 ? 5 : -1;
    const VertexMap map = parse_vertex_map(bytes.substr(1), file, base, target_size);
    for (const Index image : map.image()) require(image >= -1 && image < map.target_size());
    require(parse_vertex_map(vertex_map_bytes(map, file, base), file, base, target_size) == map);
}

void read_surface_map_bytes(std::string_view bytes) {
    if (bytes.empty()) return;
    const char* file = (bytes[0] & 1) != 0 ? "fuzzed.npy" : "fuzzed.txt";
    const auto map = parse_map(bytes.substr(1), file);
    if (const auto* points = std::get_if<SurfaceMap>(&map)) {
        require_valid(*points, points->source_size(), points->target_triangles);
        require(parse_surface_map(surface_map_bytes(*points, file), file) == *points);
    }
}

// Of a square, its corners far from each other and from the origin.
void read_landmark_bytes(std::string_view bytes) {
    static const TriangleMesh square{(Points(4, 3) << 9, 0, 0, 9, 5, 0, -9, 5, 0, -9, 0, 1).finished(),
                                     (Triangles(2, 3) << 0, 1, 2, 0, 2, 3).finished()};
    const auto landmarks = parse_landmarks(bytes, name, square, square);
    require(!landmarks.empty());
    std::string written;
    for (const auto& [s, t] : landmarks) {
        require(s >= 0 && s < square.n_vertices() && t >= 0 && t < square.n_vertices());
        written += std::to_string(s) + ' ' + std::to_string(t) + '\n';
    }
    require(parse_landmarks(written, name, square, square) == landmarks);
}

// The first byte chooses the format; what is written is read again.
void read_landmark_point_bytes(std::string_view bytes) {
    using Parse = LandmarkPoints (*)(std::string_view, const std::string&);
    using Write = std::string (*)(const LandmarkPoints&);
    constexpr std::array<std::pair<Parse, Write>, 4> formats = {{{parse_slicer_json, slicer_json_bytes},
                                                                 {parse_fcsv, fcsv_bytes},
                                                                 {parse_scalismo_json, scalismo_json_bytes},
                                                                 {parse_landmark_csv, landmark_csv_bytes}}};
    if (bytes.empty()) return;
    const auto& [parse, write] = formats[static_cast<unsigned char>(bytes[0]) % formats.size()];
    LandmarkPoints points = parse(bytes.substr(1), name);
    if (!points.axes) points.axes = Anatomical::ras;
    for (Landmark& landmark : points.landmarks) landmark.name = "a";
    const LandmarkPoints again = parse(write(points), name);
    require(again.landmarks.size() == points.landmarks.size());
    for (std::size_t i = 0; i < points.landmarks.size(); ++i)
        require(again.landmarks[i].point == points.landmarks[i].point);
}

void read_npy_bytes(std::string_view bytes) {
    const Matrix matrix = parse_npy(bytes, name);
    const std::string written = npy_bytes(matrix);
    require(npy_bytes(parse_npy(written, name)) == written);  // bytes, because numbers may be NaN
    if (matrix.cols() == 1 && matrix.size() > 0) {
        parse_npy(npy_bytes(Vector(matrix.col(0))), name);
        const std::vector<Index> numbers = parse_npy_indices(bytes, name);
        require(parse_npy_indices(npy_bytes(numbers), name) == numbers);
    }
}

template <void (*read)(std::string_view)>
void read_or_refused(std::string_view bytes) {
    try {
        read(bytes);
    } catch (const IoError&) {
    } catch (const InvalidInput&) {
    } catch (const GltfJson::exception&) {  // what write_gltf turns into an IoError
    }
}

constexpr std::array<Target, 16> readers = {
    {{"off", read_or_refused<read_off_bytes>},
     {"obj", read_or_refused<read_obj_bytes>},
     {"ply", read_or_refused<read_ply_bytes>},
     {"stl", read_or_refused<read_stl_bytes>},
     {"msh", read_or_refused<read_cells_bytes<read_gmsh>>},
     {"medit", read_or_refused<read_cells_bytes<read_medit>>},
     {"vtk", read_or_refused<read_cells_bytes<read_vtk>>},
     {"vtp", read_or_refused<read_cells_bytes<read_vtp>>},
     {"gii", read_or_refused<read_cells_bytes<read_gifti>>},
     {"ele", read_or_refused<read_ele_bytes>},
     {"gltf", read_or_refused<read_and_write_gltf>},
     {"npy", read_or_refused<read_npy_bytes>},
     {"map", read_or_refused<read_map_bytes>},
     {"surface_map", read_or_refused<read_surface_map_bytes>},
     {"landmarks", read_or_refused<read_landmark_bytes>},
     {"landmark_points", read_or_refused<read_landmark_point_bytes>}}};

}  // namespace

std::span<const Target> reader_targets() { return readers; }

}  // namespace counterpart::fuzz
