// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/uv/locate.hpp"

#include "base/parallel.hpp"
#include "base/to_size.hpp"

#include <counterpart/align/transform.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace counterpart::uv {
namespace {

using How = Located::How;

// A place of the mesh that has the coordinates of a corner.
struct Hit {
    Index chart;
    SurfacePoint point;
    double outside;
    Eigen::RowVector3d position;
};

struct Hits {
    std::vector<Hit> places{};
    bool too_many = false;
};

// Finds the places in a layout that a corner of another one may be at.
class Search {
  public:
    Search(const Layout& from, const Layout& to, double reach, double near)
        : from_(from), to_(to), reach_(reach), near_(near) {}

    // All that are within a chart, or else the one nearest to a chart.
    Hits operator()(const Corner& corner) const {
        constexpr double rounding = 1e-6, same_way = 0;  // files hold floats, or six digits
        constexpr std::size_t most_triangles = 1024, most_places = 64;
        const Eigen::Vector3d here = from_.at(corner.row), normal = from_.facing(corner);
        const auto inside =
            to_.plane().all_within(here, normal, same_way, rounding * to_.size(), most_triangles);
        Hits hits;
        for (const numerics::ClosestPoint& point : inside) {
            const Hit hit = hit_of(point, 0);
            const bool is_new = std::none_of(hits.places.begin(), hits.places.end(), [&](const Hit& other) {
                return (other.position - hit.position).norm() <= near_;
            });
            if (is_new) hits.places.push_back(hit);
            hits.too_many = inside.size() > most_triangles || hits.places.size() > most_places;
            if (hits.too_many) return hits;
        }
        if (!inside.empty()) return hits;
        const numerics::ClosestPoint nearest = to_.plane().closest(here, normal, same_way, reach_);
        if (nearest.triangle >= 0)
            hits.places.push_back(hit_of(nearest, std::sqrt(nearest.squared_distance)));
        return hits;
    }

  private:
    Hit hit_of(const numerics::ClosestPoint& point, double outside) const {
        const MeshView mesh = to_.mesh();
        Hit hit{to_.chart(point.triangle), {to_.triangle(point.triangle), point.weights}, outside, {}};
        hit.position.setZero();
        for (int c = 0; c < 3; ++c)
            hit.position += point.weights[c] * mesh.vertices.row(mesh.triangles(hit.point.triangle, c));
        return hit;
    }

    const Layout &from_, &to_;
    double reach_, near_;
};

// The vertices of `from` laid on the mesh of `to`, as those with one place say.
Points laid_on(const Layout& from, const std::vector<Hits>& hits) {
    std::vector<Index> vertices;
    std::vector<Eigen::RowVector3d> places;
    for (std::size_t i = 0; i < hits.size(); ++i) {
        if (hits[i].too_many || hits[i].places.size() != 1 || hits[i].places[0].outside > 0) continue;
        vertices.push_back(from.corners()[i].vertex);
        places.push_back(hits[i].places[0].position);
    }
    if (places.empty()) return from.mesh().vertices;
    Points images(static_cast<Index>(places.size()), 3);
    for (std::size_t i = 0; i < places.size(); ++i) images.row(static_cast<Index>(i)) = places[i];
    const Points sources = from.mesh().vertices(vertices, Eigen::all);
    // Where they lie on a line, as little is turned as can be.
    const double little = 1e-9 * (sources.rowwise() - sources.colwise().mean()).squaredNorm();
    return kabsch(sources, images, {}, {.with_scale = true, .prior_weight = little})(from.mesh().vertices);
}

// How near the corners of a chart are to their places in another one.
struct Nearness {
    double n = 0, sum = 0;
    double mean() const { return sum / n; }
};

class Decision {
  public:
    Decision(const Layout& from, const std::vector<Hits>& hits)
        : from_(from), hits_(hits), laid_(laid_on(from, hits)) {
        for (std::size_t i = 0; i < hits.size(); ++i) {
            std::map<Index, double> nearest;
            for (const Hit& hit : hits[i].places) {
                const auto [least, is_new] = nearest.try_emplace(hit.chart, distance(i, hit));
                if (!is_new) least->second = std::min(least->second, distance(i, hit));
            }
            for (const auto& [chart, least] : nearest) {
                Nearness& pair = nearness_[{from.corners()[i].chart, chart}];
                pair.n += 1;
                pair.sum += least;
            }
        }
    }

    Located operator()(std::size_t i) const {
        const Corner& corner = from_.corners()[i];
        if (hits_[i].too_many) return {corner, How::undecided, {}, 0};
        std::vector<Hit> places = hits_[i].places;
        if (places.empty()) return {corner, How::nowhere, {}, 0};
        // A chart that merely laps over the edge of another one is no rival.
        const auto of = [&](const Hit& hit) { return nearness_.at({corner.chart, hit.chart}); };
        double most = 0;
        for (const Hit& hit : places) most = std::max(most, of(hit).n);
        std::erase_if(places, [&](const Hit& hit) { return of(hit).n < most / 2; });
        std::sort(places.begin(), places.end(), [&](const Hit& a, const Hit& b) {
            return std::tuple(of(a).mean(), a.chart, distance(i, a), a.point.triangle) <
                   std::tuple(of(b).mean(), b.chart, distance(i, b), b.point.triangle);
        });
        const Hit& best = places[0];
        constexpr double clearly = 2;  // times as far
        const bool is_clear = std::all_of(places.begin() + 1, places.end(), [&](const Hit& other) {
            return other.chart == best.chart ? distance(i, other) > clearly * distance(i, best)
                                             : of(other).mean() > clearly * of(best).mean();
        });
        if (!is_clear) return {corner, How::undecided, {}, 0};
        return {corner, places.size() == 1 ? How::surely : How::by_place, best.point, best.outside};
    }

  private:
    double distance(std::size_t i, const Hit& hit) const {
        return (laid_.row(from_.corners()[i].vertex) - hit.position).norm();
    }

    const Layout& from_;
    const std::vector<Hits>& hits_;
    Points laid_;
    std::map<std::pair<Index, Index>, Nearness> nearness_;  // by the charts of both
};

}  // namespace

std::vector<Located> locate(const Layout& from, const Layout& to, double reach, double near) {
    std::vector<Hits> hits(from.corners().size());
    const Search search(from, to, reach, near);
    parallel_for(hits.size(), 64, [&](std::size_t i) { hits[i] = search(from.corners()[i]); });
    const Decision decide(from, hits);
    std::vector<Located> result(hits.size());
    parallel_for(result.size(), 256, [&](std::size_t i) { result[i] = decide(i); });
    return result;
}

}  // namespace counterpart::uv
