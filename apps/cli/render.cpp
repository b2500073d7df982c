// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "commands.hpp"
#include "load_map.hpp"
#include "render_figures.hpp"
#include "truth_options.hpp"
#include "up_axis.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/base/progress.hpp>
#include <counterpart/io/file.hpp>
#include <counterpart/io/map_file.hpp>

#include <algorithm>
#include <charconv>
#include <memory>

#include <fmt/format.h>

namespace counterpart::cli {
namespace {

struct RenderCommand {
    MeshInput source, target;
    std::filesystem::path output;
    std::vector<std::filesystem::path> maps;
    TruthOptions truth;
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
    throw InvalidInput("--size must be WIDTHxHEIGHT, each 64 to 8192, not '" + text + "'");
}

const Figure& find_figure(const RenderCommand& command) {
    const std::string name = !command.show.empty() ? command.show : command.maps.empty() ? "plain" : "colors";
    return *std::find_if(command.figures.begin(), command.figures.end(),
                         [&](const Figure& figure) { return figure.name == name; });
}

/// Refuses wrong combinations of options before anything is read.
void check(const RenderCommand& command, const Figure& figure) {
    const auto fail = [&](const char* what) {
        throw InvalidInput(fmt::format("--show {} needs {}", figure.name, what));
    };
    if (figure.needs_target && command.target.file.empty()) fail("two meshes: SOURCE and TARGET");
    if (figure.needs_map && command.maps.empty()) fail("--map");
    if (figure.needs_truth && !command.truth.given())
        fail("the truth: --truth, or --source-truth and --target-truth");
    if (!command.maps.empty() && command.target.file.empty())
        throw InvalidInput("--map needs SOURCE and TARGET");
    if (figure.name == "matrix" && !command.target.file.empty() && command.maps.empty())
        fail("--map for two meshes");
    if (!figure.compares_maps && command.maps.size() > 1)
        throw InvalidInput("several maps need --show colors, checker or curve");
    const std::string extension = lower_extension(command.output);
    if (!extension.empty() && extension != ".png" && !(extension == ".svg" && figure.diagram))
        throw InvalidInput(fmt::format("--show {} writes {}, not '{}'", figure.name,
                                       figure.diagram ? ".png or .svg" : ".png", utf8_name(command.output)));
}

// One color for each vertex, even where its corners differ.
Points vertex_colors(const AttributedMesh& content) {
    if (content.colors.empty()) return {};
    const CornerAttribute& colors = content.colors[0];
    Points result = Points::Constant(content.mesh.n_vertices(), 3, 0.8);
    for (Index t = 0; t < content.mesh.n_triangles(); ++t)
        for (int c = 0; c < 3; ++c)
            if (colors.corners(t, c) >= 0)
                result.row(content.mesh.triangles(t, c)) = colors.values.row(colors.corners(t, c)).head<3>();
    return result;
}

void read(RenderCommand& command, const Figure& figure) {
    RenderRequest& request = command.request;
    AttributedMesh source = load_attributed_mesh(command.source, request.common);
    request.source_colors = vertex_colors(source);
    request.source = std::move(source.mesh);
    if (request.view.up == "auto" && !figure.diagram)
        request.view.up = guessed_up(request.source, request.common);
    if (!command.target.file.empty()) {
        AttributedMesh target = load_attributed_mesh(command.target, request.common);
        request.target_colors = vertex_colors(target);
        request.target = std::move(target.mesh);
    }
    for (const std::filesystem::path& file : command.maps) {
        request.maps.push_back(
            load_map(file, {request.source, *request.target, command.source, command.target}));
    }
    while (request.labels.size() < command.maps.size())
        request.labels.push_back(utf8_name(command.maps[request.labels.size()].stem()));
    if (figure.needs_truth) request.truth = read_truth(command.truth);
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
        if (lower_extension(command.output) == ".svg") {
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
                                            watch.stages()[1].seconds, utf8_name(command.output)));
    write_report({{"command", "render"},
                  {"show", figure.name},
                  {"output", utf8_name(command.output)},
                  {"width", command.request.width},
                  {"height", command.request.height},
                  {"seconds", to_json(watch.stages())}},
                 command.request.common);
}

void add_inputs(CLI::App& render, RenderCommand& command) {
    FileArguments& files = command.request.common.files;
    add_mesh(render, files, "SOURCE", "--source-object", command.source, "Mesh file")->required();
    add_mesh(render, files, "TARGET", "--target-object", command.target, "Mesh file");
    add_output(render, files, "-o,--output", command.output, Content::picture,
               "Image file: .png, or .svg for curves")
        ->required();
    add_input(
        render, files, "--map", command.maps,
        "Map file: line i = target vertex of source vertex i, 0-based; or a surface map. With several, the "
        "target appears once for each, side by side");
    render.add_option("--label", command.request.labels,
                      "Name of each map in the picture. Default: its file name");
    add_truth_options(render, files, command.truth);
}

void add_choices(CLI::App& render, RenderCommand& command) {
    RenderRequest& request = command.request;
    std::vector<std::string> names;
    std::string help = "Figure to draw. Default: colors with a map, plain without";
    for (const Figure& figure : command.figures) {
        names.push_back(figure.name);
        help += fmt::format("\n  {}: {}", figure.name, figure.summary);
    }
    render.add_option("--show", command.show, help)->check(one_of(names));
    render.add_option("--size", command.size, "Size of the image in pixels")
        ->type_name("WxH")
        ->capture_default_str();
    render
        .add_option(
            "--view", request.view.direction,
            "View direction: auto, front, back, left, right, top, bottom, or AZIMUTH,ELEVATION in degrees")
        ->capture_default_str();
    render
        .add_option("--up", request.view.up,
                    "Up axis of the source: auto (a guess, which is said), x, y, z, -x, -y or -z")
        ->capture_default_str();
    render
        .add_option("--vertex", request.vertex,
                    "Seed vertex of SOURCE for frontiers. Default: a critical point")
        ->check(whole_number(0, 1 << 30));
    render
        .add_option(
            "--target-vertex", request.target_vertex,
            "Seed vertex of TARGET. Default: the image of --vertex, or a critical point without a map")
        ->check(whole_number(0, 1 << 30));
    render.add_option("--every", request.every, "Draw every n-th frontier")
        ->check(whole_number(1, 1 << 30))
        ->capture_default_str();
    render.add_flag("--dots", request.dots, "Draw frontiers as dots instead of bands");
    render
        .add_option("--frontier", request.frontier,
                    "Frontier to align, 0-based. Default: the largest connected one")
        ->check(whole_number(0, 1 << 30));
    render
        .add_option("--bases", request.n_bases,
                    "Maximum number of farthest-point samples; 0 = limited by --radius only")
        ->check(whole_number(0, 20000))
        ->capture_default_str();
    render
        .add_option("--radius", request.radius,
                    "Covering radius of the samples, or radius of the region shown, in mesh units")
        ->check(non_negative());
    render.add_option("--lines", request.lines.count, "Maximum number of lines; 0 = all")
        ->check(whole_number(0, 1 << 30))
        ->capture_default_str();
    render.add_option("--seed", request.lines.seed, "Random seed that selects the lines")
        ->check(whole_number(0))
        ->capture_default_str();
    render.add_option("--max-error", request.max_error, "Upper end of the error scale; 0 = automatic")
        ->check(non_negative())
        ->capture_default_str();
    render.add_option("--colormap", command.colormap, "Color map for errors")
        ->check(one_of(colormap_names()))
        ->capture_default_str();
}

}  // namespace

