// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "io/gltf_store.hpp"

#include <counterpart/base/errors.hpp>

#include <algorithm>
#include <set>

#include <fmt/format.h>

namespace counterpart::io {
namespace {

// Equal, not-a-number being itself, where columns that `stored` has not got hold `filler`.
bool equal(const Matrix& stored, const Matrix& wanted, double filler) {
    if (stored.rows() != wanted.rows() || stored.cols() > wanted.cols()) return false;
    const auto common = wanted.leftCols(stored.cols()).array();
    return (stored.array() == common || (stored.array().isNaN() && common.isNaN())).all() &&
           (wanted.rightCols(wanted.cols() - stored.cols()).array() == filler).all();
}

bool equal(const SkinBinding& stored, const SkinBinding& wanted) {
    if (!equal(stored.weights, wanted.weights, 0)) return false;
    const auto joints = wanted.joints.leftCols(stored.joints.cols()).array();
    return (stored.joints.array() == joints || stored.weights.array() == 0).all();
}

// Back from the scene's space into the mesh's.
void take_out_of_place(GltfPrimitive& primitive, const Eigen::Affine3d& placement) {
    primitive.placement = placement;
    if (placement.matrix() == Eigen::Matrix4d::Identity()) return;
    const Eigen::Matrix3d linear = placement.linear();
    if (linear.determinant() == 0)
        throw InvalidInput("a node scales the mesh to nothing, so that it cannot be changed");
    const Eigen::Affine3d inverse = placement.inverse();
    primitive.positions =
        (primitive.positions * inverse.linear().transpose()).rowwise() + inverse.translation().transpose();
    for (Points& displacement : primitive.displacements)
        displacement = (displacement * inverse.linear().transpose()).eval();
    if (primitive.normals.rows() > 0) primitive.normals = (primitive.normals * linear).rowwise().normalized();
    if (linear.determinant() < 0) primitive.turn_over();
}

class PrimitiveStore {
  public:
    PrimitiveStore(GltfDocument& document, const GltfPrimitive& stored, const GltfPrimitive& wanted,
                   bool same_vertices)
        : document_(document),
          stored_(stored),
          wanted_(wanted),
          local_(wanted),
          same_vertices_(same_vertices) {
        take_out_of_place(local_, stored.placement);
    }

    void run() {
        if (!same_vertices_) drop_unknown_attributes();
        const bool moved = !equal(stored_.positions, wanted_.positions, 0);
        if (moved) put("POSITION", local_.positions, true);
        store_triangles();
        bool redirected = moved;
        if (!equal(stored_.normals, wanted_.normals, 0)) {
            put_or_erase("NORMAL", local_.normals);
            redirected = true;
        }
        redirected |= store_sets("TEXCOORD", stored_.texture_coordinates, wanted_.texture_coordinates);
        store_sets("COLOR", stored_.colors, wanted_.colors);
        if (redirected) json()["attributes"].erase("TANGENT");
        store_skin();
        store_morphs();
        if (changed_ && json().contains("extensions")) {
            // A compressed copy of what was replaced.
            json()["extensions"].erase("KHR_draco_mesh_compression");
            if (json()["extensions"].empty()) json().erase("extensions");
        }
    }

  private:
    // Not kept: appending to other lists may move it.
    GltfJson& json() { return document_.json["meshes"][stored_.mesh]["primitives"][stored_.number]; }

    std::int64_t append(const std::string& what, const Matrix& values, bool bounds = false) {
        if (!values.allFinite()) throw InvalidInput(fmt::format("a value of {} is not finite", what));
        changed_ = true;
        return append_accessor(document_, values, GltfComponent::f32, GltfTarget::vertices, bounds);
    }
    void put(const std::string& name, const Matrix& values, bool bounds = false) {
        const std::int64_t accessor = append(name, values, bounds);
        json()["attributes"][name] = accessor;
    }
    void put_or_erase(const std::string& name, const Matrix& values) {
        if (values.rows() > 0)
            put(name, values);
        else
            json()["attributes"].erase(name);
    }

    void drop_unknown_attributes() {
        static const std::set<std::string> known = {"POSITION", "NORMAL"};
        std::vector<std::string> dropped;
        for (const auto& [name, accessor] : json()["attributes"].items()) {
            const std::string set = name.substr(0, name.find('_'));
            if (!known.contains(name) &&
                (name.front() == '_' || name == "TANGENT" ||
                 (set != "TEXCOORD" && set != "COLOR" && set != "JOINTS" && set != "WEIGHTS")))
                dropped.push_back(name);
        }
        for (const std::string& name : dropped) json()["attributes"].erase(name);
    }

