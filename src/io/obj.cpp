// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Wavefront OBJ: the lines `v` and `f`, the objects `o` or groups `g` that they are in and, where attributes
// are wanted, `vt`, `vn`, `usemtl` and colors behind the coordinates of `v`; all other lines are passed over.
#include "io/formats.hpp"
#include "io/mesh_collector.hpp"
#include "io/obj_scanner.hpp"
#include "io/object_sections.hpp"

#include <unordered_map>
#include <utility>

#include <fmt/format.h>

namespace counterpart::io {
namespace {

// Gathers what the file holds beside its faces and their objects.
class Attributes {
  public:
    // Behind the coordinates: a weight, a color, or both.
    void read_color(TextCursor& text) {
        std::array<double, 4> numbers = {};
        std::size_t n = 0;
        while (n < numbers.size() && !text.at_line_end()) numbers[n++] = text.number("vertex");
        if (n == 3) colors_.insert(colors_.end(), {numbers[0], numbers[1], numbers[2]});
    }

    void add_face(const ObjFace& face, const ObjScanner& scanner) {
        if (part_ < 0) part_ = part_of("");
        for (const std::string_view rows : face.rows) corners_.push_back(scanner.rows(rows));
        parts_.insert(parts_.end(), face.vertices.size() - 2, part_);
    }

    // OBJ counts the second texture coordinate from the image's lower edge.
    void read_statement(std::string_view key_word, TextCursor& text) {
        if (key_word == "vt") {
            const double u = text.coordinate("u");
            const double v = text.at_line_end() ? 0 : text.coordinate("v");
            textures_.insert(textures_.end(), {u, 1 - v});
        } else if (key_word == "vn") {
            for (const char* axis : {"x", "y", "z"}) normals_.push_back(text.coordinate(axis));
        } else if (key_word == "usemtl") {
            part_ = part_of(std::string(text.rest()));
        }
    }

    // To the mesh of the faces; a notice where the file lacks rows.
    void move_to(AttributedMeshFile& file) {
        AttributedMesh& content = file.content;
        if (CornerAttribute uv = attribute_of(0, textures_, file); uv.values.rows() > 0)
            content.texture_coordinates.push_back(std::move(uv));
        content.normals = attribute_of(1, normals_, file);
        const Index n_vertices = content.mesh.n_vertices();
        if (n_vertices > 0 && colors_.size() == 3 * static_cast<std::size_t>(n_vertices))
            content.colors.push_back(
                {Eigen::Map<const Matrix>(colors_.data(), n_vertices, 3), content.mesh.triangles});
        if (part_names_.size() > 1 || (part_names_.size() == 1 && !part_names_[0].empty())) {
            content.parts = std::move(parts_);
            content.part_names = std::move(part_names_);
        }
    }

  private:
    Index part_of(const std::string& material) {
        const auto [known, is_new] = known_.emplace(material, static_cast<Index>(part_names_.size()));
        if (is_new) part_names_.push_back(material);
        return known->second;
    }

    // Exporters strip rows that corners still name: then the attribute is left out, with a notice.
    CornerAttribute attribute_of(std::size_t k, const std::vector<double>& values,
                                 AttributedMeshFile& file) const {
        const TriangleMesh& mesh = file.content.mesh;
        CornerAttribute attribute;
        const Eigen::Index width = k == 0 ? 2 : 3, n_rows = std::ssize(values) / width;
        attribute.values = Eigen::Map<const Matrix>(values.data(), n_rows, width);
        attribute.corners.resize(mesh.n_triangles(), 3);
        bool any = false;
        for (Eigen::Index i = 0; i < attribute.corners.size(); ++i) {
            const Eigen::Index corner = mesh.polygons.empty() ? i : mesh.polygons.corners(i / 3, i % 3);
            const std::int64_t row = corners_[static_cast<std::size_t>(corner)][k];
            if (row >= n_rows) {
                file.notices.push_back(
                    fmt::format("{} are left out: faces name more than the {} that the file has",
                                k == 0 ? "texture coordinates" : "normals", n_rows));
                return {};
            }
            any |= row >= 0;
            attribute.corners(i / 3, i % 3) = static_cast<Index>(row);
        }
        return any ? attribute : CornerAttribute();
    }

    std::vector<double> textures_, normals_, colors_;
    std::vector<ObjRows> corners_;  // of all faces, one after another
    std::vector<Index> parts_;      // of the triangles
    std::vector<std::string> part_names_;
    std::unordered_map<std::string, Index> known_;  // parts by name
    Index part_ = -1;                               // of the faces that follow; -1: none has begun
};

// `attributes` may be null.
AttributedMeshFile read(std::string_view bytes, const std::string& name, Attributes* attributes) {
    MeshCollector mesh;
    ObjectSections objects, groups;
    ObjScanner scanner(bytes, name);
    while (scanner.next()) {
        const std::string_view key_word = scanner.key_word();
        TextCursor& text = scanner.text();
        if (key_word == "v") {
            const double x = text.number("x"), y = text.number("y"), z = text.number("z");
            mesh.add_vertex(x, y, z);
            if (attributes != nullptr) attributes->read_color(text);
        } else if (key_word == "f") {
            const ObjFace& face = scanner.face();
            mesh.add_face(face.vertices);
            if (attributes != nullptr) attributes->add_face(face, scanner);
        } else if (key_word == "o" || key_word == "g") {
            (key_word == "o" ? objects : groups).begin(text.rest(), mesh.n_vertices(), mesh.n_triangles());
        } else if (attributes != nullptr) {
            attributes->read_statement(key_word, text);
        }
    }
    scanner.require_vertices();
    MeshFile plain = mesh.finish();
    AttributedMeshFile result{{}, std::move(plain.notices)};
    const Index n_vertices = plain.mesh.n_vertices(), n_triangles = plain.mesh.n_triangles();
    result.content.mesh = std::move(plain.mesh);
    using Same = ObjectSections::SameName;  // an element of a group may follow those of another
    result.content.objects = objects.empty() ? groups.objects(n_vertices, n_triangles, Same::one)
                                             : objects.objects(n_vertices, n_triangles, Same::several);
    if (attributes != nullptr) attributes->move_to(result);
    return result;
}

}  // namespace

AttributedMeshFile read_obj(std::string_view bytes, const std::string& name) {
    return read(bytes, name, nullptr);
}

AttributedMeshFile read_attributed_obj(std::string_view bytes, const std::string& name) {
    Attributes attributes;
    return read(bytes, name, &attributes);
}

}  // namespace counterpart::io
