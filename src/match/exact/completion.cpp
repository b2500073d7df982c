// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/exact/completion.hpp"

#include <counterpart/mesh/adjacency.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace counterpart {
namespace {

using Triple = std::array<Index, 3>;

std::size_t place(Index i) { return static_cast<std::size_t>(i); }

Triple corners(const TriangleMesh& mesh, Index t) {
    return {mesh.triangles(t, 0), mesh.triangles(t, 1), mesh.triangles(t, 2)};
}
Triple sorted(Triple t) {
    std::sort(t.begin(), t.end());
    return t;
}

std::vector<Index> inverse(const VertexMap& map) {
    std::vector<Index> source_from_target(place(map.target_size), -1);
    for (std::size_t v = 0; v < map.image.size(); ++v)
        if (map.image[v] >= 0) source_from_target[place(map.image[v])] = static_cast<Index>(v);
    return source_from_target;
}

// Faces with one or two matched corners, in source vertex numbers, from the first matched corner on (of two:
// the one that the other follows); -1 for unmatched corners. What hangs at the same place has the same key.
using Key = std::array<Index, 2>;
struct Hanging {
    Key key;
    Triple vertices;  // of its own mesh, in that order
};

std::optional<Hanging> hanging(const Triple& vertices, const Triple& names) {
    const auto n_matched = std::count_if(names.begin(), names.end(), [](Index n) { return n >= 0; });
    if (n_matched == 0 || n_matched == 3) return std::nullopt;
    std::size_t c = 0;
    while (names[c] < 0 || (n_matched == 2 && names[(c + 1) % 3] < 0)) ++c;
    return Hanging{{names[c], names[(c + 1) % 3]},
                   {vertices[c], vertices[(c + 1) % 3], vertices[(c + 2) % 3]}};
}

std::map<Key, std::vector<Triple>> hanging_faces(const TriangleMesh& mesh, bool turned, const auto& name) {
    std::map<Key, std::vector<Triple>> faces;
    for (Index t = 0; t < mesh.n_triangles(); ++t) {
        Triple v = corners(mesh, t);
        if (turned) std::swap(v[1], v[2]);
        if (const auto found = hanging(v, {name(v[0]), name(v[1]), name(v[2])}))
            faces[found->key].push_back(found->vertices);
    }
    return faces;
}

class ShapeJudge {
  public:
    ShapeJudge(const TriangleMesh& source, const TriangleMesh& target)
        : source_(source), target_(target), around_(place(source.n_vertices())) {
        for (Index t = 0; t < source.n_triangles(); ++t)
            for (const Index v : corners(source, t)) around_[place(v)].push_back(t);
        for (Index t = 0; t < target.n_triangles(); ++t) faces_.push_back(sorted(corners(target, t)));
        std::sort(faces_.begin(), faces_.end());
    }

    // The usual ratio of lengths, from the whole map.
    void set_scale(const VertexMap& map) {
        std::vector<double> ratios;
        for (Index t = 0; t < source_.n_triangles(); ++t) {
            const Triple v = corners(source_, t);
            const double a = length(source_, v[0], v[1]);
            if (a > 0 && map[v[0]] >= 0 && map[v[1]] >= 0) {
                const double b = length(target_, map[v[0]], map[v[1]]);
                if (b > 0) ratios.push_back(b / a);
            }
        }
        if (ratios.empty()) return;
        const auto middle = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2);
        std::nth_element(ratios.begin(), middle, ratios.end());
        scale_ = *middle;
    }

    // How well source vertex v fits target vertex w: the number of triangles around it that have a
    // counterpart, each weighted by how well its edge lengths agree (1 to 0).
    double fit(const VertexMap& map, Index v, Index w) const {
        double sum = 0;
        for (const Index t : around_[place(v)]) {
            const Triple from = corners(source_, t);
            Triple to{};
            for (std::size_t c = 0; c < 3; ++c) to[c] = from[c] == v ? w : map[from[c]];
            if (*std::min_element(to.begin(), to.end()) < 0 ||
                !std::binary_search(faces_.begin(), faces_.end(), sorted(to)))
                continue;
            double worst = 0;
            for (std::size_t c = 0; c < 3; ++c) {
                const double a = scale_ * length(source_, from[c], from[(c + 1) % 3]),
                             b = length(target_, to[c], to[(c + 1) % 3]);
                if (a > 0 && b > 0) worst = std::max(worst, std::abs(std::log(a / b)));
            }
            sum += std::exp(-std::pow(worst / tolerance, 2));
        }
        return sum;
    }