    void store_triangles() {
        if (stored_.triangles.rows() == wanted_.triangles.rows() && stored_.triangles == wanted_.triangles)
            return;
        const Eigen::Index n = wanted_.positions.rows();
        const Matrix list = Eigen::Map<const Eigen::Matrix<Index, Eigen::Dynamic, 1>>(local_.triangles.data(),
                                                                                      local_.triangles.size())
                                .cast<double>();
        json()["indices"] = append_accessor(
            document_, list, n < 65535 ? GltfComponent::u16 : GltfComponent::u32, GltfTarget::indices);
        json().erase("mode");
        changed_ = true;
    }

    bool store_sets(const std::string& name, const std::vector<Matrix>& stored,
                    const std::vector<Matrix>& wanted) {
        bool any = false;
        for (std::size_t i = 0; i < std::max(stored.size(), wanted.size()); ++i) {
            const Matrix none;
            const Matrix& before = i < stored.size() ? stored[i] : none;
            const Matrix& after = i < wanted.size() ? wanted[i] : none;
            if (equal(before, after, 1)) continue;
            put_or_erase(fmt::format("{}_{}", name, i), after);
            any = true;
        }
        return any;
    }

    void store_skin() {
        const SkinBinding& stored = stored_.skin;
        const SkinBinding& wanted = wanted_.skin;
        if (equal(stored, wanted)) return;
        for (Eigen::Index set = 0; 4 * set < stored.joints.cols(); ++set) {
            json()["attributes"].erase(fmt::format("JOINTS_{}", set));
            json()["attributes"].erase(fmt::format("WEIGHTS_{}", set));
        }
        if (wanted.weights.size() == 0 || wanted.weights.isZero(0)) return;
        for (Eigen::Index v = 0; v < wanted.weights.rows(); ++v) {
            if (!(wanted.weights.row(v).sum() > 0)) {
                throw InvalidInput(fmt::format(
                    "the skin weights of the vertex at ({:.6g}, {:.6g}, {:.6g}) sum to zero: give it a joint",
                    wanted_.positions(v, 0), wanted_.positions(v, 1), wanted_.positions(v, 2)));
            }
        }
        Eigen::Index used = wanted.weights.cols();
        while (used > 1 && wanted.weights.col(used - 1).isZero(0)) --used;
        for (Eigen::Index set = 0; 4 * set < used; ++set) {
            const Eigen::Index columns = std::min<Eigen::Index>(4, used - 4 * set);
            Matrix joints = Matrix::Zero(wanted.joints.rows(), 4), weights = joints;
            weights.leftCols(columns) = wanted.weights.middleCols(4 * set, columns);
            joints.leftCols(columns) = wanted.joints.middleCols(4 * set, columns).cast<double>();
            joints = (weights.array() != 0).select(joints, 0);
            const bool small = joints.maxCoeff() < 256;
            const std::int64_t accessor = append_accessor(
                document_, joints, small ? GltfComponent::u8 : GltfComponent::u16, GltfTarget::vertices);
            json()["attributes"][fmt::format("JOINTS_{}", set)] = accessor;
            put(fmt::format("WEIGHTS_{}", set), weights);
        }
    }

    void store_morphs() {
        if (wanted_.displacements.empty()) {
            json().erase("targets");
            return;
        }
        GltfJson targets = GltfJson::array();
        for (std::size_t i = 0; i < wanted_.displacements.size(); ++i) {
            if (i < stored_.displacements.size() && same_vertices_ &&
                stored_.displacements[i] == wanted_.displacements[i])
                targets.push_back(json()["targets"][i]);
            else
                targets.push_back(
                    {{"POSITION", append(fmt::format("morph target {}", i), local_.displacements[i], true)}});
        }
        json()["targets"] = std::move(targets);
    }

    GltfDocument& document_;
    const GltfPrimitive& stored_;
    const GltfPrimitive& wanted_;
    GltfPrimitive local_;
    bool same_vertices_, changed_ = false;
};

}  // namespace

void store_primitive(GltfDocument& document, const GltfPrimitive& stored, const GltfPrimitive& wanted,
                     bool same_vertices) {
    PrimitiveStore(document, stored, wanted, same_vertices).run();
}

}  // namespace counterpart::io
