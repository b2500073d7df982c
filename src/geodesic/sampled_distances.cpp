// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include <counterpart/geodesic/farthest_points.hpp>

#include <limits>
#include <utility>

namespace counterpart {

SampledDistances::SampledDistances(const DistanceGraph& graph, FarthestPointSamples bases,
                                   const DistanceOptions& options)
    : bases_(std::move(bases)),
      rows_(distance_rows(graph, bases_.vertices, options)),
      number_of_sample_(static_cast<std::size_t>(graph.n_vertices()), -1) {
    for (std::size_t i = 0; i < bases_.vertices.size(); ++i)
        number_of_sample_[static_cast<std::size_t>(bases_.vertices[i])] = static_cast<Index>(i);
}

double SampledDistances::operator()(Index a, Index b) const {
    const Index base_a = number_of_sample_[static_cast<std::size_t>(a)];
    if (base_a >= 0) return rows_(base_a, b);
    const Index base_b = number_of_sample_[static_cast<std::size_t>(b)];
    if (base_b >= 0) return rows_(base_b, a);
    const Index nearest_a = bases_.sample_of_vertex[static_cast<std::size_t>(a)];
    const Index nearest_b = bases_.sample_of_vertex[static_cast<std::size_t>(b)];
    if (nearest_a < 0 || nearest_b < 0) return std::numeric_limits<double>::infinity();
    return rows_(nearest_a, bases_.vertices[static_cast<std::size_t>(nearest_b)]);
}

Matrix SampledDistances::matrix() const {
    Matrix all(rows_.cols(), rows_.cols());
    for (Index a = 0; a < static_cast<Index>(all.rows()); ++a)
        for (Index b = 0; b < static_cast<Index>(all.cols()); ++b) all(a, b) = (*this)(a, b);
    return all;
}

}  // namespace counterpart