std::vector<PlacedMesh> RenderRequest::placed() const {
    const Camera source_view = find_camera(source, view);
    std::vector<Placement> places = {Placement(source, source_view)};
    if (target) {
        const Camera target_view =
            maps.empty() ? source_view : matching_camera(source_view, source, *target, maps[0].vertices);
        places.insert(places.end(), std::max<std::size_t>(maps.size(), 1), Placement(*target, target_view));
    }
    arrange_in_row(places);
    std::vector<PlacedMesh> result;
    for (const Placement& place : places) result.push_back({result.empty() ? source : *target, place});
    return result;
}

RenderOptions RenderRequest::options(int bottom) const {
    RenderOptions options{.width = width, .height = height, .bottom = bottom};
    options.n_threads = common.threads;
    options.progress = progress_bar("rendering", common);
    return options;
}

Image RenderRequest::paint(const Scene& scene, int bottom) const {
    return render::render(scene, options(bottom));
}

void add_render(CLI::App& program) {
    auto command = std::make_shared<RenderCommand>();
    CLI::App* render = program.add_subcommand("render", "Draw an image of meshes, maps or errors");
    for (const auto& group : {map_figures(), mesh_figures(), frontier_figures()})
        command->figures.insert(command->figures.end(), group.begin(), group.end());
    add_inputs(*render, *command);
    add_choices(*render, *command);
    add_common_options(*render, command->request.common);
    on_run(*render, command->request.common, [command] { run(*command); });
}

}  // namespace counterpart::cli
