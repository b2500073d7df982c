// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "compare_meshes.hpp"

#include "console.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/match/exact.hpp>
#include <counterpart/mesh/measure.hpp>
#include <counterpart/mesh/weld.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

namespace counterpart::cli {
namespace {

constexpr double unit_tolerance = 0.15;  // poses and individuals differ by about this much in size

struct UnitRatio {
    double ratio;
    const char* words;
};
constexpr std::array<UnitRatio, 6> unit_ratios = {{{1000, "millimeters against meters"},
                                                   {100, "centimeters against meters"},
                                                   {10, "millimeters against centimeters"},
                                                   {25.4, "millimeters against inches"},
                                                   {2.54, "centimeters against inches"},
                                                   {39.37, "inches against meters"}}};

std::string units_of(double ratio) {
    const double larger = std::max(ratio, 1 / ratio);
    for (const UnitRatio& unit : unit_ratios)
        if (std::abs(std::log(larger / unit.ratio)) < unit_tolerance)
            return fmt::format(" (other units? {}{})", unit.words, ratio < 1 ? ", the other way round" : "");
    return "";
}

// The axes of the second box in the order that makes it most like the first.
std::array<int, 3> alike_axes(const Eigen::RowVector3d& first, const Eigen::RowVector3d& second) {
    constexpr double clear = 0.2;  // in the logarithm of the sides: less is no reason to turn
    std::array<int, 3> order{0, 1, 2}, best = order;
    double least = 0;
    const auto difference = [&](const std::array<int, 3>& axes) {
        const Eigen::RowVector3d a = first / first.norm(), b = second / second.norm();
        double sum = 0;
        for (int i = 0; i < 3; ++i)
            sum += std::abs(std::log((a[i] + 1e-6) / (b[axes[static_cast<std::size_t>(i)]] + 1e-6)));
        return sum;
    };
    least = difference(order) - clear;
    do {
        if (difference(order) < least) {
            least = difference(order);
            best = order;
        }
    } while (std::next_permutation(order.begin(), order.end()));
    return best;
}

void compare_connectivity(const TriangleMesh& first, const TriangleMesh& second, MeshComparison& result) {
    try {
        ExactResult exact = match_exact(first, second, {.allow_mirror = true});
        result.details["same_connectivity"] = exact.identical;
        if (!exact.identical) {
            result.sentences.push_back("connectivity differs: " + exact.difference);
            result.details["mirrored"] = nullptr;
            result.sentences.emplace_back(
                "whether one is a mirror image of the other does not show where connectivity differs; 'match "
                "--symmetric' matches them as mirror images");
            return;
        }
        result.sentences.emplace_back(
            "the same connectivity: 'match' is exact, 'reorder' restores the order");
        result.details["mirrored"] = exact.mirrored;
        if (exact.mirrored) result.sentences.emplace_back("the second is a mirror image of the first");
    } catch (const NumericalError& error) {
        result.sentences.push_back(fmt::format("the connectivity does not decide ({})", error.what()));
    }
}

// Sentences name the meshes by these.
using Names = std::array<std::string, 2>;

void compare_parts(const MeshReport& first, const MeshReport& second, double ratio, const Names& names,
                   MeshComparison& result) {
    if (first.components.size() != second.components.size())
        result.sentences.push_back(fmt::format(
            "{} against {}: parts may be missing or separate",
            counted(static_cast<Index>(first.components.size()), "component"), second.components.size()));
    if (first.is_closed() == second.is_closed()) return;
    const bool second_is_open = first.is_closed();
    const double area = second.area / first.area / (ratio * ratio);
    const double share = second_is_open ? 1 - area : 1 - 1 / area;
    result.sentences.push_back(fmt::format(
        "{} is open ({}) and the other closed{}: holes or missing parts, which 'match --method partial' is "
        "for",
        names[second_is_open ? 1 : 0],
        counted(second_is_open ? second.n_boundary_loops : first.n_boundary_loops, "boundary loop"),
        share > 0.03 ? fmt::format(", with about {:.0f} % less area for its size", 100 * share) : ""));
}

void compare_orientation(const TriangleMesh& mesh, const MeshReport& report, const char* key,
                         const std::string& name, MeshComparison& result) {
    const bool inside_out = report.is_closed() && signed_volume(mesh) < 0;
    result.details[key] = inside_out;
    if (inside_out)
        result.sentences.push_back(
            fmt::format("{} is inside out: its triangles are turned, or it is mirrored", name));
}

void compare_scale(double ratio, const Names& names, MeshComparison& result) {
    result.details["scale"] = ratio;
    if (std::abs(std::log(ratio)) > unit_tolerance)
        result.sentences.push_back(fmt::format("{} is {} times as large as {}{}", names[1], readable(ratio),
                                               names[0], units_of(ratio)));
}

void compare_axes(const Eigen::RowVector3d& first_box, const Eigen::RowVector3d& second_box,
                  const Names& names, MeshComparison& result) {
    const std::array<int, 3> axes = alike_axes(first_box, second_box);
    constexpr std::array<const char*, 3> axis_names = {"x", "y", "z"};
    auto found = nlohmann::ordered_json::array();
    for (const int axis : axes) found.push_back(axis_names[static_cast<std::size_t>(axis)]);
    result.details["axes"] = found;
    if (axes[1] != 1)
        result.sentences.push_back(fmt::format("another axis points up? y of {} looks like {} of {}",
                                               names[0], axis_names[static_cast<std::size_t>(axes[1])],
                                               names[1]));
}

std::string counted_vertices(Index n) { return n == 1 ? "1 vertex" : fmt::format("{} vertices", n); }

// All but the connectivity, in the order in which these spoil maps.
void compare_geometry(const TriangleMesh& first, const MeshReport& first_report, const TriangleMesh& second,
                      const MeshReport& second_report, const Names& names, MeshComparison& result) {
    const Eigen::RowVector3d first_box = first_report.box_max - first_report.box_min,
                             second_box = second_report.box_max - second_report.box_min;
    const double ratio = second_box.norm() / std::max(1e-300, first_box.norm());
    compare_parts(first_report, second_report, ratio, names, result);
    compare_orientation(first, first_report, "first_inside_out", names[0], result);
    compare_orientation(second, second_report, "second_inside_out", names[1], result);
    for (const auto& [report, name] : {std::pair{&first_report, names[0]}, {&second_report, names[1]}})
        if (report->n_duplicate_vertices > 0)
            result.sentences.push_back(fmt::format(
                "{} has {} at the place of another: '--weld' of 'match' and 'convert' merges them", name,
                counted_vertices(report->n_duplicate_vertices)));
    compare_scale(ratio, names, result);
    compare_axes(first_box, second_box, names, result);
}

}  // namespace

MeshComparison compare_meshes(const TriangleMesh& first, const MeshReport& first_report,
                              const TriangleMesh& second, const MeshReport& second_report) {
    MeshComparison result;
    compare_connectivity(first, second, result);
    compare_geometry(first, first_report, second, second_report, {"the first", "the second"}, result);
    return result;
}

std::string welding_advice(const TriangleMesh& source, const TriangleMesh& target,
                           const std::string& source_name, const std::string& target_name) {
    for (const auto& [mesh, name] : {std::pair{&source, source_name}, {&target, target_name}}) {
        const Index n_doubled = mesh->n_vertices() - weld(*mesh).mesh.n_vertices();
        if (n_doubled > 0)
            return fmt::format("{} has {} at the place of another, which may be why: try --weld", name,
                               counted_vertices(n_doubled));
    }
    return "";
}

std::vector<std::string> probable_causes(const TriangleMesh& source, const TriangleMesh& target,
                                         const std::string& source_name, const std::string& target_name) {
    MeshComparison result;
    const MeshReport source_report = analyze(source), target_report = analyze(target);
    compare_geometry(source, source_report, target, target_report, {source_name, target_name}, result);
    // After missing parts, which are first.
    const bool parts = source_report.is_closed() != target_report.is_closed() ||
                       source_report.components.size() != target_report.components.size();
    auto place = result.sentences.begin();
    while (parts && place != result.sentences.end() && place->find("missing") != std::string::npos) ++place;
    result.sentences.insert(place, "the two are unlike shapes, or alike in themselves (a symmetry)");
    return result.sentences;
}

}  // namespace counterpart::cli
