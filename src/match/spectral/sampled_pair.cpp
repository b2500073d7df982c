// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/sampled_pair.hpp"

#include <algorithm>

namespace counterpart::spectral_match {

SampledPair::SampledPair(const PreparedShape& shape_a, const PreparedShape& shape_b, std::size_t n,
                         const Priors& known)
    : a(shape_a), b(shape_b), priors(known), points_a(sampled(shape_a, n)), points_b(sampled(shape_b, n)) {}

MatrixF sample_positions(const PreparedShape& shape, Index n) {
    MatrixF positions(n, 3);
    for (Index s = 0; s < n; ++s)
        positions.row(s) = shape.mesh.vertices.row(shape.samples[at(s)]).cast<float>();
    return positions;
}

std::vector<std::vector<Index>> neighborhoods(const PreparedShape& shape, std::size_t n, double radius) {
    n = std::min(n, shape.samples.size());
    std::vector<std::vector<Index>> result(std::min(at(shape.sample_distances.rows()), n));
    for (std::size_t center = 0; center < result.size(); ++center)
        for (std::size_t s = 0; s < n; ++s)
            if (shape.sample_distances(static_cast<Eigen::Index>(center), shape.samples[s]) < radius)
                result[center].push_back(static_cast<Index>(s));
    return result;
}

}  // namespace counterpart::spectral_match
