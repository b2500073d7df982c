// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "commands.hpp"
#include "render_figures.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/base/stopwatch.hpp>
#include <counterpart/io/atomic_file.hpp>
#include <counterpart/io/map_file.hpp>

#include <algorithm>
#include <charconv>
#include <memory>

#include <fmt/format.h>

namespace counterpart::cli {
namespace {

struct RenderCommand {
    std::filesystem::path source, target, output, truth, source_truth, target_truth;
    std::vector<std::filesystem::path> maps;
    int index_base = 0;
    std::string show, size = "1600x1000", colormap = "magma";
    std::vector<Figure> figures;
    RenderRequest request;
};

void parse_size(const std::string& text, RenderRequest& request) {
    const char* end = text.data() + text.size();
    const auto [x, first] = std::from_chars(text.data(), end, request.width);
    if (first == std::errc() && x != end && *x == 'x') {
        const auto [rest, second] = std::from_chars(x + 1, end, request.height);
        const auto fits = [](int side) { return side >= 64 && side <= 8192; };
        if (second == std::errc() && rest == end && fits(request.width) && fits(request.height)) return;
    }
    throw InvalidInput("--size must be WIDTHxHEIGHT, each 64 .. 8192, not '" + text + "'");
}

const Figure& find_figure(const RenderCommand& command) {
    const std::string name = !command.show.empty() ? command.show : command.maps.empty() ? "plain" : "colors";
    return *std::find_if(command.figures.begin(), command.figures.end(),
                         [&](const Figure& figure) { return figure.name == name; });
}

/// What can be said before anything is read.
void check(const RenderCommand& command, const Figure& figure) {
    const auto fail = [&](const char* what) {
        throw InvalidInput(fmt::format("--show {} needs {}", figure.name, what));
    };
    if (figure.needs_target && command.target.empty()) fail("two meshes: SOURCE and TARGET");
    if (figure.needs_map && command.maps.empty()) fail("--map");
    if (figure.needs_truth && command.truth.empty() && command.source_truth.empty())
        fail("the truth: --truth, or --source-truth and --target-truth");
    if (!command.maps.empty() && command.target.empty()) throw InvalidInput("--map needs SOURCE and TARGET");
    if (figure.name == "matrix" && !command.target.empty() && command.maps.empty())
        fail("--map for two meshes");
    if (figure.name != "curve" && command.maps.size() > 1)
        throw InvalidInput("several maps go into one picture only with --show curve");
    const std::string extension = command.output.extension().string();
    if (extension != ".png" && !(extension == ".svg" && figure.diagram))
        throw InvalidInput(fmt::format("--show {} writes {}, not '{}'", figure.name,
                                       figure.diagram ? ".png or .svg" : ".png", command.output.string()));
}

void read(RenderCommand& command, const Figure& figure) {
    RenderRequest& request = command.request;
    request.source = load_mesh(command.source, request.common);
    if (!command.target.empty()) request.target = load_mesh(command.target, request.common);
    for (const std::filesystem::path& file : command.maps) {
        VertexMap map = read_vertex_map(file);
        try {
            require_valid(map, request.source.n_vertices(), request.target->n_vertices());
        } catch (const InvalidInput& error) {
            throw InvalidInput(file.string() + ": " + error.what());
        }
        map.target_size = request.target->n_vertices();
        request.maps.push_back(std::move(map));
    }
    while (request.labels.size() < command.maps.size())
        request.labels.push_back(command.maps[request.labels.size()].stem().string());
    if (!figure.needs_truth) return;
    const auto read_truth = [&](const std::filesystem::path& file) {
        return read_vertex_map(file, static_cast<IndexBase>(command.index_base));
    };
    request.truth = command.truth.empty() ? truth_from_template(read_truth(command.source_truth),
                                                                read_truth(command.target_truth))
                                          : truth_from_map(read_truth(command.truth));
}

void run(RenderCommand& command) {
    Stopwatch watch;
    const Figure& figure = find_figure(command);
    check(command, figure);
    parse_size(command.size, command.request);
    command.request.colormap = colormap_from_name(command.colormap);
    read(command, figure);
    watch.lap("read");

    std::string bytes;
    if (figure.diagram) {
        const Drawing drawing = figure.diagram(command.request);
        if (command.output.extension() == ".svg") {
            bytes = to_svg(drawing);
        } else {
            Image image(drawing.width, drawing.height, {1, 1, 1});
            draw(drawing, image);
            bytes = encode_png(image);
        }
    } else {
        bytes = encode_png(figure.draw(command.request));
    }
    watch.lap("draw");
    write_file(bytes, command.output);
    watch.lap("write");
    say(command.request.common, fmt::format("drew '{}' in {:.2f} s -> {}", figure.name,
                                            watch.stages()[1].seconds, command.output.string()));
    write_report({{"command", "render"},
                  {"show", figure.name},
                  {"output", command.output.string()},
                  {"width", command.request.width},
                  {"height", command.request.height},
                  {"seconds", to_json(watch.stages())}},
                 command.request.common);
}

void add_inputs(CLI::App& render, RenderCommand& command) {
    render.add_option("SOURCE", command.source, "Mesh file (.off, .obj, .ply, .stl, .glb, .gltf)")
        ->required();
    render.add_option("TARGET", command.target, "Mesh file");
    render.add_option("-o,--output", command.output, "Picture: .png; .svg too for curves")->required();
    render.add_option("--map", command.maps, "Map file: line i = target vertex of source vertex i, from 0")
        ->type_name("FILE");
    render.add_option("--label", command.request.labels,
                      "Name of each map in the legend; its file's name if not given");
    auto* truth =
        render.add_option("--truth", command.truth, "The true map, in a file like a map")->type_name("FILE");
    auto* source_truth =
        render
            .add_option("--source-truth", command.source_truth, "Line k = source vertex of template point k")
            ->type_name("FILE")
            ->excludes(truth);
    auto* target_truth =
        render
            .add_option("--target-truth", command.target_truth, "Line k = target vertex of template point k")
            ->type_name("FILE")
            ->needs(source_truth);
    source_truth->needs(target_truth);
    render.add_option("--index-base", command.index_base, "What the truth files count from")
        ->check(CLI::IsMember({0, 1}))
        ->capture_default_str();
}

void add_choices(CLI::App& render, RenderCommand& command) {
    RenderRequest& request = command.request;
    std::vector<std::string> names;
    std::string help = "Figure to draw; colors if there is a map, else plain";
    for (const Figure& figure : command.figures) {
        names.push_back(figure.name);
        help += fmt::format("\n  {}: {}", figure.name, figure.summary);
    }
    render.add_option("--show", command.show, help)->check(CLI::IsMember(names));
    render.add_option("--size", command.size, "Pixels")->type_name("WxH")->capture_default_str();
    render
        .add_option("--view", request.view.direction,
                    "auto, front, back, left, right, top, bottom, or AZIMUTH,ELEVATION in degrees")
        ->capture_default_str();
    render.add_option("--up", request.view.up, "What is up in the source: auto, x, y, z, -x, -y or -z")
        ->capture_default_str();
    render
        .add_option("--vertex", request.vertex, "Source vertex that frontiers start at; its tip if not given")
        ->check(CLI::NonNegativeNumber);
    render
        .add_option("--target-vertex", request.target_vertex,
                    "The same on the target; by the map if there is one")
        ->check(CLI::NonNegativeNumber);
    render.add_option("--every", request.every, "Draw every n-th frontier")
        ->check(CLI::Range(1, 1 << 30))
        ->capture_default_str();
    render.add_flag("--dots", request.dots, "Draw frontiers as dots instead of bands");
    render.add_option("--frontier", request.frontier, "Frontier to align; the largest if not given")
        ->check(CLI::NonNegativeNumber);
    render.add_option("--bases", request.n_bases, "Number of base vertices at most; 0 = by --radius only")
        ->check(CLI::Range(0, 20000))
        ->capture_default_str();
    render
        .add_option("--radius", request.radius, "Of a base vertex' patch, or of the patch shown; mesh units")
        ->check(CLI::NonNegativeNumber);
    render.add_option("--lines", request.lines.count, "Number of lines at most; 0 = all")
        ->check(CLI::Range(0, 1 << 30))
        ->capture_default_str();
    render.add_option("--seed", request.lines.seed, "Which lines are drawn")->capture_default_str();
    render.add_option("--max-error", request.max_error, "End of the error scale; 0 = by the errors")
        ->check(CLI::NonNegativeNumber)
        ->capture_default_str();
    render.add_option("--colormap", command.colormap, "Colours of errors")
        ->check(CLI::IsMember(colormap_names()))
        ->capture_default_str();
}

}  // namespace

std::vector<PlacedMesh> RenderRequest::placed() const {
    const View source_view = find_view(source, view);
    std::vector<Placement> places = {Placement(source, source_view)};
    if (target) {
        const View target_view =
            maps.empty() ? source_view : carry_view(source_view, source, *target, maps[0]);
        places.emplace_back(*target, target_view);
    }
    arrange_in_row(places);
    std::vector<PlacedMesh> result = {{source, places[0]}};
    if (target) result.push_back({*target, places[1]});
    return result;
}

Image RenderRequest::paint(const Scene& scene, int bottom) const {
    RenderOptions options{.width = width, .height = height, .bottom = bottom};
    options.n_threads = common.threads;
    return render(scene, options);
}

void add_render(CLI::App& program) {
    auto command = std::make_shared<RenderCommand>();
    CLI::App* render = program.add_subcommand("render", "Draw meshes, maps and errors as a picture");
    for (const auto& group : {map_figures(), mesh_figures(), frontier_figures()})
        command->figures.insert(command->figures.end(), group.begin(), group.end());
    add_inputs(*render, *command);
    add_choices(*render, *command);
    add_common_options(*render, command->request.common);
    render->callback([command] { run(*command); });
}

}  // namespace counterpart::cli
