// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "base/parallel.hpp"
#include "numerics/moments.hpp"
#include "numerics/rotation.hpp"
#include "numerics/sparse_cholesky.hpp"
#include "transfer/rigid_elements.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/transfer/morph.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <fmt/format.h>

namespace counterpart {
namespace {

constexpr std::size_t grain = 128;

void require_usable(MeshView first, PointsView last, const MorphOptions& options) {
    require_valid(first);
    if (last.rows() != first.vertices.rows()) {
        throw InvalidInput(
            fmt::format("the key frames have {} and {} vertices; they must have the same connectivity",
                        first.n_vertices(), last.rows()));
    }
    if (!last.allFinite()) throw InvalidInput("the last key frame has a coordinate that is not finite");
    if (options.iterations < 0 || options.iterations > 100)
        throw InvalidInput(fmt::format("iterations must be in 0 .. 100, not {}", options.iterations));
}

// The sides at each vertex: what a right-hand side is gathered from, vertex by vertex.
struct SidesAtVertices {
    struct Side {
        Index element;
        int side;
        double signed_weight;  // positive where the side arrives, negative where it leaves
    };
    std::vector<Index> first;
    std::vector<Side> sides;

    SidesAtVertices(const morphing::RigidElements& elements, Index n_vertices)
        : first(static_cast<std::size_t>(n_vertices) + 1, 0) {
        for (const Index v : elements.corners.reshaped()) first[static_cast<std::size_t>(v) + 1] += 2;
        std::partial_sum(first.begin(), first.end(), first.begin());
        std::vector<Index> next(first.begin(), first.end() - 1);
        sides.resize(static_cast<std::size_t>(elements.corners.size()) * 2);
        for (Index t = 0; t < elements.count(); ++t) {
            for (int c = 0; c < 3; ++c) {
                const double weight = elements.side_weights(t, c);
                const auto from = static_cast<std::size_t>(elements.corners(t, c));
                const auto to = static_cast<std::size_t>(elements.corners(t, (c + 1) % 3));
                sides[static_cast<std::size_t>(next[from]++)] = {t, c, -weight};
                sides[static_cast<std::size_t>(next[to]++)] = {t, c, weight};
            }
        }
    }
};

// Vertex 0 is held at the origin, so that the matrix is regular.
SparseMatrix laplacian_without_vertex_0(const morphing::RigidElements& elements, Index n_vertices) {
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(static_cast<std::size_t>(elements.corners.size()) * 4);
    for (Index t = 0; t < elements.count(); ++t) {
        for (int c = 0; c < 3; ++c) {
            const Index a = elements.corners(t, c), b = elements.corners(t, (c + 1) % 3);
            const double weight = elements.side_weights(t, c);
            if (a == b) continue;
            if (a > 0) entries.emplace_back(a - 1, a - 1, weight);
            if (b > 0) entries.emplace_back(b - 1, b - 1, weight);
            if (a == 0 || b == 0) continue;
            entries.emplace_back(a - 1, b - 1, -weight);
            entries.emplace_back(b - 1, a - 1, -weight);
        }
    }
    SparseMatrix matrix(n_vertices - 1, n_vertices - 1);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

using ThreeSides = Eigen::Matrix3d;  // one side per row

// A triangle with the given lengths of its sides, in the plane of `like` and turned toward it.
ThreeSides triangle_with_lengths(const Eigen::Vector3d& lengths, const ThreeSides& like) {
    const Eigen::RowVector3d area = like.row(0).cross(like.row(1));
    if (area.norm() <= 1e-9 * like.row(0).norm() * like.row(1).norm()) return like;
    const Eigen::RowVector3d x = like.row(0).normalized(), y = area.normalized().cross(x);
    // Corner 2 over the base of length l0, l2 from corner 0 and l1 from corner 1.
    const double along =
        (lengths[0] * lengths[0] + lengths[2] * lengths[2] - lengths[1] * lengths[1]) / (2 * lengths[0]);
    const double height = std::sqrt(std::max(0.0, lengths[2] * lengths[2] - along * along));
    Eigen::Matrix<double, 3, 2> flat;
    flat << lengths[0], 0, along - lengths[0], height, -along, -height;
    double cosine = 0, sine = 0;
    for (int c = 0; c < 3; ++c) {
        const double u = like.row(c).dot(x), v = like.row(c).dot(y);
        cosine += flat(c, 0) * u + flat(c, 1) * v;
        sine += flat(c, 0) * v - flat(c, 1) * u;
    }
    const double norm = std::hypot(cosine, sine);
    if (norm == 0) return like;
    const Eigen::RowVector3d turned_x = (cosine * x + sine * y) / norm,
                             turned_y = (cosine * y - sine * x) / norm;
    return flat.col(0) * turned_x + flat.col(1) * turned_y;
}

}  // namespace

struct Morph::Impl {
    MorphOptions options;
    Points first, last;  // as given
    Points from, to;     // about the origin, `to` turned onto `from`
    Eigen::RowVector3d first_mean, last_mean;
    Eigen::Vector3d global_turn;  // rotation vector that undoes the turning of `to`
    morphing::RigidElements elements;
    std::unique_ptr<SidesAtVertices> sides;
    Points turns;                   // rotation vector of each element, between `from` and `to`
    morphing::RotationField field;  // the same, softened at folds
    std::vector<Index> folding;     // elements that were seen to turn over
    int rings = 5;
    numerics::SparseCholesky solver;

