// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/geodesic/distances.hpp>

#include <vector>

namespace counterpart {

/// Sampling ends when either bound is reached; at least one must be given.
struct FarthestPointOptions {
    Index count = 0;  ///< at most this many; 0 = no bound
    /// Until no reachable vertex is farther than this from its sample, mesh units; 0 = no bound.
    double radius = 0;
    Index first = -1;  ///< the first sample; -1 = the vertex farthest from the center of the surface
    Progress progress{};
};

/// Evenly spread samples of a mesh's vertices, and the cells of vertices nearest to each.
struct FarthestPointSamples {
    std::vector<Index> vertices;  ///< in the order they were taken: each prefix is a coarser sample
    /// For each vertex of the mesh its nearest sample, as an index into `vertices` (the smallest of equally
    /// near ones); -1 in a component without samples.
    std::vector<Index> sample_of_vertex;
    Vector distance_to_sample;  ///< per vertex, mesh units; infinite in a component without samples
    /// Greatest distance from a vertex to its sample, over the components with samples.
    double covering_radius = 0;
};

/// Farthest-point sampling by graph distances, which spreads samples as evenly as the base vertices of Hilaga
/// et al. 2001: begin anywhere, then repeatedly take the vertex farthest from all samples; of equally far
/// ones the smallest. Components without a sample come first, in decreasing order of vertices, each beginning
/// at its vertex farthest from the center of the surface. Samples are more than `radius` apart, and no vertex
/// is farther than that from one.
///
/// A new sample only searches the region it takes over: O(V log count) for the searches; the choice is at
/// most O(V count), and far less where neighbors have similar numbers. Throws InvalidInput for a graph of
/// another mesh, no bound, a negative one, or a `first` that is not a vertex.
FarthestPointSamples farthest_point_samples(MeshView mesh, const DistanceGraph& graph,
                                            const FarthestPointOptions& options);

/// Distances between any two vertices, approximated from searches of a few (Sahillioglu and Yemez, section 3,
/// where samples are called base vertices): exact on the graph if one of the two is a sample, otherwise the
/// distance between their nearest samples. Accurate for far pairs, useless for near ones: the distance within
/// a cell is 0. Infinite between components, and in components without a sample. Memory: 8 bytes times
/// samples times vertices.
class SampledDistances {
  public:
    SampledDistances(const DistanceGraph& graph, FarthestPointSamples bases,
                     const DistanceOptions& options = {});

    double operator()(Index a, Index b) const;
    /// The whole V x V geodesic proximity matrix, 8 V^2 bytes.
    Matrix matrix() const;
    const FarthestPointSamples& bases() const { return bases_; }

  private:
    FarthestPointSamples bases_;
    Matrix rows_;                          // bases x V
    std::vector<Index> number_of_sample_;  // by vertex; -1 for others
};

}  // namespace counterpart
