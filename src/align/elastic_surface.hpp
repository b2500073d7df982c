// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "align/elastic_fit.hpp"

#include <counterpart/mesh/triangle_mesh.hpp>

#include <vector>

namespace counterpart::align {

/// A surface that keeps the shape of its neighborhoods up to a rotation and a bounded scale for each (Sorkine
/// and Alexa 2007) while it is drawn to given positions.
class ElasticSurface {
  public:
    explicit ElasticSurface(MeshView rest);

    /// Lowers sum w_ij |(x_i - x_j) - s_i R_i (rest_i - rest_j)|^2 + pull_i |x_i - towards_i|^2 in `rounds`
    /// alternations of similarities and positions, from x = `start`; w are cotangent weights. A pull of
    /// area_i / L^2 is followed on features longer than about L. Rows of `towards` whose pull is 0 do not
    /// count; components without any pull stay with what is near them. Vertices marked in `spoiled`, one
    /// entry each or empty, turn as their surroundings do, not as they are.
    Points drawn(PointsView towards, const Vector& pull, PointsView start, int rounds,
                 const std::vector<char>& spoiled = {});

  private:
    ElasticFit fit_;
};

}  // namespace counterpart::align
