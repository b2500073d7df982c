// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/candidate.hpp"

#include <algorithm>
#include <utility>

namespace counterpart::spectral_match {

PairedMaps reversed(PairedMaps maps) { return {std::move(maps.a_from_b), std::move(maps.b_from_a)}; }

PairedMaps between_samples(const SampledPair& all, const PairedMaps& on_vertices) {
    const auto between = [](const PreparedShape& from, const PreparedShape& to,
                            const std::vector<Index>& map) {
        std::vector<Index> result;
        for (const Index v : from.samples)
            result.push_back(to.cell_of_vertex[static_cast<std::size_t>(map[static_cast<std::size_t>(v)])]);
        return result;
    };
    return {between(all.a, all.b, on_vertices.b_from_a), between(all.b, all.a, on_vertices.a_from_b)};
}

MapDistance::MapDistance(const SampledPair& pair) : a_(pair.a), b_(pair.b) {
    const auto nearest = [](const PreparedShape& shape, Index n_samples) {
        std::vector<Index> result;
        for (Index s = 0; s < n_samples; ++s) {
            Eigen::Index row = 0;
            shape.sample_distances.col(shape.samples[static_cast<std::size_t>(s)]).minCoeff(&row);
            result.push_back(static_cast<Index>(row));
        }
        return result;
    };
    nearest_a_ = nearest(a_, pair.points_a.size());
    nearest_b_ = nearest(b_, pair.points_b.size());
}

double MapDistance::operator()(const PairedMaps& x, const PairedMaps& y) const {
    const auto mean = [](const PreparedShape& to, const std::vector<Index>& nearest,
                         const std::vector<Index>& f, const std::vector<Index>& g) {
        double sum = 0;
        for (std::size_t s = 0; s < f.size(); ++s) {
            const Index i = nearest[static_cast<std::size_t>(f[s])],
                        j = nearest[static_cast<std::size_t>(g[s])];
            sum += to.sample_distances(i, to.samples[static_cast<std::size_t>(j)]);
        }
        return sum / static_cast<double>(std::max<std::size_t>(f.size(), 1));
    };
    return (mean(b_, nearest_b_, x.b_from_a, y.b_from_a) + mean(a_, nearest_a_, x.a_from_b, y.a_from_b)) / 2;
}

double MapDistance::on_b(Index sample, Index other) const {
    return b_.sample_distances(
        nearest_b_[static_cast<std::size_t>(sample)],
        b_.samples[static_cast<std::size_t>(nearest_b_[static_cast<std::size_t>(other)])]);
}

double MapDistance::share_beyond(const PairedMaps& x, const PairedMaps& y, double distance) const {
    const auto share = [&](const PreparedShape& to, const std::vector<Index>& nearest,
                           const std::vector<Index>& f, const std::vector<Index>& g) {
        std::size_t count = 0;
        for (std::size_t s = 0; s < f.size(); ++s)
            if (to.sample_distances(nearest[at(f[s])], to.samples[at(nearest[at(g[s])])]) > distance) ++count;
        return static_cast<double>(count) / static_cast<double>(std::max<std::size_t>(f.size(), 1));
    };
    return (share(b_, nearest_b_, x.b_from_a, y.b_from_a) + share(a_, nearest_a_, x.a_from_b, y.a_from_b)) /
           2;
}

bool MapDistance::are_distinct(const PairedMaps& x, const PairedMaps& y, const Distinctness& distinct) const {
    return (*this)(x, y) >= distinct.mean || share_beyond(x, y, distinct.moved) >= distinct.moved_share;
}

std::vector<Index> samples_of_extremities(const PreparedShape& shape, Index n) {
    std::vector<Index> result;
    for (Eigen::Index e = 0; e < shape.extremity_distances.rows(); ++e) {
        Index nearest = 0;
        for (Index s = 1; s < n; ++s)
            if (shape.extremity_distances(e, shape.samples[at(s)]) <
                shape.extremity_distances(e, shape.samples[at(nearest)]))
                nearest = s;
        result.push_back(nearest);
    }
    return result;
}

}  // namespace counterpart::spectral_match
