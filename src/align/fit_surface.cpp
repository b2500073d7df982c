// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "align/elastic_surface.hpp"
#include "align/tuning.hpp"
#include "base/parallel.hpp"
#include "mesh/edge_table.hpp"
#include "mesh/surface_box.hpp"
#include "numerics/closest_triangle.hpp"

#include <counterpart/align/fit_surface.hpp>
#include <counterpart/align/transform.hpp>
#include <counterpart/base/errors.hpp>
#include <counterpart/mesh/measure.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

namespace counterpart {
namespace {

using namespace align;

void require_fit(MeshView model, MeshView scan, const SurfaceMap& map, const FitOptions& options) {
    require_valid(model);
    require_valid(scan);
    require_valid(map, model.n_vertices(), scan.n_triangles());
    if (!(options.stiffness >= 0.1 && options.stiffness <= 10))
        throw InvalidInput(fmt::format("fit: stiffness must be from 0.1 to 10, not {}", options.stiffness));
    if (!(options.reach > 0)) throw InvalidInput("fit: reach must be above 0");
    for (const auto& [from, to] : options.landmarks) {
        if (from < 0 || from >= model.n_vertices() || to < 0 || to >= scan.n_vertices())
            throw InvalidInput(
                fmt::format("fit: landmark {} -> {} is out of range: the meshes have {} and {} vertices",
                            from, to, model.n_vertices(), scan.n_vertices()));
    }
}

// Pairs of triangles across an edge.
std::vector<std::pair<Index, Index>> neighbor_triangles(const mesh::EdgeTable& edges) {
    std::vector<std::pair<Index, Index>> pairs;
    for (Index e = 0; e < edges.n_edges(); ++e) {
        const auto sides = edges.half_edges(e);
        for (std::size_t i = 1; i < sides.size(); ++i)
            pairs.emplace_back(sides[i - 1].triangle, sides[i].triangle);
    }
    return pairs;
}

// Which vertices of the scan are at the rim of a hole.
std::vector<char> rim_of(MeshView scan) {
    std::vector<char> rim(static_cast<std::size_t>(scan.n_vertices()), 0);
    for (const auto& [a, b] : mesh::boundary_edges(mesh::EdgeTable(scan)))
        rim[static_cast<std::size_t>(a)] = rim[static_cast<std::size_t>(b)] = 1;
    return rim;
}

Vector distances(PointsView points, const numerics::ClosestTriangle& surface) {
    Vector result(points.rows());
    parallel_for(static_cast<std::size_t>(points.rows()), 64, [&](std::size_t i) {
        const auto v = static_cast<Eigen::Index>(i);
        result[v] = std::sqrt(surface.closest(points.row(v).transpose()).squared_distance);
    });
    return result;
}

// One fit: positions, and what draws them.
class SurfaceFit {
  public:
    SurfaceFit(MeshView model, MeshView scan, const SurfaceMap& map, const FitOptions& options)
        : options_(options),
          scan_(scan),
          rest_(similar(model, scan, map)),
          now_(rest_.vertices),
          area_(vertex_areas(rest_)),
          rest_triangle_area_(triangle_areas(rest_)),
          neighbors_(neighbor_triangles(mesh::EdgeTable(model))),
          closest_(scan.vertices, scan.triangles),
          rim_(rim_of(scan)),
          size_(mesh::surface_box(scan).diagonal().norm()),
          hold_(Vector::Ones(model.n_vertices())),
          elastic_(rest_) {
        for (const SurfacePoint& point : map.image) matched_.push_back(point.matched());
        own_folds_ = folded(now_);
        orientation_ = orientation(map);
    }

    FitResult run(const SurfaceMap& map) {
        const double finest = options_.stiffness * mean_edge_length(rest_);
        int done = 0;
        const int all = static_cast<int>(map_lengths.size()) + surface_levels + mending_rounds;
        const auto tick = [&] { report_progress(options_.progress, static_cast<double>(++done) / all); };
        for (const double length : map_lengths) {
            towards_images(map, std::max(length * size_, finest));
            tick();
        }
        const double first = std::max(map_lengths.back() * size_, finest);
        for (int level = 0; level < surface_levels; ++level) {
            const double share = static_cast<double>(level) / (surface_levels - 1);
            const double length = first * std::pow(finest / first, share);
            for (int round = 0; round < rounds_per_level; ++round) {
                towards_surface(length);
                let_go(corners_of(spoiled(), 0), letting_go, recovery);
            }
            tick();
        }
        mend(finest, tick);
        report_progress(options_.progress, 1);
        return measured();
    }

