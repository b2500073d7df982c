// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "base/parallel.hpp"
#include "base/random.hpp"
#include "match/spectral/cells.hpp"
#include "support/spikes.hpp"

#include <algorithm>
#include <limits>
#include <memory>
#include <set>

#include <gtest/gtest.h>

namespace counterpart::spectral_match {
namespace {

// Cells of one or two vertices, and of many.
class SpectralCells : public testing::TestWithParam<int> {
  protected:
    static void SetUpTestSuite() {
        const TriangleMesh mesh = test::three_spikes(3);
        for (const int n_samples : {400, 60})
            shapes[n_samples == 400] =
                std::make_unique<PreparedShape>(prepare(mesh, {.n_functions = 20, .n_samples = n_samples}));
    }
    static void TearDownTestSuite() {
        for (auto& shape : shapes) shape.reset();
    }

    // By the triangles: cells that are at most so many steps away.
    std::set<Index> cells_around(Index cell, int n_steps) const {
        std::set<Index> around{cell};
        for (int step = 0; step < n_steps; ++step) {
            const std::set<Index> inner = around;
            for (Index t = 0; t < shape.mesh.n_triangles(); ++t)
                for (int i = 0; i < 3; ++i)
                    if (inner.contains(shape.cell_of_vertex[at(shape.mesh.triangles(t, i))]))
                        for (int j = 0; j < 3; ++j)
                            around.insert(shape.cell_of_vertex[at(shape.mesh.triangles(t, j))]);
        }
        return around;
    }

    static inline std::unique_ptr<const PreparedShape> shapes[2];
    const PreparedShape& shape = *shapes[GetParam()];
    const Cells cells{shape};
};

TEST_P(SpectralCells, HoldTheVerticesNearestToTheirSamples) {
    ASSERT_EQ(cells.vertices().size(), shape.samples.size());
    Index n = 0;
    for (std::size_t c = 0; c < cells.vertices().size(); ++c) {
        n += static_cast<Index>(cells.vertices()[c].size());
        for (const Index v : cells.vertices()[c]) EXPECT_EQ(cells.of_vertex(v), static_cast<Index>(c));
        EXPECT_EQ(cells.of_vertex(shape.samples[c]), static_cast<Index>(c));
    }
    EXPECT_EQ(n, shape.mesh.n_vertices());
}

TEST_P(SpectralCells, AreNearByStepsOverTriangles) {
    for (const int n_steps : {1, 2, 3}) {
        const Cells::Lists near = cells.near(n_steps);
        for (const std::size_t c : {std::size_t{0}, near.size() / 2, near.size() - 1}) {
            const std::set<Index> expected = cells_around(static_cast<Index>(c), n_steps);
            EXPECT_EQ(near[c], std::vector<Index>(expected.begin(), expected.end()));
        }
    }
}

TEST_P(SpectralCells, PartnersAreTheNearestOfThoseNearTheGuesses) {
    Random random(7);
    const Index n = shape.mesh.n_vertices();
    const MatrixF ours =
                      MatrixF::NullaryExpr(n, 12, [&] { return static_cast<float>(random.uniform(-1, 1)); }),
                  theirs =
                      MatrixF::NullaryExpr(n, 12, [&] { return static_cast<float>(random.uniform(-1, 1)); });
    const VectorF half = theirs.rowwise().squaredNorm() / 2;
    std::vector<Index> guess;
    for (Index v = 0; v < n; ++v)
        guess.push_back(static_cast<Index>(random.below(static_cast<std::uint64_t>(n))));
    const Cells::Lists near = cells.near(1);
    const std::vector<Index> found = nearest_nearby(cells, cells, near, ours, theirs, half, guess);
    ASSERT_EQ(found.size(), guess.size());
    for (Index v = 0; v < n; v += 5) {
        std::set<Index> allowed;
        for (const Index beside : cells.vertices()[at(cells.of_vertex(v))])
            for (const Index cell : near[at(cells.of_vertex(guess[at(beside)]))])
                allowed.insert(cells.vertices()[at(cell)].begin(), cells.vertices()[at(cell)].end());
        EXPECT_TRUE(allowed.contains(found[at(v)])) << v;
        float least = std::numeric_limits<float>::infinity();
        for (const Index w : allowed) least = std::min(least, (ours.row(v) - theirs.row(w)).squaredNorm());
        EXPECT_NEAR((ours.row(v) - theirs.row(found[at(v)])).squaredNorm(), least, 1e-5F) << v;
    }
    EXPECT_EQ(with_threads(1, [&] { return nearest_nearby(cells, cells, near, ours, theirs, half, guess); }),
              found)
        << "on one thread";
}

TEST_P(SpectralCells, VerticesFollowTheirSamples) {
    PairedMaps of_samples;
    Random random(3);
    const auto n = static_cast<std::uint64_t>(shape.samples.size());
    for (std::size_t s = 0; s < n; ++s) {
        of_samples.b_from_a.push_back(static_cast<Index>(random.below(n)));
        of_samples.a_from_b.push_back(static_cast<Index>(random.below(n)));
    }
    const PairedMaps whole = spread(shape, shape, of_samples);
    for (Index v = 0; v < shape.mesh.n_vertices(); ++v) {
        const std::size_t cell = at(shape.cell_of_vertex[at(v)]);
        EXPECT_EQ(whole.b_from_a[at(v)], shape.samples[at(of_samples.b_from_a[cell])]);
        EXPECT_EQ(whole.a_from_b[at(v)], shape.samples[at(of_samples.a_from_b[cell])]);
    }
}

INSTANTIATE_TEST_SUITE_P(SmallAndLarge, SpectralCells, testing::Values(1, 0),
                         [](const auto& cells) { return cells.param == 1 ? "small" : "large"; });

}  // namespace
}  // namespace counterpart::spectral_match
