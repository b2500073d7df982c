// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "estimate.hpp"

#include <array>

#include <fmt/format.h>

namespace counterpart::cli {
namespace {

// A straight line over the number of vertices of each mesh.
struct Cost {
    const char* method;
    double seconds, seconds_per_vertex;
    double gigabytes_per_vertex;
};
constexpr std::array<Cost, 2> costs = {{{"spectral", 1, 14e-6, 1.15e-6},
                                        // Twice: distances of single precision from 900 samples.
                                        {"partial", 6, 170e-6, 9.3e-6}}};

std::string duration(double seconds) {
    if (seconds < 90) return fmt::format("{:.0f} s", seconds);
    return fmt::format("{:.0f} minutes", seconds / 60);
}

}  // namespace

std::string expected_cost(const std::string& method, double n_vertices) {
    constexpr double worth_saying = 10;  // seconds
    for (const Cost& cost : costs) {
        const double seconds = cost.seconds + cost.seconds_per_vertex * n_vertices;
        if (method != cost.method || seconds < worth_saying) continue;
        return fmt::format("about {} and {:.1f} GB of memory are to be expected from '{}'", duration(seconds),
                           cost.gigabytes_per_vertex * n_vertices, method);
    }
    return "";
}

void say_expected_cost(const MatchInput& input, const std::string& method, const std::string& condition) {
    const double n_vertices = 0.5 * (input.source.n_vertices() + input.target.n_vertices());
    const std::string cost = expected_cost(method, n_vertices);
    if (!cost.empty()) say(input.common, condition + cost);
}

}  // namespace counterpart::cli
