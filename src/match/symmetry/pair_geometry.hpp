// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// How well pairs of components agree in shape and place.
#pragma once

#include "match/isomorphism/component_classes.hpp"
#include "match/symmetry/alignment.hpp"

#include <counterpart/mesh/triangle_mesh.hpp>

#include <limits>
#include <vector>

namespace counterpart::symmetry {

using isomorphism::AutomorphismGroup;
using isomorphism::ComponentClass;
using isomorphism::Dart;
using isomorphism::DartMap;
using isomorphism::Images;
using isomorphism::Member;

/// Two meshes, their connectivity, and what components they have in common.
struct MatchedMaps {
    MeshView source_mesh;
    MeshView target_mesh;
    const DartMap& source;
    const DartMap& target;
    const std::vector<ComponentClass>& classes;
    const std::vector<AutomorphismGroup>& groups;  ///< of each class; of those in both meshes
};

/// A component of the source on a component of the target, by one automorphism of their representative.
struct ComponentPair {
    const ComponentClass* kind = nullptr;
    const Member* source = nullptr;
    const Member* target = nullptr;
    Images automorphism;  ///< of the representative; empty = identity
    double other_length_error = std::numeric_limits<double>::infinity();  ///< by the next best automorphism

    std::size_t size() const { return source->from_representative.size(); }
    /// Where corner 0 of the representative's triangle lies on the source and on the target.
    Dart on_source(std::size_t triangle) const { return source->from_representative[triangle]; }
    Dart on_target(std::size_t triangle) const {
        return automorphism.empty()
                   ? target->from_representative[triangle]
                   : isomorphism::image_of(target->from_representative, kind->first, automorphism[triangle]);
    }
};

/// Mean squares, in the target's units.
struct Fit {
    double edge_length_error = 0;  ///< after scaling to the target's mean edge length: no pose matters
    double rigid_error = 0;        ///< distance after the alignment
    double offset = 0;             ///< distance as the meshes lie
};

class PairGeometry {
  public:
    explicit PairGeometry(const MatchedMaps& maps);

    /// The square of a length that is rounding.
    double tolerance() const { return tolerance_; }
    double edge_length_error(Dart source, Dart target) const;  ///< of one triangle
    double edge_length_error(const ComponentPair& pair, std::size_t max_triangles) const;
    /// The corners of one triangle, given where its corner 0 lies on both sides.
    void add_points(Dart source, Dart target, std::vector<PointPair>& points) const;
    std::vector<PointPair> points(const ComponentPair& pair, std::size_t max_triangles) const;

    /// Whether `a` is better: edge lengths decide; where they tie, the rigid error; where that ties too, the
    /// offset, so that a symmetric mesh that did not move is matched as it lies.
    bool is_better(const Fit& a, const Fit& b) const;
    /// The largest value that ties with `value`.
    double tie(double value) const;

  private:
    Eigen::RowVector3d on_source(Dart d) const;
    Eigen::RowVector3d on_target(Dart d) const;

    const MatchedMaps& maps_;
    double length_scale_ = 1, tolerance_ = 0;
};

/// At most `max` of 0 .. size - 1, evenly spread.
std::vector<std::size_t> evenly_spread(std::size_t size, std::size_t max);

/// What automorphisms are judged by beside lengths.
struct Frame {
    const Alignment* alignment = nullptr;  ///< the rigid error is taken after it; null: after the best one
    bool is_around = false;  ///< it is that of what is around: then lengths decide only where they are clear
};

/// The automorphisms of the pair's representative (the orientation-reversing ones if `reversed`), best first
/// as in PairGeometry::is_better, at most `count`. `traversal`: of the source with itself.
std::vector<Images> best_automorphisms(const MatchedMaps& maps, const PairGeometry& geometry,
                                       isomorphism::SimultaneousTraversal& traversal,
                                       const ComponentPair& pair, bool reversed, const Frame& frame,
                                       std::size_t count);

}  // namespace counterpart::symmetry
