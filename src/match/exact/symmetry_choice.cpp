// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/exact/symmetry_choice.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace counterpart {
namespace {

double total_length(const TriangleMesh& mesh) {
    double sum = 0;
    for (Index t = 0; t < mesh.n_triangles(); ++t)
        for (int c = 0; c < 3; ++c)
            sum +=
                (mesh.vertices.row(mesh.triangles(t, c)) - mesh.vertices.row(mesh.triangles(t, (c + 1) % 3)))
                    .norm();
    return sum;
}

// At most `most` of 0 .. size - 1, evenly spread.
std::vector<std::size_t> spread(std::size_t size, std::size_t most) {
    std::vector<std::size_t> chosen(std::min(size, most));
    for (std::size_t i = 0; i < chosen.size(); ++i) chosen[i] = i * size / chosen.size();
    return chosen;
}

// One automorphism on the sampled triangles.
struct Candidate {
    std::size_t element, full = 0;  ///< number of the automorphism; where it is kept in full
    double lengths = 0, distance = 0, displacement = 0;
};

double mean_displacement(const std::vector<PointPair>& points) { return residual(Motion{}, points); }

}  // namespace

PairGeometry::PairGeometry(const MatchedMaps& maps, bool lengths) : maps_(maps) {
    if (!lengths) return;
    const double source = total_length(maps.source_mesh), target = total_length(maps.target_mesh);
    // Where islands are missing the totals do not compare, but the means nearly do.
    const double source_mean = source / (3.0 * maps.source_mesh.n_triangles());
    mean_length_ = target / (3.0 * maps.target_mesh.n_triangles());
    if (source_mean > 0 && mean_length_ > 0) length_scale_ = mean_length_ / source_mean;
}

Eigen::RowVector3d PairGeometry::on_source(Flag f) const {
    return maps_.source_mesh.vertices.row(
        maps_.source.input_vertex[static_cast<std::size_t>(maps_.source.origin(f))]);
}
Eigen::RowVector3d PairGeometry::on_target(Flag f) const {
    return maps_.target_mesh.vertices.row(
        maps_.target.input_vertex[static_cast<std::size_t>(maps_.target.origin(f))]);
}

double PairGeometry::triangle_disagreement(Flag source, Flag target) const {
    double sum = 0;
    for (int c = 0; c < 3; ++c, source = next(source), target = next(target)) {
        const double difference = length_scale_ * (on_source(source) - on_source(next(source))).norm() -
                                  (on_target(target) - on_target(next(target))).norm();
        sum += difference * difference;
    }
    return sum / 3;
}

double PairGeometry::length_disagreement(const IslandPair& pair, std::size_t most) const {
    double sum = 0;
    const auto sample = spread(pair.source->from_representative.size(), most);
    for (const std::size_t k : sample)
        sum += triangle_disagreement(pair.on_source(k), pair.on_target(k, first(pair)));
    return sum / static_cast<double>(sample.size());
}

void PairGeometry::add_points(Flag source, Flag target, std::vector<PointPair>& points) const {
    for (int c = 0; c < 3; ++c, source = next(source), target = next(target))
        points.push_back({on_source(source), on_target(target)});
}

std::vector<PointPair> PairGeometry::points(const IslandPair& pair, std::size_t most) const {
    std::vector<PointPair> points;
    for (const std::size_t k : spread(pair.source->from_representative.size(), most))
        add_points(pair.on_source(k), pair.on_target(k, first(pair)), points);
    return points;
}

