// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Polygons and solids, and the claim of Sahillioglu and Yemez that frontiers adapt to other dimensions d:
// their number grows as V^(1/d).
//
//     connectivity [--large | --solids A B]
//
// One JSON line per measurement: exact and frontiers between a generated mesh and its bent and shuffled copy
// on one thread, in processor seconds; then the exponents p of frontiers ~ V^p and of seconds ~ V^p that fit
// the meshes of each dimension. --large adds solids of half a million tetrahedra. --solids: the error of the
// spectral map between two tetrahedralizations of one solid, of which the second is bent, on the surface and
// inside, and how close the nearest vertex is; in hundredths of the square root of the surface's area.
#include <counterpart/frontier/frontiers.hpp>
#include <counterpart/io/mesh_file.hpp>
#include <counterpart/match/volume.hpp>
#include <counterpart/mesh/measure.hpp>
#include <counterpart/mesh/shapes.hpp>
#include <counterpart/mesh/variants.hpp>

#include <cmath>
#include <cstdio>
#include <ctime>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace {

using namespace counterpart;
using Json = nlohmann::ordered_json;

template <class Work>
double processor_seconds(const Work& work) {
    double least = 1e300;
    for (int i = 0; i < 3; ++i) {
        const std::clock_t start = std::clock();
        work();
        least = std::min(least, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    }
    return least;
}

double share_right(const std::vector<Index>& truth, const VertexMap& map) {
    double right = 0;
    for (std::size_t v = 0; v < truth.size(); ++v) right += truth[v] == map[static_cast<Index>(v)] ? 1 : 0;
    return right / static_cast<double>(truth.size());
}

// Logarithms of what is fitted, over that of V.
struct Series {
    std::vector<double> log_v, log_frontiers, log_seconds;

    static double slope(const std::vector<double>& x, const std::vector<double>& y) {
        double mean_x = 0, mean_y = 0, xy = 0, xx = 0;
        const auto n = static_cast<double>(x.size());
        for (std::size_t i = 0; i < x.size(); ++i) mean_x += x[i] / n, mean_y += y[i] / n;
        for (std::size_t i = 0; i < x.size(); ++i) {
            xy += (x[i] - mean_x) * (y[i] - mean_y);
            xx += (x[i] - mean_x) * (x[i] - mean_x);
        }
        return xy / xx;
    }
};

void add(Series& series, Index n_vertices, Index n_frontiers, double seconds, Json line) {
    series.log_v.push_back(std::log(n_vertices));
    series.log_frontiers.push_back(std::log(n_frontiers));
    series.log_seconds.push_back(std::log(std::max(seconds, 1e-6)));
    line["vertices"] = n_vertices;
    line["frontiers"] = n_frontiers;
    line["seconds"] = seconds;
    std::puts(line.dump().c_str());
    std::fflush(stdout);
}

void fit(int dimension, const Series& series) {
    std::puts(Json({{"dimension", dimension},
                    {"frontiers_exponent", Series::slope(series.log_v, series.log_frontiers)},
                    {"expected_exponent", 1.0 / dimension},
                    {"seconds_exponent", Series::slope(series.log_v, series.log_seconds)}})
                  .dump()
                  .c_str());
}

// A curve has one or two vertices in each frontier, so there is nothing to match but to count.
void measure_curves() {
    Series series;
    for (const Index n : {1000, 4000, 16000, 64000}) {
        TriangleMesh curve{Points::Zero(n, 3), Triangles(n - 1, 3)};
        for (Index i = 0; i + 1 < n; ++i) curve.triangles.row(i) << i, i + 1, i + 1;
        Index count = 0;
        const double seconds = processor_seconds([&] { count = bfs_frontiers(Adjacency(curve), 0).count(); });
        add(series, n, count, seconds,
            {{"dimension", 1}, {"mesh", "curve"}, {"method", "breadth-first search"}});
    }
    fit(1, series);
}

void measure_surfaces() {
    Series series;
    for (const int subdivisions : {1, 2, 3, 4}) {
        const TriangleMesh source = make_body({.subdivisions = subdivisions});
        const ShuffleResult target = shuffle(deform(source, {.bend = 0.8}), 2);
        FrontiersResult result;
        const double seconds =
            processor_seconds([&] { result = match_frontiers(source, target.mesh, {.n_threads = 1}); });
        add(series, source.n_vertices(), result.components.at(0).n_frontiers, seconds,
            {{"dimension", 2},
             {"mesh", "body"},
             {"method", "frontiers"},
             {"right", share_right(target.shuffled_from_original, result.target_from_source)}});
    }
    fit(2, series);
}

// Bent about z.
TetrahedralMesh bent(TetrahedralMesh solid) {
    constexpr double curvature = 0.8;
    for (auto row : solid.vertices.rowwise()) {
        const double angle = curvature * row[0], radius = 1 / curvature + row[1];
        row << radius * std::sin(angle), radius * std::cos(angle), row[2];
    }
    return solid;
}

void measure_solids(bool large) {
    Series series;
    for (const int cells : {24, 36, 54, 81, 122}) {
        if (cells > 81 && !large) continue;
        const TetrahedralMesh source = fill_with_tetrahedra(make_body({.subdivisions = 2}), cells);
        const TetrahedralShuffleResult target = shuffle(bent(source), 2);
        for (const MatchMethod method : {MatchMethod::exact, MatchMethod::frontiers}) {
            VolumeResult result;
            const double seconds = processor_seconds(
                [&] { result = match_volume(source, target.mesh, {.method = method, .n_threads = 1}); });
            Json line = {
                {"dimension", 3},
                {"mesh", "solid body"},
                {"method", to_string(method)},
                {"tetrahedra", source.n_tetrahedra()},
                {"right", result.method == MatchMethod::exact && !result.identical
                              ? 0
                              : share_right(target.shuffled_from_original, result.target_from_source)}};
            if (method == MatchMethod::frontiers) {
                add(series, source.n_vertices(), result.frontiers->components.at(0).n_frontiers, seconds,
                    line);
                continue;
            }
            line["vertices"] = source.n_vertices();
            line["seconds"] = seconds;
            std::puts(line.dump().c_str());
        }
    }
    fit(3, series);
}

struct MeanError {
    double of_map = 0, of_nearest = 0;
    Index count = 0;
    void add(double map, double nearest) {
        of_map += map;
        of_nearest += nearest;
        ++count;
    }
    Json json() const {
        return {{"vertices", count}, {"mean_error", of_map / count}, {"nearest_vertex", of_nearest / count}};
    }
};

int measure_solids_of_files(const char* first, const char* second) {
    const auto source = read_tetrahedral_mesh(first), rest = read_tetrahedral_mesh(second);
    if (!source || !rest) return 1;
    const TetrahedralMesh target = bent(rest->mesh);
    const Points truth = bent(source->mesh).vertices;
    const VolumeResult result = match_volume(source->mesh, target, {.method = MatchMethod::spectral});
    const double unit = std::sqrt(surface_area(boundary(target).mesh)) / 100;
    std::vector<char> is_outside(static_cast<std::size_t>(source->mesh.n_vertices()), 0);
    for (const Index v : boundary(source->mesh).vertices) is_outside[static_cast<std::size_t>(v)] = 1;
    MeanError outside, all;
    for (Index v = 0; v < source->mesh.n_vertices(); ++v) {
        const Index w = result.target_from_source[v];
        if (w < 0) continue;
        const Vector distances = (target.vertices.rowwise() - truth.row(v)).rowwise().norm() / unit;
        all.add(distances[w], distances.minCoeff());
        if (is_outside[static_cast<std::size_t>(v)]) outside.add(distances[w], distances.minCoeff());
    }
    std::puts(Json({{"mesh", "two tetrahedralizations"},
                    {"tetrahedra", {source->mesh.n_tetrahedra(), target.n_tetrahedra()}},
                    {"surface", outside.json()},
                    {"all", all.json()}})
                  .dump()
                  .c_str());
    return 0;
}

// Each triangle in three quads.
TriangleMesh quads_of(MeshView mesh) {
    const TriangleMesh fine = subdivide(mesh);
    std::vector<Index> sizes, corners;
    Points vertices(fine.n_vertices() + mesh.n_triangles(), 3);
    vertices.topRows(fine.n_vertices()) = fine.vertices;
    for (Index t = 0; t < mesh.n_triangles(); ++t) {
        const auto middle = fine.triangles.row(4 * t + 3);
        const Index center = fine.n_vertices() + t;
        vertices.row(center) =
            (fine.vertices.row(middle[0]) + fine.vertices.row(middle[1]) + fine.vertices.row(middle[2])) / 3;
        for (Index k = 0; k < 3; ++k) {
            const auto corner = fine.triangles.row(4 * t + k);
            sizes.push_back(4);
            corners.insert(corners.end(), {corner[0], corner[1], center, corner[2]});
        }
    }
    return cut_into_triangles(vertices, sizes, corners);
}

void measure_polygons() {
    for (const int subdivisions : {1, 2, 3}) {
        const TriangleMesh source =
            quads_of(deform(make_body({.subdivisions = subdivisions}), {.warp = 0.1}));
        const ShuffleResult target = shuffle(source, 2);
        ExactResult result;
        const double seconds =
            processor_seconds([&] { result = match_exact(source, target.mesh, {.n_threads = 1}); });
        std::puts(Json({{"mesh", "quads"},
                        {"method", "exact"},
                        {"polygons", source.polygons.count()},
                        {"cut_differently", result.recut_polygons},
                        {"right", share_right(target.shuffled_from_original, result.target_from_source)},
                        {"seconds", seconds}})
                      .dump()
                      .c_str());
    }
}

}  // namespace

int main(int argc, char** argv) {
    if (argc == 4 && std::string(argv[1]) == "--solids") return measure_solids_of_files(argv[2], argv[3]);
    const bool large = argc > 1 && std::string(argv[1]) == "--large";
    measure_polygons();
    measure_curves();
    measure_surfaces();
    measure_solids(large);
}