  private:
    // The template moved onto its images as a whole.
    static TriangleMesh similar(MeshView model, MeshView scan, const SurfaceMap& map) {
        std::vector<Index> matched;
        for (Index v = 0; v < model.n_vertices(); ++v)
            if (map[v].matched()) matched.push_back(v);
        if (matched.size() < 3)
            throw InvalidInput("fit: the map matches fewer than three vertices of the template");
        const Points images = image_positions(map, scan);
        const Affine whole = fit_transform(Points(model.vertices(matched, Eigen::all)),
                                           Points(images(matched, Eigen::all)), TransformModel::similarity);
        return {whole(Points(model.vertices)), model.triangles};
    }

    // +1 or -1 where the two surfaces' normals agree or disagree; 0 where the scan's are not to be trusted.
    int orientation(const SurfaceMap& map) {
        // The pose differs, so it takes the template in the scan's pose to tell.
        towards_images(map, map_lengths.front() * size_);
        const Points normals = vertex_normals({now_, rest_.triangles});
        double sum = 0, count = 0;
        for (Index v = 0; v < map.source_size(); ++v) {
            if (!map[v].matched()) continue;
            sum += normals.row(v).dot(closest_.normals().row(map[v].triangle)) > 0 ? 1 : -1;
            ++count;
        }
        constexpr double trusted = 0.4;  // of agreeing less disagreeing normals
        return std::abs(sum) < trusted * count ? 0 : sum > 0 ? 1 : -1;
    }

    void add_landmarks(Points& towards, Vector& pull, double length) const {
        for (const auto& [from, to] : options_.landmarks) {
            towards.row(from) = scan_.vertices.row(to);
            pull[from] = landmark_weight * area_.mean() / (length * length);
        }
    }

    void towards_images(const SurfaceMap& map, double length) {
        Points towards = image_positions(map, scan_);
        Vector pull = Vector::Zero(now_.rows());
        const double doubtful = image_doubt * size_;
        for (Index v = 0; v < map.source_size(); ++v) {
            if (!map[v].matched()) continue;
            const double off = (towards.row(v) - now_.row(v)).norm() / doubtful;
            const double trust = has_moved_ ? 1 / (1 + off * off) : 1;
            pull[v] = trust * area_[v] / (length * length);
        }
        add_landmarks(towards, pull, length);
        now_ = elastic_.drawn(towards, pull, now_, rounds_per_map_length);
        has_moved_ = true;
    }

    void towards_surface(double length, const std::vector<char>& spoiled = {}) {
        const Points normals = vertex_normals({now_, rest_.triangles});
        Points towards = now_;
        Vector pull = Vector::Zero(now_.rows());
        reached_.assign(static_cast<std::size_t>(now_.rows()), 0);
        parallel_for(reached_.size(), 64, [&](std::size_t i) {
            const auto v = static_cast<Eigen::Index>(i);
            const Eigen::Vector3d normal = orientation_ * normals.row(v).transpose();
            const double radius =
                std::min(options_.reach * size_, length * (matched_[i] ? matched_reach : unmatched_reach));
            const numerics::ClosestPoint found =
                orientation_ == 0 ? closest_.closest(now_.row(v).transpose(), radius)
                                  : closest_.closest(now_.row(v).transpose(), normal, least_cosine, radius);
            if (found.triangle < 0 || is_at_rim(found)) return;
            reached_[i] = 1;
            towards.row(v) = closest_.position(found).transpose();
            pull[v] = hold_[v] * area_[v] / (length * length);
        });
        add_landmarks(towards, pull, length);
        now_ = elastic_.drawn(towards, pull, now_, 1, spoiled);
    }

    bool is_at_rim(const numerics::ClosestPoint& point) const {
        for (int c = 0; c < 3; ++c)
            if (point.weights[c] > 0 && !rim_[static_cast<std::size_t>(scan_.triangles(point.triangle, c))])
                return false;
        return true;
    }

    std::vector<char> folded(PointsView vertices) const {
        const Points normals = triangle_normals({vertices, rest_.triangles});
        std::vector<char> result(neighbors_.size(), 0);
        for (std::size_t e = 0; e < neighbors_.size(); ++e)
            result[e] = normals.row(neighbors_[e].first).dot(normals.row(neighbors_[e].second)) < 0;
        return result;
    }

