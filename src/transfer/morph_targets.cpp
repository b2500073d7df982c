// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "mesh/harmonic_fill.hpp"
#include "transfer/attributes.hpp"
#include "transfer/local_linear_maps.hpp"

#include <counterpart/base/errors.hpp>

#include <fmt/format.h>

namespace counterpart::attributes {

TransferredMorphTargets transfer_morph_targets(const SurfaceMap& source_from_target, MeshView source,
                                               MeshView target, const std::vector<MorphTarget>& morphs) {
    require_valid(source_from_target, target.n_vertices(), source.n_triangles());
    for (const MorphTarget& morph : morphs) {
        if (morph.displacements.rows() != source.n_vertices()) {
            throw InvalidInput(fmt::format("morph '{}' moves {} vertices, but the source has {}", morph.name,
                                           morph.displacements.rows(), source.n_vertices()));
        }
        if (!morph.displacements.allFinite())
            throw InvalidInput(fmt::format("morph '{}' holds a number that is not finite", morph.name));
    }
    TransferredMorphTargets result{{}, {.transferred = count_matched(source_from_target)}};
    if (result.coverage.transferred == 0) throw InvalidInput("the map matches no vertex");
    if (morphs.empty()) return result;
    const std::vector<Eigen::Matrix3d> maps = morphing::local_linear_maps(source_from_target, source, target);

    // All morphs side by side, so that one factorization fills them all.
    Matrix moved(target.n_vertices(), 3 * static_cast<Eigen::Index>(morphs.size()));
    for (std::size_t i = 0; i < morphs.size(); ++i) {
        auto columns = moved.middleCols<3>(3 * static_cast<Eigen::Index>(i));
        // Not in place: for WebAssembly clang 14 stores some products before it has loaded all factors.
        const Matrix taken = transfer_values(source_from_target, source, morphs[i].displacements);
        for (Index v = 0; v < target.n_vertices(); ++v)
            columns.row(v) = taken.row(v) * maps[static_cast<std::size_t>(v)].transpose();
    }
    if (result.coverage.transferred < target.n_vertices()) {
        const mesh::FillResult filled = mesh::fill_from_neighbors(Adjacency(target), moved);
        result.coverage.filled = filled.filled;
        result.coverage.guessed = filled.unknown;
        moved = filled.values.array().isNaN().select(0, filled.values);
    }
    for (std::size_t i = 0; i < morphs.size(); ++i)
        result.morphs.push_back({morphs[i].name, moved.middleCols<3>(3 * static_cast<Eigen::Index>(i))});
    return result;
}

}  // namespace counterpart::attributes
