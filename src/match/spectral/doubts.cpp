// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/doubts.hpp"

#include <fmt/format.h>

namespace counterpart::spectral_match {
namespace {

using Sentences = std::vector<std::string>;

std::string counted(Index n, const std::string& noun, const std::string& plural) {
    return fmt::format("{} {}", n, n == 1 ? noun : plural);
}

void doubts_of_input(const Core& core, const std::string& name, Sentences& sentences) {
    const auto say = [&](bool holds, std::string sentence) {
        if (holds) sentences.push_back(std::move(sentence));
    };
    constexpr Index many = 100;
    say(core.n_joined > 0, fmt::format("{}: {} at the place of another joined for the matching", name,
                                       counted(core.n_joined, "vertex", "vertices")));
    say(core.n_unreferenced > 0,
        fmt::format("{}: {} in no triangle; each gets the partner of the vertex next to it", name,
                    counted(core.n_unreferenced, "vertex", "vertices")));
    say(core.n_repeated > 0, fmt::format("{}: {} with the corners of another left out", name,
                                         counted(core.n_repeated, "triangle", "triangles")));
    say(core.n_disagreeing > 0, fmt::format("{}: {} wound against the others and turned around", name,
                                            counted(core.n_disagreeing, "triangle", "triangles")));
    say(core.n_one_sided > 0,
        fmt::format("{}: a part has only one side, as a Moebius band; left and right mean nothing there",
                    name));
    say(core.was_inside_out,
        fmt::format("{}: inside out; its triangles were turned around for the matching", name));
    say(core.n_nonmanifold_edges > 0,
        fmt::format("{}: {} with more than two triangles; the surface counts as cut there", name,
                    counted(core.n_nonmanifold_edges, "edge", "edges")));
    say(core.n_boundary_loops > 0 && core.n_components < many,
        fmt::format("{}: open, with {}; the match is less sure near them", name,
                    counted(core.n_boundary_loops, "boundary", "boundaries")));
    say(core.n_components > 1 && core.n_components < many,
        fmt::format("{}: {} components; the smaller ones are tied to the largest and matched roughly", name,
                    core.n_components));
    say(core.n_components >= many,
        fmt::format("{}: {} loose pieces, dust rather than a surface; the map means little unless they are "
                    "joined first",
                    name, core.n_components));
    say(core.n_small_components > 0,
        fmt::format("{}: {} ({:.2g} % of the area) left out; each follows the vertex nearest to it", name,
                    counted(core.n_small_components, "small component", "small components"),
                    100 * core.small_share));
}

void doubts_of_shape(const Shape& shape, const std::string& name, Sentences& sentences) {
    if (shape.flat)
        sentences.push_back(
            fmt::format("{}: flat; nothing tells its two sides apart, and mirrored maps are as good", name));
    if (shape.basis.size() <= 3) return;
    const double first = shape.basis.eigenvalues[1], third = shape.basis.eigenvalues[3];
    if (third < 1.03 * first)
        sentences.push_back(
            fmt::format("{}: looks the same from every side (its lowest eigenvalues repeat); many maps are "
                        "equally good, give landmarks to choose one",
                        name));
}

}  // namespace

Sentences doubts(const Shape& source, const Shape& target) {
    Sentences sentences;
    doubts_of_input(source.core, "source", sentences);
    doubts_of_input(target.core, "target", sentences);
    doubts_of_shape(source, "source", sentences);
    doubts_of_shape(target, "target", sentences);
    if (source.core.n_components != target.core.n_components)
        sentences.push_back(fmt::format(
            "the source has {} and the target {}: some parts may have no counterpart",
            counted(source.core.n_components, "component", "components"), target.core.n_components));
    return sentences;
}

}  // namespace counterpart::spectral_match
