// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "support/edits.hpp"

#include <counterpart/map/vertex_map.hpp>
#include <counterpart/match/differences.hpp>

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

namespace counterpart::test {

/// At least `share` of the surviving vertices right, none wrong but for those marked uncertain, and the
/// differing source triangles are the edited ones.
inline void expect_found(const EditedMesh& edited, double share, const MeshDifferences& difference,
                         const VertexMap& mesh_from_edited) {
    Index surviving = 0, right = 0;
    for (std::size_t v = 0; v < edited.edited_from_original.size(); ++v) {
        const Index now = edited.edited_from_original[v], found = difference.target_from_source.image()[v];
        const Index truth = now < 0 ? -1 : mesh_from_edited[now];
        surviving += now >= 0;
        right += now >= 0 && found == truth;
        const bool doubted = std::binary_search(difference.uncertain.begin(), difference.uncertain.end(),
                                                static_cast<Index>(v));
        EXPECT_TRUE(found < 0 || found == truth || doubted) << "vertex " << v << " is wrong";
    }
    EXPECT_GE(right, share * surviving);
    EXPECT_EQ(std::set<Index>(difference.source_triangles.begin(), difference.source_triangles.end()),
              edited.changed);
}

}  // namespace counterpart::test
