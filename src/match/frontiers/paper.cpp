// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Sahillioglu and Yemez, "3D Correspondence by Breadth-First Search Frontiers", section 4: whole frontiers,
// each on its own and so in parallel.
#include "base/parallel.hpp"
#include "match/frontiers/side.hpp"

#include <counterpart/align/tps_rpm.hpp>
#include <counterpart/align/transform.hpp>

#include <algorithm>

namespace counterpart::frontiers {
namespace {

// S: the sum of squared distances from each point to the closest one.
double closest_sum(PointsView aligned, PointsView target) {
    double sum = 0;
    for (Eigen::Index i = 0; i < aligned.rows(); ++i)
        sum += (target.rowwise() - aligned.row(i)).rowwise().squaredNorm().minCoeff();
    return sum;
}

}  // namespace

Points align_whole_frontier(PointsView x, PointsView y, double deformation_threshold,
                            const Progress& progress) {
    const Points centered = align_centroids(x, y)(x);
    const double sum = closest_sum(centered, y);
    const auto n = static_cast<double>(x.rows());
    if (x.rows() < 4 || sum <= deformation_threshold * n) return centered;
    TpsRpmOptions rpm;
    rpm.initial_temperature = 10 * sum;
    rpm.progress = progress;
    return tps_rpm(centered, y, rpm).transformed;
}

frontiers::SideMatch match_whole_frontiers(const FrontierSide& source, const FrontierSide& target,
                                           const FrontiersOptions& options) {
    SideMatch match{std::vector<Index>(source.slot.size(), VertexMap::unmatched)};
    const Index n = source.frontiers.count();
    std::vector<Index> by_size(to_size(n));
    for (Index k = 0; k < n; ++k) by_size[to_size(k)] = k;
    std::stable_sort(by_size.begin(), by_size.end(),
                     [&](Index a, Index b) { return source.frontiers.size(a) > source.frontiers.size(b); });
    const Progress check = checking(options.progress);
    const auto match_frontier = [&](Index k) {
        const auto ours = source.frontiers[k], theirs = target.frontiers[k];
        const Points x = rows_of(source.points, ours), y = rows_of(target.points, theirs);
        const Points aligned = align_whole_frontier(x, y, options.deformation_threshold, check);
        const std::vector<Index> chosen =
            pair_up(pairing_cost(ours, aligned, theirs, y, options.metric), options.pairing, check);
        for (std::size_t v = 0; v < ours.size(); ++v)
            if (chosen[v] >= 0) match.image[to_size(ours[v])] = theirs[to_size(chosen[v])];
    };
    // In batches, between which progress is reported: largest first, so that no thread is left with a large
    // one.
    constexpr std::size_t batch = 32;
    for (std::size_t begin = 0; begin < by_size.size(); begin += batch) {
        report_progress(options.progress, static_cast<double>(begin) / static_cast<double>(by_size.size()));
        parallel_for(std::min(batch, by_size.size() - begin), 1,
                     [&](std::size_t i) { match_frontier(by_size[begin + i]); });
    }
    match.n_decided_by_position = static_cast<Index>(source.frontiers.order.size()) - 1;
    return match;
}

}  // namespace counterpart::frontiers
