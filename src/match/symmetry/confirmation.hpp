// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Regular triangulations (spheres, grids, wraps of a template) have connectivity in common by accident, too.
#pragma once

#include "match/symmetry/choice.hpp"

namespace counterpart::symmetry {

/// The share of the triangles whose components lengths of edges confirm to be partners. Connectivity that is
/// alike in one way only needs no confirmation. Of several ways the chosen one must keep lengths twice as
/// well as the others do in the middle, or better than the best of so many would by chance, and curve alike;
/// or one of both components is as alike in shape as in connectivity, so that every way is right. O(F) for
/// each of some automorphisms.
double confirmed_share(const MatchedMaps& maps, const Choice& choice);

}  // namespace counterpart::symmetry
