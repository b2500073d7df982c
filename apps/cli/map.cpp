// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "commands.hpp"
#include "load_map.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/geodesic/farthest_points.hpp>
#include <counterpart/io/file.hpp>
#include <counterpart/io/map_file.hpp>
#include <counterpart/io/npy.hpp>
#include <counterpart/map/complete.hpp>
#include <counterpart/map/invert.hpp>
#include <counterpart/spectral/functional_map.hpp>

#include <algorithm>
#include <memory>
#include <variant>

#include <fmt/format.h>

namespace counterpart::cli {
namespace {

constexpr int max_functions = 1000;  // of a functional map: more take minutes

struct MapCommand {
    CommonOptions common;
    MeshInput source, target;
    std::filesystem::path map, output, middle;
    std::vector<std::filesystem::path> chain;
    std::string from = "map", to = "surface";
    int size = 100;
    Index count = 100;
};

MeshPair pair_of(const MapCommand& command, const TriangleMesh& source, const TriangleMesh& target) {
    return {source, target, command.source, command.target};
}

void done(const MapCommand& command, const std::string& what, Index n_matched, Index n) {
    say(command.common, fmt::format("{}: {} of {} source vertices are matched -> {}", what, n_matched, n,
                                    utf8_name(command.output)));
    write_report({{"command", "map"}, {"operation", what}, {"matched_vertices", n_matched}, {"vertices", n}},
                 command.common);
}

// Vertex maps compose by themselves; a surface map may only come last, where no mesh is needed.
void compose(const MapCommand& command) {
    VertexMap all = read_vertex_map(command.chain.front());
    for (std::size_t i = 1; i < command.chain.size(); ++i) {
        const std::filesystem::path& file = command.chain[i];
        std::variant<VertexMap, SurfaceMap> next = read_map(file);
        const Index size = std::visit([](const auto& map) { return map.source_size(); }, next);
        if (all.target_size() > size)
            throw InvalidInput(fmt::format("{}: has {} entries, but the map before it goes to vertex {}",
                                           utf8_name(file), size, all.target_size() - 1));
        const VertexMap step(all.image(), size);
        if (const auto* points = std::get_if<SurfaceMap>(&next)) {
            if (i + 1 < command.chain.size())
                throw InvalidInput(
                    fmt::format("{}: a surface map can only be the last of the maps; make it a vertex map "
                                "with 'map convert --to vertex'",
                                utf8_name(file)));
            SurfaceMap result{{}, points->target_triangles};
            for (Index v = 0; v < step.source_size(); ++v)
                result.image.push_back(step[v] == VertexMap::unmatched ? SurfacePoint{} : (*points)[step[v]]);
            write_surface_map(result, command.output);
            return done(command, "compose", count_matched(result), result.source_size());
        }
        all = compose_maps(step, std::get<VertexMap>(next));
    }
    write_vertex_map(all, command.output);
    done(command, "compose", count_matched(all), all.source_size());
}

// Writes a map in the kind of the one that was read.
void write_alike(const MapCommand& command, const std::string& what, const LoadedMap& read,
                 const SurfaceMap& result, const TriangleMesh& target) {
    if (read.points)
        write_surface_map(result, command.output);
    else
        write_vertex_map(nearest_corners(result, target), command.output);
    done(command, what, count_matched(result), result.source_size());
}

void invert_map(const MapCommand& command) {
    const TriangleMesh source = load_mesh(command.source, command.common);
    const TriangleMesh target = load_mesh(command.target, command.common);
    const MeshPair pair = pair_of(command, source, target);
    const SurfaceMap inverse =
        invert(load_surface_map(command.map, pair, command.common), source, target,
               {.n_threads = command.common.threads, .progress = progress_bar("inverting", command.common)});
    write_alike(command, "invert", load_map(command.map, pair), inverse, source);
}

void complete(const MapCommand& command) {
    const TriangleMesh source = load_mesh(command.source, command.common);
    const TriangleMesh target = load_mesh(command.target, command.common);
    const LoadedMap map = load_map(command.map, pair_of(command, source, target));
    const CompletedMap completed =
        complete_map(map.points ? *map.points : surface_map_of(map.vertices, target), source, target);
    write_alike(command, "complete", map, completed.target_from_source, target);
}

void subsample(const MapCommand& command) {
    const TriangleMesh source = load_mesh(command.source, command.common);
    const TriangleMesh target = load_mesh(command.target, command.common);
    const LoadedMap map = load_map(command.map, pair_of(command, source, target));
    const DistanceGraph graph(source);
    std::string text;
    Index n = 0;
    for (const Index v : farthest_point_samples(source, graph, {.count = command.count}).vertices) {
        if (map.vertices[v] == VertexMap::unmatched) continue;
        text += fmt::format("{} {}\n", v, map.vertices[v]);
        ++n;
    }
    write_file(text, command.output);
    say(command.common,
        fmt::format("{} landmarks, spread over the source -> {}", n, utf8_name(command.output)));
}

VertexMap from_functional(const MapCommand& command, const EigenBasis& source, const EigenBasis& target) {
    const Matrix c = read_npy(command.map);
    if (c.rows() > source.size() || c.cols() > target.size())
        throw InvalidInput(
            fmt::format("{}: {} x {} is larger than the bases", utf8_name(command.map), c.rows(), c.cols()));
    return vertex_map(c, source, target);
}

// A vertex map and a surface map are told apart by their files.
void require_kind(const MapCommand& command, const LoadedMap& map) {
    const std::string kind = map.points ? "surface" : "vertex";
    if (command.from != "map" && command.from != kind)
        throw InvalidInput(fmt::format("{}: is a {} map: give --from {}, or leave --from out",
                                       utf8_name(command.map), kind, kind));
}

void convert_map(const MapCommand& command) {
    if (command.to == "functional") {
        std::filesystem::path output = command.output;
        check_files({{"--output", &output, nullptr, Content::matrix}});
    }
    const TriangleMesh source = load_mesh(command.source, command.common);
    const TriangleMesh target = load_mesh(command.target, command.common);
    const MeshPair pair = pair_of(command, source, target);
    EigenBasis source_basis, target_basis;
    if (command.from == "functional" || command.to == "functional") {
        int size = command.size;
        if (command.from == "functional") {
            const Matrix c = read_npy(command.map);
            const Eigen::Index most = std::max(c.rows(), c.cols());
            if (most > max_functions || c.size() == 0)
                throw InvalidInput(
                    fmt::format("{}: a matrix of {} x {} is no functional map: that has 1 to {} "
                                "functions on each mesh",
                                utf8_name(command.map), c.rows(), c.cols(), max_functions));
            size = static_cast<int>(most);
        }
        source_basis = eigen_basis(source, size, progress_bar("eigenfunctions", command.common));
        target_basis = eigen_basis(target, size, progress_bar("eigenfunctions", command.common));
    }
    LoadedMap map;
    if (command.from == "functional")
        map.vertices = from_functional(command, source_basis, target_basis);
    else
        require_kind(command, map = load_map(command.map, pair));
    if (command.to == "functional") {
        const FunctionalMap c = functional_map(map.vertices, source_basis, target_basis,
                                               std::min(source_basis.size(), target_basis.size()));
        write_npy(Matrix(c), command.output);
        say(command.common,
            fmt::format("{} x {} functional map, from functions on the target to functions on "
                        "the source -> {}",
                        c.rows(), c.cols(), utf8_name(command.output)));
        return;
    }
    if (command.to == "vertex") {
        write_vertex_map(map.vertices, command.output);
        return done(command, "convert", count_matched(map.vertices), source.n_vertices());
    }
    const SurfaceMap points = map.points ? *map.points : between_vertices(map.vertices, pair, command.common);
    write_surface_map(points, command.output);
    done(command, "convert", count_matched(points), source.n_vertices());
}

using Operation = void (*)(const MapCommand&);

struct AddedOperation {
    std::shared_ptr<MapCommand> command;
    CLI::App* app;
};

AddedOperation add_operation(CLI::App& map, const char* name, const char* help, Operation run,
                             bool on_meshes) {
    auto command = std::make_shared<MapCommand>();
    FileArguments& files = command->common.files;
    CLI::App* operation = map.add_subcommand(name, help);
    if (on_meshes) {
        add_mesh(*operation, files, "SOURCE", "--source-object", command->source, "Mesh file")->required();
        add_mesh(*operation, files, "TARGET", "--target-object", command->target, "Mesh file")->required();
        add_input(*operation, files, "MAP", command->map, "Map from SOURCE to TARGET")->required();
    } else {
        add_input(*operation, files, "MAP", command->chain, "Maps, each from where the one before it goes to")
            ->required()
            ->expected(2, 1000);
    }
    add_output(*operation, files, "-o,--output", command->output, Content::map, "Map file, text or .npy")
        ->required();
    add_common_options(*operation, command->common);
    on_run(*operation, command->common, [command, run] { run(*command); });
    return {command, operation};
}

}  // namespace

void add_map(CLI::App& program) {
    CLI::App* map = program.add_subcommand("map", "Compose, invert, complete, subsample or convert maps");
    map->require_subcommand(1);
    add_operation(*map, "compose", "From A to B and from B to C: from A to C", compose, false);
    add_operation(*map, "invert", "The map from TARGET to SOURCE, of the same kind", invert_map, true);
    add_operation(*map, "complete", "Give unmatched vertices the images that follow from those around them",
                  complete, true);
    const AddedOperation samples =
        add_operation(*map, "subsample", "Pairs spread over SOURCE, as a landmark file", subsample, true);
    samples.app->add_option("--count", samples.command->count, "Number of pairs")
        ->check(whole_number(1, 1 << 30))
        ->capture_default_str();
    const AddedOperation converted =
        add_operation(*map, "convert", "To another kind of map", convert_map, true);
    MapCommand& command = *converted.command;
    converted.app->add_option("--to", command.to, "vertex, surface, or functional (a matrix C, .npy)")
        ->check(one_of({"vertex", "surface", "functional"}))
        ->capture_default_str();
    converted.app
        ->add_option("--from", command.from,
                     "vertex, surface, functional, or map: vertex or surface, as the file is")
        ->check(one_of({"map", "vertex", "surface", "functional"}))
        ->capture_default_str();
    converted.app->add_option("--size", command.size, "Number of eigenfunctions of a functional map")
        ->check(whole_number(1, max_functions))
        ->capture_default_str();
}

}  // namespace counterpart::cli
