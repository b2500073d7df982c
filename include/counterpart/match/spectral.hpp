// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/progress.hpp>
#include <counterpart/map/vertex_map.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace counterpart {

namespace spectral_match {
struct Shape;
}

struct SpectralShapeOptions {
    int basis_size = 200;  ///< Laplace eigenfunctions, 30 .. 500
    int n_samples = 1000;  ///< farthest-point samples that maps are searched on, 200 .. 5000
    /// 0: sampling begins at the vertex farthest from the centre; else at one drawn from this seed. Good maps
    /// hardly depend on it, so that a map that changes is a doubtful one.
    std::uint64_t seed = 0;
    int n_threads = 0;  ///< 0 = all; the result does not depend on it
};

/// What is computed for one mesh before the other is known, kept for matching it with many. Cheap to copy.
class SpectralShape {
  public:
    /// Throws InvalidInput for invalid meshes, without area or with fewer than 20 vertices at different
    /// places, and for options out of range.
    explicit SpectralShape(const TriangleMesh& mesh, const SpectralShapeOptions& options = {});

    const spectral_match::Shape& data() const { return *data_; }

  private:
    std::shared_ptr<const spectral_match::Shape> data_;
};

struct SpectralOptions {
    /// Pairs (source vertex, target vertex) that are known; at least 3 replace the automatic search.
    std::vector<std::pair<Index, Index>> landmarks{};
    /// Return the mirrored map on purpose: left to right.
    bool symmetric = false;
    int n_alternatives = 3;  ///< how many runners-up are reported, 0 .. 10
    int n_threads = 0;       ///< 0 = all; the result does not depend on it
    Progress progress{};
};

/// Another map that was considered.
struct SpectralAlternative {
    VertexMap target_from_source;
    double score = 0;
    std::string description;  ///< how it differs from the best map: mirrored, turned, another limb
};

struct SpectralResult {
    VertexMap target_from_source, source_from_target;
    Vector confidence;  ///< per source vertex, in [0, 1]; 0 for those that only follow another
    double score = 0;   ///< of the best map, comparable with those of the alternatives
    double margin = 0;  ///< its distance to the best alternative's score; infinite if there is none
    std::vector<SpectralAlternative> alternatives;  ///< best first
    std::vector<std::string> warnings;              ///< sentences: what may be wrong, and what to do
    std::vector<StageTime> stages;
};

/// Automatic dense correspondence of two surfaces of different connectivity, near-isometric and alike in
/// shape: extremities are matched by geodesic distances, the maps they start are grown through the
/// eigenfunctions of the Laplacian (bijective ZoomOut), judged by curvature, orientation, orthogonality and
/// local rigidity, and the best is refined to all vertices. Independent of pose, position, scale and
/// numbering. Every source vertex is matched. docs/spectral.md tells the method. Throws InvalidInput as
/// SpectralShape, and for landmarks out of range.
SpectralResult match_spectral(const TriangleMesh& source, const TriangleMesh& target,
                              const SpectralOptions& options = {},
                              const SpectralShapeOptions& shape_options = {});
SpectralResult match_spectral(const SpectralShape& source, const SpectralShape& target,
                              const SpectralOptions& options = {});

}  // namespace counterpart
