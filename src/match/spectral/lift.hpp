// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/spectral/prepared_shape.hpp"

namespace counterpart::spectral_match {

/// A map between two shapes' meshes as one between their full surfaces. Where either or both are matched by a
/// proxy, each surface is bent to its images, its full vertices move along with the neighborhoods around
/// them, and take the partner nearest in position and normal in the cells around their images. O(V) apart
/// from the bending.
PairedMaps lift(const PreparedShape& a, const PreparedShape& b, const PairedMaps& maps,
                const SpectralTuning& tuning, const ProgressRange& progress = {});

/// Values per vertex of a shape's mesh as values per vertex of its full surface.
Vector lift(const PreparedShape& shape, const Vector& values);

}  // namespace counterpart::spectral_match
