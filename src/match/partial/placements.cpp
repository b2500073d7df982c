// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/partial/placements.hpp"

#include "base/parallel.hpp"
#include "base/to_size.hpp"
#include "match/partial/gain.hpp"
#include "match/partial/nearest_grid.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <span>

namespace counterpart::partial_match {
namespace {

using Vectors = Eigen::Matrix3Xf;

enum class Reading { as_it_is, mirrored };

Points read(const Points& vectors, Reading reading) {
    Points result = vectors;
    if (reading == Reading::mirrored) result.col(0) *= -1;
    return result;
}

// One of the surfaces, as points that ask and as vertices that answer.
struct Side {
    Vectors points, normals;    // of all vertices
    std::vector<char> is_open;  // on the boundary or next to it
    std::vector<Index> landmarks, asking;
    double area;
    NearestGrid nearest;

    Side(const Surface& surface, Index n_landmarks, const PlacementTuning& tuning,
         Reading reading = Reading::as_it_is)
        : points(read(surface.mesh.vertices, reading).transpose().cast<float>()),
          normals(read(surface.normals, reading).transpose().cast<float>()),
          is_open(near_boundary(surface)),
          landmarks(surface.samples.begin(), surface.samples.begin() + n_landmarks),
          asking(surface.samples.begin() + n_landmarks, surface.samples.end()),
          area(surface.area),
          nearest(read(surface.mesh.vertices, reading), tuning.cell, tuning.margin) {
        asking.resize(std::min(asking.size(), to_size(tuning.n_points)));
    }
};

struct Answer {
    Index vertex;
    float fit;   // in [0, 1]
    float gain;  // fit, less what does not fit without a boundary for a reason
};

Answer ask(const Side& side, const Eigen::Vector3f& x, const Eigen::Vector3f& normal, float size,
           const PlacementTuning& tuning) {
    const Index y = side.nearest(x);
    const float gap = size * (x - side.points.col(y)).norm() / static_cast<float>(tuning.gap);
    const float fit = std::exp(-0.5F * gap * gap) * std::max(0.0F, normal.dot(side.normals.col(y)));
    const float lacks = side.is_open[to_size(y)] != 0 ? 0 : 1 - fit;
    return {y, fit, fit - static_cast<float>(tuning.misfit_weight) * lacks};
}

// Calls f(vertex of the part, vertex of the whole, answer, area) for what the first `n` asking points of both
// sides meet.
template <class F>
void for_answers(const Placement& p, const Side& part, const Side& whole, std::size_t n,
                 const PlacementTuning& tuning, const F& f) {
    const float scale2 = p.scale * p.scale;
    const std::size_t n_part = std::min(n, part.asking.size()), n_whole = std::min(n, whole.asking.size());
    for (std::size_t i = 0; i < n_part; ++i) {
        const Index v = part.asking[i];
        const Answer answer = ask(whole, p(part.points.col(v)), p.rotation * part.normals.col(v), 1, tuning);
        f(v, answer.vertex, answer, scale2 * static_cast<float>(part.area) / static_cast<float>(n_part));
    }
    const Eigen::Matrix3f back = p.rotation.transpose();
    for (std::size_t i = 0; i < n_whole; ++i) {
        const Index v = whole.asking[i];
        const Answer answer = ask(part, back * (whole.points.col(v) - p.translation) / p.scale,
                                  back * whole.normals.col(v), p.scale, tuning);
        f(answer.vertex, v, answer, static_cast<float>(whole.area) / static_cast<float>(n_whole));
    }
}

float score(const Placement& p, const Side& part, const Side& whole, std::size_t n,
            const PlacementTuning& tuning) {
    float sum = 0;
    for_answers(p, part, whole, n, tuning,
                [&](Index, Index, const Answer& answer, float area) { sum += area * answer.gain; });
    float apart = 0;
    for (std::size_t i = 0; i < part.landmarks.size(); ++i)
        apart +=
            std::min((p(part.points.col(part.landmarks[i])) - whole.points.col(whole.landmarks[i])).norm(),
                     static_cast<float>(tuning.far)) /
            static_cast<float>(part.landmarks.size());
    return sum / (p.scale * p.scale * static_cast<float>(part.area) + static_cast<float>(whole.area)) -
           static_cast<float>(tuning.landmark_weight) * apart;
}

// Turns `from` to `to` by the shortest way, then about `to`.
Eigen::Matrix3f turn(const Eigen::Vector3f& from, const Eigen::Vector3f& to, double angle) {
    return Eigen::AngleAxisf(static_cast<float>(angle), to).toRotationMatrix() *
           Eigen::Quaternionf::FromTwoVectors(from, to).toRotationMatrix();
}

void settle(Placement& p, const Side& part, const Side& whole, bool scale_is_free,
            const PlacementTuning& tuning) {
    for (int round = 0; round < tuning.n_icp_rounds; ++round) {
        float sum = 0, square = 0;
        Eigen::Vector3f a = Eigen::Vector3f::Zero(), b = a;
        Eigen::Matrix3f ab = Eigen::Matrix3f::Zero();
        for_answers(p, part, whole, part.asking.size(), tuning,
                    [&](Index v, Index w, const Answer& answer, float area) {
                        const float weight = area * answer.fit;
                        const Eigen::Vector3f x = part.points.col(v), y = whole.points.col(w);
                        sum += weight;
                        a += weight * x;
                        b += weight * y;
                        ab += weight * x * y.transpose();
                        square += weight * x.squaredNorm();
                    });
        if (sum < 1e-4F) break;
        a /= sum;
        b /= sum;
        const Eigen::Matrix3f covariance = ab / sum - a * b.transpose();
        const Eigen::JacobiSVD<Eigen::Matrix3f> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
        Eigen::Vector3f signs(1, 1, 1);
        signs[2] = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0 ? -1.0F : 1.0F;
        p.rotation = svd.matrixV() * signs.asDiagonal() * svd.matrixU().transpose();
        if (scale_is_free)
            p.scale =
                std::clamp(svd.singularValues().dot(signs) / std::max(square / sum - a.squaredNorm(), 1e-6F),
                           p.scale / 1.05F, p.scale * 1.05F);
        p.translation = b - p.scale * (p.rotation * a);
    }
    p.score = score(p, part, whole, part.asking.size(), tuning);
}

bool are_alike(const Placement& a, const Placement& b, const Side& part, const PlacementTuning& tuning) {
    float sum = 0;
    for (const Index v : part.asking) sum += (a(part.points.col(v)) - b(part.points.col(v))).norm();
    return sum < static_cast<float>(tuning.same_place * static_cast<double>(part.asking.size()));
}

bool better(const Placement& a, const Placement& b) { return a.score > b.score; }

// All that are tried and settled, best first.
std::vector<Placement> settled(const Side& of_part, const Side& of_whole, const std::vector<double>& scales,
                               const PlacementTuning& tuning) {
    const auto first = [](const std::vector<Index>& samples, int n) {
        return std::span(samples).first(std::min(samples.size(), to_size(n)));
    };
    const std::span<const Index> from = first(of_part.asking, tuning.n_from),
                                 to = first(of_whole.asking, tuning.n_to);
    std::vector<std::vector<Placement>> tried(from.size());
    parallel_for(from.size(), 1, [&](std::size_t i) {
        std::vector<Placement>& mine = tried[i];
        for (const Index y : to)
            for (const double scale : scales)
                for (int k = 0; k < tuning.n_angles; ++k) {
                    Placement p;
                    p.scale = static_cast<float>(scale);
                    p.rotation = turn(of_part.normals.col(from[i]), of_whole.normals.col(y),
                                      2 * std::numbers::pi * k / tuning.n_angles);
                    p.translation =
                        of_whole.points.col(y) - p.scale * (p.rotation * of_part.points.col(from[i]));
                    p.score = score(p, of_part, of_whole, to_size(tuning.n_first_points), tuning);
                    mine.push_back(p);
                }
        const std::size_t kept = std::min(mine.size(), to_size(tuning.n_settled) * 4 / from.size() + 1);
        std::partial_sort(mine.begin(), mine.begin() + static_cast<std::ptrdiff_t>(kept), mine.end(), better);
        mine.resize(kept);
    });
    std::vector<Placement> all;
    for (const auto& mine : tried) all.insert(all.end(), mine.begin(), mine.end());
    std::stable_sort(all.begin(), all.end(), better);
    all.resize(std::min(all.size(), to_size(tuning.n_settled)));
    parallel_for(all.size(), 4,
                 [&](std::size_t i) { settle(all[i], of_part, of_whole, scales.size() > 1, tuning); });
    std::stable_sort(all.begin(), all.end(), better);
    return all;
}

}  // namespace

std::vector<Placement> placements(const Surface& part, const Surface& whole, Index n_landmarks,
                                  const std::vector<double>& scales, const PlacementTuning& tuning) {
    const Side of_part(part, n_landmarks, tuning), of_whole(whole, n_landmarks, tuning);
    std::vector<Placement> found;
    for (const Placement& p : settled(of_part, of_whole, scales, tuning)) {
        if (found.size() == to_size(tuning.n_placements)) break;
        if (std::none_of(found.begin(), found.end(),
                         [&](const Placement& q) { return are_alike(p, q, of_part, tuning); }))
            found.push_back(p);
    }
    return found;
}

double gain_in_mirror(const Surface& part, const Surface& whole, Index n_landmarks, const Placement& best,
                      const PlacementTuning& tuning) {
    const Side of_part(part, n_landmarks, tuning), image(whole, n_landmarks, tuning, Reading::mirrored);
    return settled(of_part, image, {1}, tuning).front().score - best.score;
}

}  // namespace counterpart::partial_match
