// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/character_glb.hpp"

#include "base/random.hpp"
#include "io/byte_order.hpp"

#include <counterpart/mesh/measure.hpp>
#include <counterpart/render/image.hpp>

#include <array>
#include <map>
#include <numeric>

#include <nlohmann/json.hpp>

namespace counterpart::test {
namespace {

using Json = nlohmann::ordered_json;

// The vertices of the file: pairs of a vertex of the mesh and a row of its texture coordinates.
struct SplitVertices {
    std::vector<Index> vertex, row;
    std::vector<Index> corners;  // three for each triangle
};

SplitVertices split(const AttributedMesh& content, const CharacterExport& options) {
    const CornerAttribute& uv = content.texture_coordinates.at(0);
    using Key = std::array<Index, 3>;
    const auto key_of = [&](Index t, int c) {
        return Key{content.mesh.triangles(t, c), uv.corners(t, c),
                   options.every_corner_alone ? 3 * t + c : 0};
    };
    std::map<Key, Index> number_of;
    for (Index t = 0; t < content.mesh.n_triangles(); ++t)
        for (int c = 0; c < 3; ++c) number_of[key_of(t, c)] = 0;
    std::vector<Index> order(number_of.size());
    std::iota(order.begin(), order.end(), 0);
    Random random(options.shuffle_seed);
    if (options.shuffle_seed != 0) random.shuffle(order);
    SplitVertices result{std::vector<Index>(order.size()), std::vector<Index>(order.size()), {}};
    auto next = order.begin();
    for (auto& [key, number] : number_of) {
        number = *next++;
        result.vertex[static_cast<std::size_t>(number)] = key[0];
        result.row[static_cast<std::size_t>(number)] = key[1];
    }
    for (Index t = 0; t < content.mesh.n_triangles(); ++t)
        for (int c = 0; c < 3; ++c) result.corners.push_back(number_of.at(key_of(t, c)));
    return result;
}

// JSON and binary chunk of a GLB, growing together.
struct Glb {
    Json json = {{"asset", {{"version", "2.0"}, {"generator", "character"}}}, {"scene", 0}};
    std::string binary;

    Json view(std::string_view bytes) {
        binary.resize((binary.size() + 3) / 4 * 4);
        json["bufferViews"].push_back(
            {{"buffer", 0}, {"byteOffset", binary.size()}, {"byteLength", bytes.size()}});
        binary += bytes;
        return json["bufferViews"].size() - 1;
    }
    template <class Number>
    Json accessor(const Matrix& values, int component, bool bounds = false) {
        std::string bytes;
        for (Eigen::Index i = 0; i < values.size(); ++i)
            io::append_number(bytes, static_cast<Number>(values(i / values.cols(), i % values.cols())));
        const std::map<Eigen::Index, const char*> types = {
            {1, "SCALAR"}, {2, "VEC2"}, {3, "VEC3"}, {4, "VEC4"}, {16, "MAT4"}};
        Json accessor = {{"bufferView", view(bytes)},
                         {"componentType", component},
                         {"count", values.rows()},
                         {"type", types.at(values.cols())}};
        for (Eigen::Index c = 0; bounds && c < values.cols(); ++c) {
            accessor["min"].push_back(values.col(c).minCoeff());
            accessor["max"].push_back(values.col(c).maxCoeff());
        }
        json["accessors"].push_back(accessor);
        return json["accessors"].size() - 1;
    }
    Json floats(const Matrix& values, bool bounds = false) { return accessor<float>(values, 5126, bounds); }

    std::string bytes() {
        json["buffers"] = {{{"byteLength", binary.size()}}};
        std::string text = json.dump(), file = "glTF";
        text.resize((text.size() + 3) / 4 * 4, ' ');
        binary.resize((binary.size() + 3) / 4 * 4, '\0');
        io::append_number(file, std::uint32_t{2});
        io::append_number(file, static_cast<std::uint32_t>(28 + text.size() + binary.size()));
        io::append_number(file, static_cast<std::uint32_t>(text.size()));
        file += "JSON" + text;
        io::append_number(file, static_cast<std::uint32_t>(binary.size()));
        return file + std::string("BIN\0", 4) + binary;
    }
};

Matrix colors_at_vertices(const AttributedMesh& content) {
    const CornerAttribute& colors = content.colors.at(0);
    Matrix values(content.mesh.n_vertices(), colors.values.cols());
    for (Index t = 0; t < content.mesh.n_triangles(); ++t)
        for (int c = 0; c < 3; ++c)
            values.row(content.mesh.triangles(t, c)) = colors.values.row(colors.corners(t, c));
    return values;
}

// A checkerboard that is red in front and blue behind.
std::string texture_png() {
    constexpr int size = 64;
    render::Image image(size, size, render::Color(0.9, 0.3, 0.3));
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const double green = (x / 4 + y / 4) % 2 == 0 ? 0.6 : 0.3;
            image.set(x, y, x < size / 2 ? render::Color(0.9, green, 0.3) : render::Color(0.3, green, 0.9));
        }
    }
    return render::encode_png(image);
}

