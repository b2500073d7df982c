// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "compare_meshes.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/match/exact.hpp>
#include <counterpart/mesh/measure.hpp>

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

void compare_parts(const MeshReport& first, const MeshReport& second, double ratio, MeshComparison& result) {
    if (first.components.size() != second.components.size())
        result.sentences.push_back(fmt::format("{} components against {}: parts may be missing or separate",
                                               first.components.size(), second.components.size()));
    if (first.is_closed() == second.is_closed()) return;
    const bool second_is_open = first.is_closed();
    const double area = second.area / first.area / (ratio * ratio);
    const double share = second_is_open ? 1 - area : 1 - 1 / area;
    result.sentences.push_back(fmt::format(
        "the {} is open ({} boundary loops) and the other closed{}: holes or missing parts",
        second_is_open ? "second" : "first",
        second_is_open ? second.n_boundary_loops : first.n_boundary_loops,
        share > 0.03 ? fmt::format(", with about {:.0f} % less area for its size", 100 * share) : ""));
}

}  // namespace

MeshComparison compare_meshes(const TriangleMesh& first, const MeshReport& first_report,
                              const TriangleMesh& second, const MeshReport& second_report) {
    MeshComparison result;
    compare_connectivity(first, second, result);
    const Eigen::RowVector3d first_box = first_report.box_max - first_report.box_min,
                             second_box = second_report.box_max - second_report.box_min;
    const double ratio = second_box.norm() / std::max(1e-300, first_box.norm());
    result.details["scale"] = ratio;
    if (std::abs(std::log(ratio)) > unit_tolerance)
        result.sentences.push_back(
            fmt::format("the second is {:.4g} times as large as the first{}", ratio, units_of(ratio)));

    const std::array<int, 3> axes = alike_axes(first_box, second_box);
    constexpr std::array<const char*, 3> names = {"x", "y", "z"};
    auto axis_names = nlohmann::ordered_json::array();
    for (const int axis : axes) axis_names.push_back(names[static_cast<std::size_t>(axis)]);
    result.details["axes"] = axis_names;
    if (axes[1] != 1)
        result.sentences.push_back(
            fmt::format("another axis points up? y of the first looks like {} of the second",
                        names[static_cast<std::size_t>(axes[1])]));

    const auto inside_out = [&](const TriangleMesh& mesh, const MeshReport& report, const char* name) {
        const bool is = report.is_closed() && signed_volume(mesh) < 0;
        if (is) result.sentences.push_back(fmt::format("the {} is inside out", name));
        return is;
    };
    result.details["first_inside_out"] = inside_out(first, first_report, "first");
    result.details["second_inside_out"] = inside_out(second, second_report, "second");
    for (const auto& [report, name] : {std::pair{&first_report, "first"}, {&second_report, "second"}})
        if (report->n_duplicate_vertices > 0)
            result.sentences.push_back(
                fmt::format("the {} has {} vertices at the place of another: '--weld' merges them", name,
                            report->n_duplicate_vertices));
    compare_parts(first_report, second_report, ratio, result);
    return result;
}

}  // namespace counterpart::cli
