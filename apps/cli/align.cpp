// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "commands.hpp"
#include "load_map.hpp"

#include <counterpart/align/icp.hpp>
#include <counterpart/base/errors.hpp>
#include <counterpart/match/volume.hpp>

#include <cmath>
#include <map>
#include <memory>

#include <Eigen/LU>
#include <fmt/format.h>

namespace counterpart::cli {
namespace {

const std::map<std::string, TransformModel> models = {{"rigid", TransformModel::rigid},
                                                      {"similarity", TransformModel::similarity},
                                                      {"affine", TransformModel::affine}};

struct AlignCommand {
    CommonOptions common;
    MeshInput source, target;
    std::filesystem::path map, output;
    std::string model = "rigid";
    bool use_icp = false;
    IcpOptions icp;
};

struct Fit {
    Affine transform;
    double rms = 0;  // over the fitted pairs
    Json details = Json::object();
    Json match = Json::object();  // what is to be said of a map that was found
};

Fit from_map(const TriangleMesh& source, const TriangleMesh& target, const SurfaceMap& map,
             TransformModel model) {
    std::vector<Index> matched;
    for (Index v = 0; v < source.n_vertices(); ++v)
        if (map[v].matched()) matched.push_back(v);
    const Points from = source.vertices(matched, Eigen::all);
    const Points to = image_positions(map, target)(matched, Eigen::all);
    Fit fit{fit_transform(from, to, model)};
    fit.rms = std::sqrt((fit.transform(from) - to).rowwise().squaredNorm().mean());
    fit.details["pairs"] = matched.size();
    return fit;
}

Fit by_icp(const TriangleMesh& source, const TriangleMesh& target, const SurfaceMap& map,
           const AlignCommand& command) {
    IcpOptions options = command.icp;
    options.n_threads = command.common.threads;
    options.progress = progress_bar("aligning", command.common);
    options.model = models.at(command.model);
    Affine start;
    if (count_matched(map) >= 4) {
        start = from_map(source, target, map, options.model).transform;
    } else {
        start.translation = (target.vertices.colwise().mean() - source.vertices.colwise().mean()).transpose();
    }
    const IcpResult result = icp(source, target, start, map, options);
    if (!result.converged)
        warn(fmt::format("ICP has not converged after {} iterations; raise --iterations", result.iterations));
    return {result.target_from_source,
            result.rms_distance,
            {{"iterations", result.iterations}, {"converged", result.converged}}};
}

// What stays true of a mesh that is moved as a whole; a skeleton does not move with it.
void move(AttributedMesh& content, const Affine& transform) {
    content.mesh.vertices = transform(content.mesh.vertices);
    if (content.normals.values.rows() > 0)
        content.normals.values =
            (content.normals.values * transform.linear.inverse()).rowwise().normalized().eval();
    for (MorphTarget& morph : content.morphs)
        morph.displacements = (morph.displacements * transform.linear.transpose()).eval();
    content.skin = {};
    if (content.document) content.document = content.document->without_skeleton();
}

Fit fitted(const AlignCommand& command, const TriangleMesh& source, const TriangleMesh& target,
           const SurfaceMap& map) {
    return command.use_icp ? by_icp(source, target, map, command)
                           : from_map(source, target, map, models.at(command.model));
}

// By all vertices, also those inside.
Fit align_solids(const AlignCommand& command, TetrahedralMesh source, const TetrahedralMesh& target) {
    const TriangleMesh from = all_faces(source), to = all_faces(target);
    SurfaceMap map;
    if (!command.map.empty())
        map = surface_map_of(load_map(command.map, {from, to, command.source, command.target}).vertices, to);
    else if (!command.use_icp)
        map = surface_map_of(
            match_volume(source, target, {.n_threads = command.common.threads}).target_from_source, to);
    Fit fit = fitted(command, from, to, map);
    source.vertices = fit.transform(source.vertices);
    write_tetrahedral_mesh(source, command.output);
    return fit;
}

Fit align_surfaces(const AlignCommand& command) {
    AttributedMesh source = load_attributed_mesh(command.source, command.common);
    const TriangleMesh target = load_mesh(command.target, command.common);
    FoundMap<SurfaceMap> found;
    if (!command.map.empty() || !command.use_icp)
        found = surface_map_or_match(command.map, {source.mesh, target, command.source, command.target},
                                     command.common);
    Fit fit = fitted(command, source.mesh, target, found.map);
    fit.match = found.report;
    move(source, fit.transform);
    write_attributed_mesh(source, command.output);
    return fit;
}

Fit aligned(const AlignCommand& command) {
    if (holds_tetrahedra(command.output))
        if (auto solids = load_solids(command.source, command.target, command.common))
            return align_solids(command, std::move(solids->first), solids->second);
    return align_surfaces(command);
}

void run(const AlignCommand& command) {
    const Fit fit = aligned(command);
    say(command.common, fmt::format("{} fit, RMS distance {:.6g} -> {}{}", command.model, fit.rms,
                                    utf8_name(command.output), caution(fit.match)));
    Json matrix = Json::array();
    for (int i = 0; i < 3; ++i) {
        const Eigen::RowVector3d row = fit.transform.linear.row(i);
        matrix.push_back({row[0], row[1], row[2], fit.transform.translation[i]});
    }
    matrix.push_back({0, 0, 0, 1});
    Json report = {{"command", "align"}, {"model", command.model}};
    report.update(fit.match);
    report.update({{"matrix", matrix}, {"rms_distance", fit.rms}, {"details", fit.details}});
    write_report(report, command.common);
}

}  // namespace

void add_align(CLI::App& program) {
    auto command = std::make_shared<AlignCommand>();
    CLI::App* align = program.add_subcommand("align", "Align SOURCE with TARGET using a map, ICP, or both");
    add_mesh(*align, command->common.files, "SOURCE", "--source-object", command->source, "Mesh file")
        ->required();
    add_mesh(*align, command->common.files, "TARGET", "--target-object", command->target, "Mesh file")
        ->required();
    add_output(*align, command->common.files, "-o,--output", command->output, Content::mesh,
               "Mesh file for the aligned SOURCE")
        ->required();
    add_input(
        *align, command->common.files, "--map", command->map,
        "Map from SOURCE to TARGET whose pairs are aligned. Default: match them first, unless --icp is given")
        ->type_name("FILE");
    align
        ->add_option("--model", command->model,
                     "rigid, similarity (rigid and uniform scale) or affine; never a reflection")
        ->check(one_of({"rigid", "similarity", "affine"}))
        ->capture_default_str();
    align->add_flag(
        "--icp", command->use_icp,
        "Refine with iterative closest point (ICP), starting from the map's fit or the centroids");
    align
        ->add_option("--iterations", command->icp.max_iterations,
                     "Maximum number of ICP iterations; 1 to 10000")
        ->check(whole_number(1, 10000))
        ->capture_default_str();
    align
        ->add_option("--trim", command->icp.trim,
                     "Fraction of pairs, the worst ones, that ICP ignores; 0 to 0.9")
        ->check(number(0.0, 0.9))
        ->capture_default_str();
    align
        ->add_option("--known-weight", command->icp.known_weight,
                     "Weight of the map's pairs relative to the closest-point pairs in ICP; at least 0")
        ->check(non_negative())
        ->capture_default_str();
    align->add_flag(
        "--robust", command->icp.robust,
        "Let pairs count the less in ICP the farther they are apart: for parts and damaged scans");
    for (const char* name : {"--iterations", "--trim", "--known-weight", "--robust"})
        align->get_option(name)->needs("--icp");
    add_common_options(*align, command->common);
    on_run(*align, command->common, [command] { run(*command); });
}

}  // namespace counterpart::cli