std::vector<Images> rank_automorphisms(const MatchedMaps& maps, const AutomorphismGroup& group,
                                       const PairGeometry& geometry, IslandPair pair, bool turned,
                                       const Motion* similarity, std::size_t count) {
    const Index first = geometry.first(pair);
    const std::size_t order = group.order(), size = pair.source->from_representative.size();
    const auto sample = spread(size, std::clamp<std::size_t>((1U << 24U) / order, 8, 256));

    // Where each element takes the sampled triangles: along the tree in which the orbit was found.
    std::vector<Flag> flags(order * sample.size()), roots(order);
    std::vector<Candidate> candidates(order);
    std::vector<PointPair> points;
    for (std::size_t e = 0; e < order; ++e) {
        Flag* const row = &flags[e * sample.size()];
        if (e == 0)
            roots[e] = turned ? image_of(group.mirror, first, pair.kind->root) : pair.kind->root;
        else
            roots[e] = image_of(group.generators[group.generator[e]], first, roots[group.parent[e]]);
        for (std::size_t s = 0; s < sample.size(); ++s) {
            if (e == 0) {
                const Flag f = make_flag(first + static_cast<Index>(sample[s]), 0);
                row[s] = turned ? image_of(group.mirror, first, f) : f;
            } else {
                row[s] = image_of(group.generators[group.generator[e]], first,
                                  flags[group.parent[e] * sample.size() + s]);
            }
            candidates[e].lengths += geometry.triangle_disagreement(
                pair.on_source(sample[s]), image_of(pair.target->from_representative, first, row[s]));
        }
        candidates[e].lengths /= static_cast<double>(sample.size());
        candidates[e].element = e;
    }
    const auto measure_distance = [&](const std::vector<PointPair>& at) {
        return residual(similarity != nullptr ? *similarity : fit_similarity(at, turned), at);
    };
    const double floor = std::pow(1e-5 * geometry.mean_length(), 2);
    // Best by lengths first; those that lengths cannot tell from the best, by distance; of those that even
    // distance cannot tell, the least moved: an unmoved ball is matched with itself as it lies.
    const auto rank = [&] {
        std::stable_sort(candidates.begin(), candidates.end(),
                         [](const Candidate& a, const Candidate& b) { return a.lengths < b.lengths; });
        const double limit = 1.01 * candidates[0].lengths + floor;
        const auto tied = std::find_if(candidates.begin(), candidates.end(),
                                       [&](const Candidate& c) { return c.lengths > limit; });
        std::stable_sort(candidates.begin(), tied,
                         [](const Candidate& a, const Candidate& b) { return a.distance < b.distance; });
        const double farthest = 1.01 * candidates[0].distance + floor;
        const auto in_place =
            std::find_if(candidates.begin(), tied, [&](const Candidate& c) { return c.distance > farthest; });
        std::stable_sort(candidates.begin(), in_place, [](const Candidate& a, const Candidate& b) {
            return a.displacement < b.displacement;
        });
    };
    const auto by_lengths =
        std::min_element(candidates.begin(), candidates.end(),
                         [](const auto& a, const auto& b) { return a.lengths < b.lengths; });
    const double limit = 1.01 * by_lengths->lengths + floor;
    for (Candidate& candidate : candidates) {
        if (candidate.lengths > limit) continue;
        points.clear();
        for (std::size_t s = 0; s < sample.size(); ++s)
            geometry.add_points(pair.on_source(sample[s]),
                                image_of(pair.target->from_representative, first,
                                         flags[candidate.element * sample.size() + s]),
                                points);
        candidate.distance = measure_distance(points);
        candidate.displacement = mean_displacement(points);
    }
    rank();

    // The leaders in full: a sample may miss where they differ.
    candidates.resize(std::min(candidates.size(), std::max<std::size_t>(count, 32)));
    Walker walker(maps.source, maps.source);
    std::vector<Images> images;
    for (Candidate& candidate : candidates) {
        pair.automorphism = walker.walk(pair.kind->island, pair.kind->root, roots[candidate.element]);
        candidate.full = images.size();
        images.push_back(pair.automorphism);
        if (sample.size() == size) continue;
        candidate.lengths = geometry.length_disagreement(pair, 100'000);
        const std::vector<PointPair> all = geometry.points(pair, 10'000);
        candidate.distance = measure_distance(all);
        candidate.displacement = mean_displacement(all);
    }
    rank();
    std::vector<Images> best;
    for (std::size_t i = 0; i < std::min(count, candidates.size()); ++i)
        best.push_back(std::move(images[candidates[i].full]));
    return best;
}

}  // namespace counterpart