    using Frame = std::vector<Eigen::Quaterniond>;
    Points shapes_at(double time) const;
    Points positions(const Frame& rotations, PointsView shapes) const;
    void refit(Frame& rotations, PointsView shapes, PointsView positions) const;
    std::size_t count() const { return static_cast<std::size_t>(elements.count()); }
};

Morph::Morph(MeshView first, PointsView last, const MorphOptions& options) : impl_(std::make_unique<Impl>()) {
    require_usable(first, last, options);
    Impl& m = *impl_;
    m.options = options;
    m.first = first.vertices;
    m.last = last;
    m.first_mean = first.vertices.colwise().mean();
    m.last_mean = last.colwise().mean();
    m.from = first.vertices.rowwise() - m.first_mean;
    const Points centered = last.rowwise() - m.last_mean;
    const Eigen::Matrix3d turn = numerics::fit_rotation(numerics::cross_moments(centered, m.from)).rotation;
    m.global_turn = numerics::rotation_vector(Eigen::Quaterniond(turn));
    m.to = centered * turn;
    with_threads(options.n_threads, [&] {
        m.elements = morphing::make_rigid_elements({m.from, first.triangles}, m.to);
        m.turns = morphing::rotation_field(m.elements, m.from, m.to);
        m.field = morphing::soften_folds(m.elements, m.turns, m.folding, m.rings);
    });
    m.sides = std::make_unique<SidesAtVertices>(m.elements, first.n_vertices());
    if (first.n_vertices() > 1) {
        const SparseMatrix laplacian = laplacian_without_vertex_0(m.elements, first.n_vertices());
        m.solver = numerics::SparseCholesky(laplacian);
        if (!m.solver.factorize(laplacian))
            throw NumericalError("the morph's system could not be factorized");
    }
}

Morph::~Morph() = default;
Morph::Morph(Morph&&) noexcept = default;
Morph& Morph::operator=(Morph&&) noexcept = default;

// The interpolated sides of each element, in its first pose; three rows per element.
Points Morph::Impl::shapes_at(double time) const {
    Points shapes(elements.corners.size(), 3);
    parallel_for(count(), grain, [&](std::size_t i) {
        const auto t = static_cast<Index>(i);
        const Eigen::Matrix3d turn =
            numerics::rotation_from_vector(field.vectors.row(t).transpose()).toRotationMatrix();
        ThreeSides blend;
        Eigen::Vector3d lengths;
        for (int c = 0; c < 3; ++c) {
            const Eigen::RowVector3d start = elements.side(from, t, c), end = elements.side(to, t, c);
            blend.row(c) = (1 - time) * start + time * (end * turn);
            lengths[c] = (1 - time) * start.norm() + time * end.norm();
        }
        shapes.middleRows<3>(3 * t) = field.folds[i] ? blend : triangle_with_lengths(lengths, blend);
    });
    return shapes;
}

// The positions whose sides come closest to the turned shapes.
Points Morph::Impl::positions(const Frame& rotations, PointsView shapes) const {
    Points turned(shapes.rows(), 3);
    parallel_for(count(), grain, [&](std::size_t i) {
        const auto row = 3 * static_cast<Eigen::Index>(i);
        turned.middleRows<3>(row) = shapes.middleRows<3>(row) * rotations[i].toRotationMatrix().transpose();
    });
    const Eigen::Index n_vertices = from.rows();
    Points right(n_vertices - 1, 3);
    parallel_for(static_cast<std::size_t>(n_vertices - 1), grain, [&](std::size_t i) {
        Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
        for (Index s = sides->first[i + 1]; s < sides->first[i + 2]; ++s) {
            const SidesAtVertices::Side& side = sides->sides[static_cast<std::size_t>(s)];
            sum += side.signed_weight * turned.row(3 * side.element + side.side);
        }
        right.row(static_cast<Eigen::Index>(i)) = sum;
    });
    Points result = Points::Zero(n_vertices, 3);
    if (n_vertices > 1) result.bottomRows(n_vertices - 1) = solver.solve(right);
    return result;
}

// Rotations follow the positions, but not at folds, where neighbors would drag them over the edge.
void Morph::Impl::refit(Frame& rotations, PointsView shapes, PointsView positions) const {
    parallel_for(count(), grain, [&](std::size_t i) {
        if (field.folds[i]) return;
        const auto t = static_cast<Index>(i);
        Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
        for (int c = 0; c < 3; ++c) {
            covariance.noalias() += elements.side_weights(t, c) * elements.side(positions, t, c).transpose() *
                                    shapes.row(3 * t + c);
        }
        rotations[i] = numerics::follow_rotation(covariance, rotations[i]);
    });
}

Points Morph::at(double time) const {
    const Impl& m = *impl_;
    if (!(time >= 0 && time <= 1)) throw InvalidInput(fmt::format("time must be in 0 .. 1, not {}", time));
    if (time == 0) return m.first;
    if (time == 1) return m.last;
    return with_threads(m.options.n_threads, [&]() -> Points {
        Impl::Frame rotations(m.count());
        parallel_for(m.count(), grain, [&](std::size_t i) {
            rotations[i] = numerics::rotation_from_vector(
                time * m.field.vectors.row(static_cast<Eigen::Index>(i)).transpose());
        });
        Points frame = Points::Zero(m.from.rows(), 3);
        if (frame.rows() > 1) {
            const Points shapes = m.shapes_at(time);
            frame = m.positions(rotations, shapes);
            for (int i = 0; i < m.options.iterations; ++i) {
                m.refit(rotations, shapes, frame);
                frame = m.positions(rotations, shapes);
            }
        }
        frame.rowwise() -= frame.colwise().mean().eval();
        const Eigen::Matrix3d turn = numerics::rotation_from_vector(time * m.global_turn).toRotationMatrix();
        return (frame * turn.transpose()).rowwise() + ((1 - time) * m.first_mean + time * m.last_mean);
    });
}

void Morph::soften_around(const std::vector<Index>& triangles) {
    Impl& m = *impl_;
    for (const Index t : triangles) {
        if (t < 0 || t >= m.elements.count()) throw InvalidInput(fmt::format("there is no triangle {}", t));
        if (std::find(m.folding.begin(), m.folding.end(), t) == m.folding.end()) m.folding.push_back(t);
    }
    m.rings += 3;
    m.field = morphing::soften_folds(m.elements, m.turns, m.folding, m.rings);
}

std::vector<Points> morph_frames(MeshView first, PointsView last, int count, const MorphOptions& options,
                                 const Progress& progress) {
    if (count < 0 || count > 1000000)
        throw InvalidInput(fmt::format("the number of frames must be in 0 .. 1000000, not {}", count));
    constexpr int most_passes = 4;
    report_progress(progress, 0);
    Morph morph(first, last, options);
    std::vector<Points> best;
    std::size_t least_inverted = std::numeric_limits<std::size_t>::max();
    for (int pass = 0; pass < most_passes; ++pass) {
        std::vector<Points> frames;
        std::vector<Index> inverted;
        for (int k = 1; k <= count + 1; ++k) {
            Points frame = morph.at(static_cast<double>(k) / (count + 1));
            const std::vector<Index> here = inverted_triangles(
                first.triangles, frames.empty() ? first.vertices : PointsView(frames.back()), frame);
            inverted.insert(inverted.end(), here.begin(), here.end());
            frames.push_back(std::move(frame));
            report_progress(progress, std::max(0.0, 1 - std::pow(0.3, pass) * (1 - 0.7 * k / (count + 1))));
        }
        frames.pop_back();
        if (inverted.size() < least_inverted) best = std::move(frames);
        least_inverted = std::min(least_inverted, inverted.size());
        if (inverted.empty()) break;
        morph.soften_around(inverted);
    }
    report_progress(progress, 1);
    return best;
}

}  // namespace counterpart