    // The triangles around a vertex, and those of them that have a counterpart.
    struct Support {
        int n_matched = 0, n_triangles = 0;
        bool is_whole() const { return n_matched == n_triangles; }
    };
    Support support(const VertexMap& map, Index v) const {
        Support result;
        for (const Index t : around_[place(v)]) {
            const Triple from = corners(source_, t);
            const Triple to{map[from[0]], map[from[1]], map[from[2]]};
            result.n_matched += std::binary_search(faces_.begin(), faces_.end(), sorted(to));
            ++result.n_triangles;
        }
        return result;
    }

  private:
    static constexpr double tolerance = 0.3;  // logarithm of a ratio of lengths

    static double length(const TriangleMesh& mesh, Index a, Index b) {
        return (mesh.vertices.row(a) - mesh.vertices.row(b)).norm();
    }

    const TriangleMesh& source_;
    const TriangleMesh& target_;
    std::vector<std::vector<Index>> around_;
    std::vector<Triple> faces_;
    double scale_ = 1;
};

}  // namespace

VertexMap with_hanging_faces(const TriangleMesh& source, const TriangleMesh& target, VertexMap map,
                             bool turned) {
    for (bool more = true; more;) {
        more = false;
        std::vector<Index> name = inverse(map);
        const auto in_source =
            hanging_faces(source, turned, [&](Index v) { return map[v] >= 0 ? v : VertexMap::unmatched; });
        const auto in_target = hanging_faces(target, false, [&](Index w) { return name[place(w)]; });
        for (const auto& [key, faces] : in_source) {
            const auto others = in_target.find(key);
            if (faces.size() != 1 || others == in_target.end() || others->second.size() != 1) continue;
            const Triple &v = faces[0], &w = others->second[0];
            bool fits = true;
            for (std::size_t c = 0; c < 3; ++c)
                fits = fits && (map[v[c]] == w[c] || (map[v[c]] < 0 && name[place(w[c])] < 0));
            if (!fits) continue;
            for (std::size_t c = 0; c < 3; ++c) {
                map.image[place(v[c])] = w[c];
                name[place(w[c])] = v[c];
            }
            more = true;
        }
    }
    return map;
}

VertexMap with_better_shape(const TriangleMesh& source, const TriangleMesh& target, VertexMap map) {
    constexpr double margin = 0.5;  // of a triangle
    constexpr int clear_gain = 2;   // triangles, whatever their lengths: poses change those
    const Adjacency in_source(source), in_target(target);
    ShapeJudge judge(source, target);
    judge.set_scale(map);
    for (Index v = 0; v < source.n_vertices(); ++v) {
        if (map[v] >= 0) continue;
        for (const Index rival : in_source.neighbors(v)) {
            const Index w = map[rival];
            if (w < 0) continue;
            const double now = judge.fit(map, rival, w);
            const int matched_now = judge.support(map, rival).n_matched;
            map.image[place(rival)] = VertexMap::unmatched;
            map.image[place(v)] = w;
            const double then = judge.fit(map, v, w);
            const bool better =
                then > now + margin ||
                (then > now - margin && judge.support(map, v).n_matched >= matched_now + clear_gain);
            if (!better) std::swap(map.image[place(v)], map.image[place(rival)]);
            if (better) break;
        }
    }
    // Two neighbours may each have the other's partner. Exchanging them must bring more triangles together.
    for (Index v = 0; v < source.n_vertices(); ++v) {
        if (map[v] < 0 || judge.support(map, v).is_whole()) continue;
        for (const Index rival : in_source.neighbors(v)) {
            if (map[rival] < 0 || judge.support(map, rival).is_whole()) continue;
            const auto n_matched = [&] {
                return judge.support(map, v).n_matched + judge.support(map, rival).n_matched;
            };
            const int now = n_matched();
            std::swap(map.image[place(v)], map.image[place(rival)]);
            if (n_matched() > now) break;
            std::swap(map.image[place(v)], map.image[place(rival)]);
        }
    }
    std::vector<Index> name = inverse(map);
    for (Index w = 0; w < target.n_vertices(); ++w) {
        if (name[place(w)] >= 0) continue;
        for (const Index rival : in_target.neighbors(w)) {
            const Index v = name[place(rival)];
            if (v < 0 || judge.fit(map, v, w) <= judge.fit(map, v, rival) + margin) continue;
            map.image[place(v)] = w;
            name[place(rival)] = -1;
            name[place(w)] = v;
            break;
        }
    }
    return map;
}

}  // namespace counterpart
