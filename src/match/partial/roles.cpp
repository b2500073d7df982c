// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/partial/roles.hpp"

#include "match/surface/openness.hpp"

namespace counterpart::partial_match {

Part seen_part(MeshView source, MeshView target) {
    const bool a = surface_match::openness(source) > open_part,
               b = surface_match::openness(target) > open_part;
    if (a && b) return Part::both;
    if (a) return Part::source;
    return b ? Part::target : Part::neither;
}

}  // namespace counterpart::partial_match
