// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/spectral/candidate.hpp"
#include "match/spectral/cells.hpp"
#include "match/spectral/surface_distance.hpp"

#include <counterpart/mesh/adjacency.hpp>

namespace counterpart::spectral_match {

/// A shape with what every refinement and every score of its maps reads. Curvature, wave kernel and relief
/// have mean 0 and variance 1 in each column.
struct LevelShape {
    const PreparedShape& shape;
    MatrixF intrinsic;  // V x features: curvature at all scales, some columns of the wave kernel
    MatrixF relief;     // V x 4
    MatrixF placement;  // V x 6: positions and normals, weighted
    Cells cells;
    Cells::Lists one_ring, two_rings;  // of cells
    Adjacency neighbors;
    SurfaceDistanceBound along;
    std::vector<std::vector<Index>> neighborhoods;  // samples within ScoreTuning::normal_radius of some

    LevelShape(const PreparedShape& of, const SpectralTuning& tuning);
};

/// A pair of shapes at one resolution: whole, or coarse copies of both. The shapes and priors must outlive
/// it.
struct Level {
    const SpectralTuning& tuning;
    SampledPair pair;  // on all samples
    LevelShape a, b;

    Level(const PreparedShape& shape_a, const PreparedShape& shape_b, const Priors& priors,
          const SpectralTuning& with);
};

/// Positions and normals, weighted.
MatrixF placement(PointsView positions, PointsView normals, const RefinementTuning& tuning);

}  // namespace counterpart::spectral_match
