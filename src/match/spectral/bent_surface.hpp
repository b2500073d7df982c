// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "align/elastic_fit.hpp"
#include "match/spectral/level.hpp"

namespace counterpart::spectral_match {

/// A surface on its way to where the other one is. Keeps references.
class BentSurface {
  public:
    BentSurface(const LevelShape& shape, const LevelShape& other, const std::vector<Index>& pinned,
                align::ElasticFit& fit, const RefinementTuning& tuning);

    /// Towards its images and, `back_pull` times as hard, to all that the other map takes to it: what no
    /// image covers pulls the surface over itself. Shapes are kept below `stiffness_length`.
    void bend(const PairedMaps& maps, double back_pull, double stiffness_length, int n_iterations,
              const ProgressRange& progress);

    /// The images, but islands go where the surface around them carries them.
    std::vector<Index> without_islands(std::vector<Index> image, double stiffness_length,
                                       const ProgressRange& progress);

    /// Of the surface as it is bent now.
    MatrixF placement() const;

  private:
    Points normals() const;
    Vector pull(double stiffness_length) const;

    const LevelShape& shape_;
    const LevelShape& other_;
    const std::vector<Index>& pinned_;
    align::ElasticFit& fit_;
    const RefinementTuning& tuning_;
    Points positions_;
};

}  // namespace counterpart::spectral_match
