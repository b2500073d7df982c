// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/compare/geometry.hpp"

#include "match/surface/openness.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/match/exact.hpp>
#include <counterpart/mesh/measure.hpp>
#include <counterpart/mesh/weld.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>

#include <fmt/format.h>

namespace counterpart::comparison {
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

// A number that people read: three digits, never an exponent for what is not tiny or huge.
std::string plain(double number) {
    const bool is_plain = std::abs(number) >= 100 && std::abs(number) < 1e6;
    return is_plain ? fmt::format("{:.0f}", number) : fmt::format("{:.3g}", number);
}

std::string counted(std::size_t count, const std::string& noun) {
    return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

// The axes of the second box in the order that makes it most like the first.
std::array<int, 3> alike_axes(const Eigen::RowVector3d& first, const Eigen::RowVector3d& second) {
    constexpr double clear = 0.2;  // in the logarithm of the sides: less is no reason to turn
    std::array<int, 3> order{0, 1, 2}, best = order;
    const auto difference = [&](const std::array<int, 3>& axes) {
        const Eigen::RowVector3d a = first / first.norm(), b = second / second.norm();
        double sum = 0;
        for (int i = 0; i < 3; ++i)
            sum += std::abs(std::log((a[i] + 1e-6) / (b[axes[static_cast<std::size_t>(i)]] + 1e-6)));
        return sum;
    };
    double least = difference(order) - clear;
    do {
        if (difference(order) < least) {
            least = difference(order);
            best = order;
        }
    } while (std::next_permutation(order.begin(), order.end()));
    return best;
}

void compare_parts(MeshView source, MeshView target, MeshComparison& result) {
    const MeshReport &first = result.source, &second = result.target;
    if (first.components.size() != second.components.size())
        result.messages.push_back(
            {MessageCode::components_differ, Severity::caution,
             fmt::format("{} against {}: parts may be missing or separate",
                         counted(first.components.size(), "component"), second.components.size())});
    if (first.is_closed() == second.is_closed()) return;
    const bool second_is_open = first.is_closed();
    const MeshReport& open = second_is_open ? second : first;
    const double area = second.area / first.area / (result.scale * result.scale);
    const double share = second_is_open ? 1 - area : 1 - 1 / area;
    const bool matters = surface_match::has_opening(second_is_open ? target : source);
    result.messages.push_back(
        {MessageCode::openness_differs,
         matters ? Severity::caution : Severity::notice,
         fmt::format(
             "open ({}) where the other mesh is closed{}{}",
             counted(static_cast<std::size_t>(open.n_boundary_loops), "boundary loop"),
             share > 0.03 ? fmt::format(", with about {:.0f} % less area for its size", 100 * share) : "",
             matters ? ": holes or missing parts, which the method partial is for" : ""),
         {second_is_open ? Subject::target : Subject::source}});
}

bool is_inside_out(MeshView mesh, const MeshReport& report, Subject subject, std::vector<Message>& messages) {
    const bool found = report.is_closed() && signed_volume(mesh) < 0;
    if (found)
        messages.push_back({MessageCode::inside_out,
                            Severity::caution,
                            "inside out: its triangles are turned, or it is mirrored",
                            {subject}});
    return found;
}

void compare_scale(MeshComparison& result) {
    if (std::abs(std::log(result.scale)) > unit_tolerance)
        result.messages.push_back(
            {MessageCode::scale_differs,
             Severity::caution,
             fmt::format("{} times as large as the source{}", plain(result.scale), units_of(result.scale)),
             {Subject::target}});
}

void compare_axes(const Eigen::RowVector3d& source_box, const Eigen::RowVector3d& target_box,
                  MeshComparison& result) {
    result.axes = alike_axes(source_box, target_box);
    constexpr std::array<const char*, 3> names = {"x", "y", "z"};
    if (result.axes[1] != 1)
        result.messages.push_back(
            {MessageCode::axes_differ, Severity::caution,
             fmt::format("another axis points up? y of the source looks like {} of the target",
                         names[static_cast<std::size_t>(result.axes[1])])});
}

double share_of_same_places(MeshView source, MeshView target) {
    const auto place = [](MeshView mesh, Index v) {
        return std::array{mesh.vertices(v, 0), mesh.vertices(v, 1), mesh.vertices(v, 2)};
    };
    std::set<std::array<double, 3>> places;
    for (Index v = 0; v < target.n_vertices(); ++v) places.insert(place(target, v));
    Index n = 0;
    for (Index v = 0; v < source.n_vertices(); ++v) n += places.contains(place(source, v)) ? 1 : 0;
    return source.n_vertices() > 0 ? static_cast<double>(n) / source.n_vertices() : 0;
}

void compare_place(MeshView source, MeshView target, MeshComparison& result) {
    const auto diagonal = [](const MeshReport& report) { return (report.box_max - report.box_min).norm(); };
    const double size = std::max({diagonal(result.source), diagonal(result.target), 1e-300});
    result.distance =
        ((result.source.box_max + result.source.box_min) - (result.target.box_max + result.target.box_min))
            .norm() /
        2 / size;
    result.same_places = share_of_same_places(source, target);
    if (result.same_places > 0)
        result.messages.push_back(
            {MessageCode::same_places, Severity::notice,
             fmt::format("{:.3g} % of the source's vertices lie exactly where vertices of the target lie",
                         100 * result.same_places)});
}

}  // namespace

void compare_geometry(MeshView source, MeshView target, MeshComparison& result) {
    result.source = analyze(source);
    result.target = analyze(target);
    const Eigen::RowVector3d source_box = result.source.box_max - result.source.box_min,
                             target_box = result.target.box_max - result.target.box_min;
    result.scale = target_box.norm() / std::max(1e-300, source_box.norm());
    compare_parts(source, target, result);
    result.source_inside_out = is_inside_out(source, result.source, Subject::source, result.messages);
    result.target_inside_out = is_inside_out(target, result.target, Subject::target, result.messages);
    compare_scale(result);
    compare_axes(source_box, target_box, result);
    compare_place(source, target, result);
}

std::optional<Message> weldable(MeshView source, MeshView target) {
    const TriangleMesh a = weld(source).mesh, b = weld(target).mesh;
    const Index n_source = source.n_vertices() - a.n_vertices(),
                n_target = target.n_vertices() - b.n_vertices();
    if (n_source + n_target == 0 || a.n_vertices() != b.n_vertices() || a.n_triangles() != b.n_triangles())
        return std::nullopt;
    try {
        if (!match_exact(a, b).identical) return std::nullopt;
    } catch (const NumericalError&) {
        return std::nullopt;
    }
    const bool is_source = n_source > 0;
    const Index n = is_source ? n_source : n_target;
    return Message{
        MessageCode::weldable,
        Severity::caution,
        fmt::format("{} at the place of another: once these are welded, the connectivity is the same",
                    n == 1 ? "1 vertex lies" : fmt::format("{} vertices lie", n)),
        {is_source ? Subject::source : Subject::target}};
}

}  // namespace counterpart::comparison
