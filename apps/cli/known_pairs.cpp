// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "known_pairs.hpp"

#include "checks.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/io/landmark_file.hpp>
#include <counterpart/io/landmark_points.hpp>

#include <fmt/format.h>

namespace counterpart::cli {

Landmarks KnownPairsFiles::read(MeshView source, MeshView target_mesh) const {
    if (pairs.empty()) return {};
    if (!target.empty())
        return landmark_pairs(read_landmark_points(pairs, axes), source, read_landmark_points(target, axes),
                              target_mesh);
    const std::string name = utf8_name(pairs.filename());
    for (const char* ending : {".json", ".fcsv", ".csv"})
        if (name.ends_with(ending))
            throw InvalidInput(fmt::format(
                "{} holds points of one mesh: give those of the other with --target-landmarks", name));
    return read_landmarks(pairs, source, target_mesh);
}

CLI::Option* add_landmark_axes(CLI::App& command, std::optional<Anatomical>& axes) {
    return command
        .add_option_function<std::string>(
            "--landmark-axes",
            [&axes](const std::string& name) { axes = name == "LPS" ? Anatomical::lps : Anatomical::ras; },
            "What the meshes are in: points whose file says otherwise are turned to it. Default: as they are")
        ->check(one_of({"LPS", "RAS"}))
        ->option_text("LPS|RAS");
}

void add_known_pairs(CLI::App& command, KnownPairsFiles& known, const std::string& purpose,
                     const std::string& group) {
    CLI::Option* pairs =
        add_path(command, "--landmarks", known.pairs,
                 purpose +
                     ". One pair per line: two 0-based vertices or two points (6 coordinates); "
                     "or, with --target-landmarks, the source's points")
            ->type_name("FILE")
            ->group(group);
    add_path(command, "--target-landmarks", known.target,
             "The target's points: those of --landmarks with the same names correspond. Both .mrk.json or "
             ".fcsv of 3D Slicer, .json of scalismo, or .csv (name, x, y, z)")
        ->type_name("FILE")
        ->needs(pairs)
        ->group(group);
    add_landmark_axes(command, known.axes)->group(group);
}

FileArguments files_of(KnownPairsFiles& known) {
    return {{"--landmarks", &known.pairs, nullptr, {}}, {"--target-landmarks", &known.target, nullptr, {}}};
}

}  // namespace counterpart::cli
