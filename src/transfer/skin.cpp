// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "mesh/harmonic_fill.hpp"
#include "transfer/attributes.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/mesh/adjacency.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include <fmt/format.h>

namespace counterpart::attributes {
namespace {

struct Influence {
    Index joint;
    double weight;
};
using Influences = std::vector<Influence>;  // of one vertex, by joint

// Whether each source vertex is bound to a joint; throws for weights that mean nothing.
std::vector<char> bound_vertices(MeshView source, const SkinBinding& skin) {
    if (skin.weights.rows() != source.n_vertices() || skin.joints.rows() != source.n_vertices() ||
        skin.joints.cols() != skin.weights.cols()) {
        throw InvalidInput(fmt::format("the skin has {} rows of joints and {} of weights for {} vertices",
                                       skin.joints.rows(), skin.weights.rows(), source.n_vertices()));
    }
    const Components components = connected_components(Adjacency(source));
    std::vector<char> bound(static_cast<std::size_t>(source.n_vertices()));
    std::vector<char> component_bound(static_cast<std::size_t>(components.count), 0);
    for (Index v = 0; v < source.n_vertices(); ++v) {
        const auto row = skin.weights.row(v);
        if (!row.allFinite() || (row.array() < 0).any())
            throw InvalidInput(fmt::format("a skin weight of source vertex {} is negative or not finite", v));
        if ((skin.joints.row(v).array() < 0).any())
            throw InvalidInput(fmt::format("source vertex {} is bound to a joint with a negative number", v));
        if (!(row.sum() > 0)) continue;
        bound[static_cast<std::size_t>(v)] = 1;
        component_bound[static_cast<std::size_t>(components.of_vertex[static_cast<std::size_t>(v)])] = 1;
    }
    for (std::size_t v = 0; v < bound.size(); ++v) {
        if (!bound[v] && component_bound[static_cast<std::size_t>(components.of_vertex[v])]) {
            throw InvalidInput(
                fmt::format("the skin weights of source vertex {} sum to zero although the "
                            "component it belongs to is bound to joints: give it a joint",
                            v));
        }
    }
    return bound;
}

Influences interpolated(const SurfacePoint& point, MeshView source, const SkinBinding& skin) {
    Influences sum;
    for (int c = 0; c < 3; ++c) {
        if (!(point.weights[c] > 0)) continue;
        const Index v = source.triangles(point.triangle, c);
        const double total = skin.weights.row(v).sum();
        for (Eigen::Index k = 0; k < skin.joints.cols() && total > 0; ++k)
            if (skin.weights(v, k) > 0)
                sum.push_back({skin.joints(v, k), point.weights[c] * skin.weights(v, k) / total});
    }
    std::stable_sort(sum.begin(), sum.end(),
                     [](const Influence& a, const Influence& b) { return a.joint < b.joint; });
    std::size_t kept = 0;
    for (std::size_t i = 0; i < sum.size(); ++i) {
        if (kept > 0 && sum[kept - 1].joint == sum[i].joint)
            sum[kept - 1].weight += sum[i].weight;
        else
            sum[kept++] = sum[i];
    }
    sum.resize(kept);
    return sum;
}

// The heaviest `limit` ones first, of sum 1.
Influences limited(Influences all, std::size_t limit) {
    std::stable_sort(all.begin(), all.end(),
                     [](const Influence& a, const Influence& b) { return a.weight > b.weight; });
    all.resize(std::min(all.size(), limit));
    double sum = 0;
    for (const Influence& one : all) sum += one.weight;
    for (Influence& one : all) one.weight /= sum;
    return all;
}

// Fills the vertices without a match from those around them. Returns what it found about them.
mesh::FillResult fill(const SurfaceMap& map, MeshView target, std::vector<Influences>& influences) {
    std::map<Index, Index> column;  // of the joints in use
    for (const Influences& all : influences)
        for (const Influence& one : all) column.emplace(one.joint, 0);
    std::vector<Index> joints;
    for (auto& [joint, place] : column) {
        place = static_cast<Index>(joints.size());
        joints.push_back(joint);
    }
    // A column more, so that vertices without any joint still are known.
    Matrix dense = Matrix::Zero(target.n_vertices(), static_cast<Eigen::Index>(joints.size()) + 1);
    for (Index v = 0; v < target.n_vertices(); ++v) {
        if (!map[v].matched()) dense.row(v).setConstant(std::numeric_limits<double>::quiet_NaN());
        for (const Influence& one : influences[static_cast<std::size_t>(v)])
            dense(v, column[one.joint]) = one.weight;
    }
    mesh::FillResult result = mesh::fill_everywhere(target, dense);
    constexpr double negligible = 1e-6;
    for (Index v = 0; v < target.n_vertices(); ++v) {
        if (map[v].matched()) continue;
        for (std::size_t j = 0; j < joints.size(); ++j) {
            const double weight = result.values(v, static_cast<Eigen::Index>(j));
            if (weight > negligible) influences[static_cast<std::size_t>(v)].push_back({joints[j], weight});
        }
    }
    return result;
}

}  // namespace

TransferredSkin transfer_skin(const SurfaceMap& source_from_target, MeshView source, MeshView target,
                              const SkinBinding& skin, const TransferSkinOptions& options) {
    require_valid(source_from_target, target.n_vertices(), source.n_triangles());
    if (options.max_influences < 0 || options.max_influences > 64)
        throw InvalidInput(fmt::format("max_influences must be in 0 .. 64, not {}", options.max_influences));
    const std::vector<char> bound = bound_vertices(source, skin);
    const Eigen::Index limit = options.max_influences > 0 ? options.max_influences : skin.weights.cols();

    std::vector<Influences> influences(source_from_target.image.size());
    for (std::size_t v = 0; v < influences.size(); ++v) {
        if (source_from_target.image[v].matched())
            influences[v] = interpolated(source_from_target.image[v], source, skin);
    }
    TransferredSkin result;
    result.coverage.transferred = count_matched(source_from_target);
    if (result.coverage.transferred == 0) throw InvalidInput("the map matches no vertex");
    if (result.coverage.transferred < target.n_vertices()) {
        const mesh::FillResult filled = fill(source_from_target, target, influences);
        result.coverage.filled = filled.filled;
        result.coverage.guessed = filled.unknown;
    }
    result.skin.joints.setZero(target.n_vertices(), limit);
    result.skin.weights.setZero(target.n_vertices(), limit);
    for (Index v = 0; v < target.n_vertices(); ++v) {
        const Influences& all = influences[static_cast<std::size_t>(v)];
        const SurfacePoint& point = source_from_target[v];
        Eigen::Index corner = 0;
        const bool at_vertex = point.matched() && point.weights.maxCoeff(&corner) == 1;
        if (all.empty()) ++result.unbound;
        if (static_cast<Eigen::Index>(all.size()) > limit) ++result.limited;
        if (at_vertex && skin.weights.cols() <= limit) {
            const Index from = source.triangles(point.triangle, corner);
            result.skin.joints.row(v).head(skin.joints.cols()) = skin.joints.row(from);
            result.skin.weights.row(v).head(skin.weights.cols()) = skin.weights.row(from);
            continue;
        }
        Eigen::Index k = 0;
        for (const Influence& one : limited(all, static_cast<std::size_t>(limit))) {
            result.skin.joints(v, k) = one.joint;
            result.skin.weights(v, k++) = one.weight;
        }
    }
    return result;
}

}  // namespace counterpart::attributes