void add_material(Glb& glb) {
    glb.json["images"] = {{{"bufferView", glb.view(texture_png())}, {"mimeType", "image/png"}}};
    glb.json["samplers"] = {{{"magFilter", 9729}, {"minFilter", 9729}}};
    glb.json["textures"] = {{{"sampler", 0}, {"source", 0}}};
    glb.json["materials"] = {
        {{"name", "skin"},
         {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}, {"metallicFactor", 0}}}}};
}

void add_skeleton(Glb& glb, const std::vector<Joint>& joints) {
    Matrix inverse_binds(static_cast<Eigen::Index>(joints.size()), 16);
    Json numbers = Json::array();
    for (std::size_t j = 0; j < joints.size(); ++j) {
        const Joint& joint = joints[j];
        Eigen::Matrix4d inverse = Eigen::Matrix4d::Identity();
        inverse.topRightCorner<3, 1>() = -joint.position.transpose();
        inverse_binds.row(static_cast<Eigen::Index>(j)) =
            Eigen::Map<const Eigen::RowVectorXd>(inverse.data(), 16);
        Eigen::RowVector3d offset = joint.position;
        if (joint.parent >= 0) offset -= joints[static_cast<std::size_t>(joint.parent)].position;
        glb.json["nodes"].push_back(
            {{"name", joint.name}, {"translation", {offset[0], offset[1], offset[2]}}});
        if (joint.parent >= 0)
            glb.json["nodes"][static_cast<std::size_t>(joint.parent) + 1]["children"].push_back(j + 1);
        numbers.push_back(j + 1);
    }
    glb.json["skins"] = {
        {{"inverseBindMatrices", glb.floats(inverse_binds)}, {"joints", numbers}, {"skeleton", 1}}};
}

void add_wave(Glb& glb) {
    Matrix times(3, 1), turns(3, 4);
    times << 0, 0.5, 1;
    turns << 0, 0, 0, 1, 0, 0, 0.5, 0.75, 0, 0, 0, 1;
    turns.rowwise().normalize();
    glb.json["animations"] = {
        {{"name", "wave"},
         {"channels", {{{"sampler", 0}, {"target", {{"node", 4}, {"path", "rotation"}}}}}},
         {"samplers", {{{"input", glb.floats(times, true)}, {"output", glb.floats(turns)}}}}}};
}

// What is attached to the vertices of the file.
void add_attributes(Glb& glb, Json& primitive, const AttributedMesh& content, const SplitVertices& file) {
    Json& attributes = primitive["attributes"];
    attributes["TEXCOORD_0"] = glb.floats(content.texture_coordinates[0].values(file.row, Eigen::all));
    // Colors are smooth: one for each vertex.
    attributes["COLOR_0"] = glb.floats(colors_at_vertices(content)(file.vertex, Eigen::all));
    const Matrix joints = content.skin.joints(file.vertex, Eigen::all).cast<double>();
    attributes["JOINTS_0"] = glb.accessor<std::uint8_t>(joints, 5121);
    attributes["WEIGHTS_0"] = glb.floats(content.skin.weights(file.vertex, Eigen::all));
    for (const MorphTarget& morph : content.morphs)
        primitive["targets"].push_back(
            {{"POSITION", glb.floats(morph.displacements(file.vertex, Eigen::all), true)}});
    primitive["material"] = 0;
}

}  // namespace

std::string character_glb(const Character& character, const CharacterExport& options) {
    const AttributedMesh& content = character.content;
    const SplitVertices file = split(content, options);
    Glb glb;
    Json primitive;
    primitive["attributes"]["POSITION"] = glb.floats(content.mesh.vertices(file.vertex, Eigen::all), true);
    if (options.with_normals && !options.bare)
        primitive["attributes"]["NORMAL"] = glb.floats(vertex_normals(content.mesh)(file.vertex, Eigen::all));
    if (!options.bare) add_attributes(glb, primitive, content, file);
    const Matrix indices = Eigen::Map<const Eigen::Matrix<Index, Eigen::Dynamic, 1>>(
                               file.corners.data(), static_cast<Eigen::Index>(file.corners.size()))
                               .cast<double>();
    primitive["indices"] = glb.accessor<std::uint32_t>(indices, 5125);
    glb.json["meshes"] = {{{"name", "body"}, {"primitives", {primitive}}}};
    glb.json["nodes"] = {{{"name", "character"}, {"mesh", 0}}};
    glb.json["scenes"] = {{{"nodes", {0}}}};
    if (options.bare) return glb.bytes();
    Json& mesh = glb.json["meshes"][0];
    for (const MorphTarget& morph : content.morphs) {
        mesh["weights"].push_back(0);
        mesh["extras"]["targetNames"].push_back(morph.name);
    }
    glb.json["nodes"][0]["skin"] = 0;
    glb.json["scenes"][0]["nodes"].push_back(1);
    add_skeleton(glb, character.joints);
    add_material(glb);
    add_wave(glb);
    return glb.bytes();
}

}  // namespace counterpart::test
