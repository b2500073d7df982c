// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Smooth functions there and back through a map and its inverse:
//
//     round_trip FOLDER PAIRS truth|spectral [FUNCTIONS]
//
// FOLDER holds NAME.off and corres/NAME.vts (line k of any two name the same point, from 1), PAIRS two names
// a line. For each pair A B: a vertex map from A to B, from the truth or found by the spectral method; the
// first FUNCTIONS (20) Laplacian eigenfunctions of A (the constant left out) are carried to B and back.
// Relative L2 errors in percent: through the sub-vertex map and its inverse, and beside them through the
// vertices closest to their points. One JSON line per pair, a summary last.
#include <counterpart/evaluation/evaluate.hpp>
#include <counterpart/io/map_file.hpp>
#include <counterpart/io/mesh_file.hpp>
#include <counterpart/map/complete.hpp>
#include <counterpart/map/invert.hpp>
#include <counterpart/map/project.hpp>
#include <counterpart/match/spectral.hpp>
#include <counterpart/spectral/eigen_basis.hpp>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <string>

#include <nlohmann/json.hpp>

namespace {

using namespace counterpart;
using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

// A source vertex that several template points name goes where the first of them goes; those that none names
// are unmatched.
VertexMap map_from_truth(const fs::path& folder, const std::string& a, const std::string& b, Index a_size,
                         Index b_size) {
    const auto read = [&](const std::string& name) {
        return read_vertex_map(folder / "corres" / (name + ".vts"), IndexBase::one);
    };
    std::vector<Index> map(static_cast<std::size_t>(a_size), VertexMap::unmatched);
    const GroundTruth truth = truth_from_template(read(a), read(b));
    for (auto pair = truth.pairs.rbegin(); pair != truth.pairs.rend(); ++pair)
        map[static_cast<std::size_t>(pair->first)] = pair->second;
    return {std::move(map), b_size};
}

Vector relative_errors(const Matrix& before, const Matrix& after, const Vector& mass) {
    const auto norms = [&](const Matrix& values) -> Vector {
        return (mass.asDiagonal() * values.cwiseAbs2()).colwise().sum().cwiseSqrt().transpose();
    };
    return 100 * norms(after - before).cwiseQuotient(norms(before));
}

struct ThereAndBack {
    SurfaceMap there, back;  // complete
};

// What is left unmatched follows its neighbors: there must be a value everywhere.
ThereAndBack sub_vertex_maps(const TriangleMesh& a, const TriangleMesh& b, const VertexMap& b_from_a) {
    const MapPair pair = with_inverse(project_map(a, b, b_from_a, {.extend = 10}), a, b);
    return {complete_map(pair.target_from_source, a, b).target_from_source,
            complete_map(pair.source_from_target, b, a).target_from_source};
}

Json measure(const fs::path& folder, const std::string& a_name, const std::string& b_name,
             const std::string& which, int n_functions) {
    const TriangleMesh a = read_mesh(folder / (a_name + ".off")).mesh;
    const TriangleMesh b = read_mesh(folder / (b_name + ".off")).mesh;
    const VertexMap map = which == "truth"
                              ? map_from_truth(folder, a_name, b_name, a.n_vertices(), b.n_vertices())
                              : match_spectral(a, b).target_from_source;
    const EigenBasis basis = eigen_basis(a, n_functions + 1);
    const Matrix functions = basis.eigenfunctions.rightCols(n_functions);

    const ThereAndBack points = sub_vertex_maps(a, b, map);
    const Matrix returned = transfer_values(points.there, b, transfer_values(points.back, a, functions));
    const Vector errors = relative_errors(functions, returned, basis.mass);

    const SurfaceMap vertex_there = surface_map_of(nearest_corners(points.there, b), b);
    const SurfaceMap vertex_back = surface_map_of(nearest_corners(points.back, a), a);
    const Matrix by_vertices = transfer_values(vertex_there, b, transfer_values(vertex_back, a, functions));
    const Vector vertex_errors = relative_errors(functions, by_vertices, basis.mass);
    return {{"source", a_name},
            {"target", b_name},
            {"map", which},
            {"mean_error_percent", errors.mean()},
            {"largest_error_percent", errors.maxCoeff()},
            {"functions_above_3", (errors.array() > 3).count()},
            {"vertex_mean_error_percent", vertex_errors.mean()},
            {"vertex_largest_error_percent", vertex_errors.maxCoeff()},
            {"errors_percent", std::vector<double>(errors.begin(), errors.end())}};
}

int run(const fs::path& folder, const fs::path& pairs_file, const std::string& which, int n_functions) {
    double worst_mean = 0, worst = 0, vertex_worst_mean = 0;
    std::ptrdiff_t above = 0;
    int n_pairs = 0;
    std::ifstream pairs(pairs_file);
    for (std::string a, b; pairs >> a >> b; ++n_pairs) {
        const Json line = measure(folder, a, b, which, n_functions);
        worst_mean = std::max(worst_mean, line["mean_error_percent"].get<double>());
        worst = std::max(worst, line["largest_error_percent"].get<double>());
        vertex_worst_mean = std::max(vertex_worst_mean, line["vertex_mean_error_percent"].get<double>());
        above += line["functions_above_3"].get<std::ptrdiff_t>();
        std::printf("%s\n", line.dump().c_str());
        std::fflush(stdout);
    }
    const Json summary = {{"pairs", n_pairs},
                          {"map", which},
                          {"worst_mean_error_percent", worst_mean},
                          {"worst_error_percent", worst},
                          {"functions_above_3", above},
                          {"vertex_worst_mean_error_percent", vertex_worst_mean}};
    std::printf("%s\n", summary.dump().c_str());
    return n_pairs > 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
    const std::string which = argc > 3 ? argv[3] : "";
    if (which != "truth" && which != "spectral") {
        std::fputs("usage: round_trip FOLDER PAIRS truth|spectral [FUNCTIONS]\n", stderr);
        return 2;
    }
    try {
        return run(argv[1], argv[2], which, argc > 4 ? std::atoi(argv[4]) : 20);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "error: %s\n", error.what());
        return 1;
    }
}