    // Patches around spoiled triangles turn as their surroundings do and let go of the scan, and they grow;
    // the best of the rounds is kept.
    template <typename Tick>
    void mend(double length, const Tick& tick) {
        Points best = now_;
        double least_harm = std::numeric_limits<double>::infinity();
        for (int round = 0;; ++round) {
            const std::vector<char> bad = spoiled();
            const auto n_bad = std::count(bad.begin(), bad.end(), 1);
            const auto n_vanishing = (area_ratios().array() < vanishing).count();
            const double harm =
                static_cast<double>(n_bad) + vanishing_harm * static_cast<double>(n_vanishing);
            if (harm < least_harm) {
                least_harm = harm;
                best = now_;
            }
            if (n_bad == 0 || round == mending_rounds) break;
            const std::vector<char> patch = corners_of(bad, 1 + round / rounds_per_ring);
            let_go(corners_of(bad, 0), letting_go, 1);
            let_go(patch, letting_go_around, 1);
            towards_surface(length, patch);
            tick();
        }
        now_ = std::move(best);
    }

    // The corners of these triangles, and the vertices up to so many edges from them.
    std::vector<char> corners_of(const std::vector<char>& triangles, int rings) const {
        std::vector<char> of_triangle = triangles, of_vertex(static_cast<std::size_t>(now_.rows()), 0);
        for (int ring = 0; ring <= rings; ++ring) {
            for (Index t = 0; t < rest_.n_triangles(); ++t)
                if (of_triangle[static_cast<std::size_t>(t)])
                    for (const Index v : rest_.triangles.row(t)) of_vertex[static_cast<std::size_t>(v)] = 1;
            for (Index t = 0; t < rest_.n_triangles(); ++t)
                for (const Index v : rest_.triangles.row(t))
                    if (of_vertex[static_cast<std::size_t>(v)]) of_triangle[static_cast<std::size_t>(t)] = 1;
        }
        return of_vertex;
    }

    // The triangles' areas relative to those in the template, both relative to the whole surface; 1 for those
    // that have none there.
    Vector area_ratios() const {
        const Vector areas = triangle_areas({now_, rest_.triangles});
        const double whole = areas.sum() / rest_triangle_area_.sum();
        return (rest_triangle_area_.array() > 0)
            .select(areas.array() / rest_triangle_area_.array() / whole, 1);
    }

    // The triangles that collapse, or fold where the template does not.
    std::vector<char> spoiled() const {
        const Vector ratios = area_ratios();
        std::vector<char> bad(static_cast<std::size_t>(ratios.size()), 0);
        for (Eigen::Index t = 0; t < ratios.size(); ++t)
            bad[static_cast<std::size_t>(t)] = ratios[t] < collapsing;
        const std::vector<char> folds = folded(now_);
        for (std::size_t e = 0; e < neighbors_.size(); ++e) {
            if (!folds[e] || own_folds_[e]) continue;
            bad[static_cast<std::size_t>(neighbors_[e].first)] = 1;
            bad[static_cast<std::size_t>(neighbors_[e].second)] = 1;
        }
        return bad;
    }

    // These vertices keep a share of their hold on the scan, the others regain theirs by a factor.
    void let_go(const std::vector<char>& vertices, double kept, double regained) {
        for (Eigen::Index v = 0; v < hold_.size(); ++v)
            hold_[v] =
                vertices[static_cast<std::size_t>(v)] ? hold_[v] * kept : std::min(1.0, hold_[v] * regained);
    }

    FitResult measured() const {
        FitResult result;
        result.vertices = now_;
        result.distance = distances(now_, closest_);
        result.scan_distance = distances(scan_.vertices, {now_, rest_.triangles});
        result.scan_diagonal = size_;
        const auto share = [&](const std::vector<char>& folds) {
            return folds.empty() ? 0.0
                                 : static_cast<double>(std::count(folds.begin(), folds.end(), 1)) /
                                       static_cast<double>(folds.size());
        };
        result.folded_edges = share(folded(now_));
        result.own_folded_edges = share(own_folds_);
        result.least_area_ratio = std::min(1.0, area_ratios().minCoeff());
        result.n_free = static_cast<Index>(std::count(reached_.begin(), reached_.end(), 0));
        return result;
    }

    const FitOptions& options_;
    const MeshView scan_;
    const TriangleMesh rest_;
    Points now_;
    const Vector area_, rest_triangle_area_;
    const std::vector<std::pair<Index, Index>> neighbors_;
    const numerics::ClosestTriangle closest_;
    const std::vector<char> rim_;
    const double size_;
    Vector hold_;  // 1: to the scan as much as its area says; less where the surface would be spoiled
    ElasticSurface elastic_;
    std::vector<char> matched_, own_folds_, reached_;
    int orientation_ = 0;
    bool has_moved_ = false;
};

}  // namespace

FitResult fit_surface(MeshView model, MeshView scan, const SurfaceMap& scan_from_model,
                      const FitOptions& options) {
    require_fit(model, scan, scan_from_model, options);
    FitResult result;
    with_threads(options.n_threads,
                 [&] { result = SurfaceFit(model, scan, scan_from_model, options).run(scan_from_model); });
    return result;
}

}  // namespace counterpart
