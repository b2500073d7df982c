// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "commands.hpp"
#include "console.hpp"
#include "judgment.hpp"
#include "material_files.hpp"

#include <counterpart/base/progress.hpp>
#include <counterpart/io/mesh_objects.hpp>
#include <counterpart/match/choose_method.hpp>
#include <counterpart/match/compare.hpp>
#include <counterpart/mesh/analyze.hpp>
#include <counterpart/transfer/transfer.hpp>

#include <algorithm>
#include <cstdio>
#include <memory>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace counterpart::cli {
namespace {

struct InspectCommand {
    CommonOptions common;
    MeshInput mesh, other;
    std::size_t n_components = 5;
};

std::string describe(const ComponentReport& component) {
    std::string text = fmt::format("{} vertices, {} triangles", component.n_vertices, component.n_triangles);
    if (component.n_boundary_loops == 0) {
        text += ", closed";
    } else {
        text += fmt::format(", {} boundary loop{}", component.n_boundary_loops,
                            component.n_boundary_loops == 1 ? "" : "s");
    }
    if (!component.is_manifold) {
        text += ", non-manifold";
    } else if (!component.is_orientable) {
        text += ", non-orientable";
    }
    if (const auto genus = component.genus()) return text + fmt::format(", genus {}", *genus);
    return text + fmt::format(", Euler characteristic {}", component.euler_characteristic());
}

std::string point(const Eigen::RowVector3d& p) {
    return fmt::format("({:.6g}, {:.6g}, {:.6g})", p[0], p[1], p[2]);
}

// Defects come last, one line each, and only those that occur.
std::string describe(const MeshReport& report, std::size_t n_components) {
    std::string text = fmt::format("vertices    {}\nedges       {}\ntriangles   {}\narea        {:.6g}\n",
                                   report.n_vertices, report.n_edges, report.n_triangles, report.area);
    text += fmt::format("mean edge   {:.6g}\nbox         {} to {}\n", report.mean_edge_length,
                        point(report.box_min), point(report.box_max));
    text += fmt::format("components  {}\n", report.components.size());
    for (std::size_t i = 0; i < std::min(n_components, report.components.size()); ++i)
        text += fmt::format("  {}: {}\n", i, describe(report.components[i]));
    if (report.components.size() > n_components)
        text += fmt::format("  ... and {} more\n", report.components.size() - n_components);

    const auto remark = [&](Index count, const char* what) {
        if (count > 0) text += fmt::format("{:<11} {}\n", count, what);
    };
    remark(report.n_boundary_edges, "boundary edges");
    remark(report.n_nonmanifold_edges, "non-manifold edges (three or more triangles)");
    remark(report.n_nonmanifold_vertices, "non-manifold vertices (shared by separate fans of triangles)");
    remark(report.n_isolated_vertices, "isolated vertices (in no triangle)");
    remark(report.n_duplicate_vertices, "duplicate vertices (at the position of another)");
    remark(report.n_degenerate_triangles, "degenerate triangles (with a repeated vertex)");
    remark(report.n_zero_area_triangles, "triangles of zero area");
    remark(report.n_duplicate_triangles, "duplicate triangles");
    if (!report.is_consistently_oriented)
        text += "orientation is inconsistent: some neighboring triangles disagree\n";
    return text;
}

// What the file holds besides the mesh, one line for each kind that it has.
std::string describe(const AttributedMesh& content) {
    std::string text;
    const auto line = [&](const char* what, const std::string& value) {
        if (!value.empty()) text += fmt::format("{:<11} {}\n", what, value);
    };
    const auto several = [](std::size_t count, const char* noun) {
        return count == 0 ? "" : counted(static_cast<Index>(count), noun);
    };
    std::vector<std::string> shapes;
    for (const MorphTarget& shape : content.morphs) shapes.push_back(shape.name);
    line("uv", several(content.texture_coordinates.size(), "set"));
    line("colors", several(content.colors.size(), "set"));
    line("normals", content.normals.values.rows() > 0 ? "yes" : "");
    if (content.skin.weights.size() > 0)
        line("skin",
             fmt::format("{}, up to {} at a vertex", counted(content.skin.joints.maxCoeff() + 1, "joint"),
                         content.skin.weights.cols()));
    line("shapes", shapes.empty() ? "" : fmt::format("{}: {}", shapes.size(), fmt::join(shapes, ", ")));
    std::string names = fmt::format("{}", fmt::join(content.part_names, ", "));
    if (names.find_first_not_of(", ") == names.npos) names.clear();  // unnamed
    if (const Index n = n_parts(content); n > 1 || !names.empty())
        line("parts", fmt::format("{}{}{}", n, names.empty() ? "" : ": ", names));
    line("materials", has_materials(content) ? "yes" : "");
    return text;
}

// Where there are several.
std::string describe(const std::vector<MeshObject>& objects) {
    constexpr std::size_t most_listed = 100;
    if (objects.size() < 2) return "";
    std::string text = fmt::format("objects     {} (one alone: --object)\n", objects.size());
    for (std::size_t k = 0; k < std::min(objects.size(), most_listed); ++k)
        text += fmt::format("  {}: {}{} vertices, {} triangles\n", k,
                            objects[k].name.empty() ? "" : fmt::format("'{}', ", objects[k].name),
                            objects[k].n_vertices, objects[k].n_triangles);
    if (objects.size() > most_listed)
        text += fmt::format("  ... and {} more, which --report lists\n", objects.size() - most_listed);
    return text;
}

Json objects_json(const std::vector<MeshObject>& objects) {
    Json list = Json::array();
    for (std::size_t k = 0; k < objects.size(); ++k)
        list.push_back({{"number", k},
                        {"name", objects[k].name},
                        {"vertices", objects[k].n_vertices},
                        {"triangles", objects[k].n_triangles}});
    return list;
}

Json attributes_json(const AttributedMesh& content) {
    Json shapes = Json::array();
    for (const MorphTarget& shape : content.morphs) shapes.push_back(shape.name);
    return {{"uv_sets", content.texture_coordinates.size()},
            {"color_sets", content.colors.size()},
            {"normals", content.normals.values.rows() > 0},
            {"joints", content.skin.weights.size() > 0 ? content.skin.joints.maxCoeff() + 1 : 0},
            {"shapes", shapes},
            {"parts", n_parts(content)},
            {"part_names", content.part_names},
            {"materials", has_materials(content)}};
}

Json mesh_json(const MeshReport& report) {
    Json components = Json::array();
    for (const ComponentReport& component : report.components) {
        const auto genus = component.genus();
        components.push_back({{"vertices", component.n_vertices},
                              {"edges", component.n_edges},
                              {"triangles", component.n_triangles},
                              {"boundary_loops", component.n_boundary_loops},
                              {"manifold", component.is_manifold},
                              {"orientable", component.is_orientable},
                              {"euler_characteristic", component.euler_characteristic()},
                              {"genus", genus ? Json(*genus) : Json(nullptr)}});
    }
    const auto list = [](const Eigen::RowVector3d& p) { return Json{p[0], p[1], p[2]}; };
    return {{"vertices", report.n_vertices},
            {"edges", report.n_edges},
            {"triangles", report.n_triangles},
            {"area", report.area},
            {"mean_edge_length", report.mean_edge_length},
            {"box_min", list(report.box_min)},
            {"box_max", list(report.box_max)},
            {"closed", report.is_closed()},
            {"manifold", report.is_manifold()},
            {"consistently_oriented", report.is_consistently_oriented},
            {"boundary_edges", report.n_boundary_edges},
            {"boundary_loops", report.n_boundary_loops},
            {"nonmanifold_edges", report.n_nonmanifold_edges},
            {"nonmanifold_vertices", report.n_nonmanifold_vertices},
            {"isolated_vertices", report.n_isolated_vertices},
            {"duplicate_vertices", report.n_duplicate_vertices},
            {"degenerate_triangles", report.n_degenerate_triangles},
            {"zero_area_triangles", report.n_zero_area_triangles},
            {"duplicate_triangles", report.n_duplicate_triangles},
            {"components", components}};
}

Json comparison_json(const MeshComparison& comparison) {
    const auto known = [](const std::optional<bool>& value) { return value ? Json(*value) : Json(nullptr); };
    Json axes = Json::array();
    for (const int axis : comparison.axes) axes.push_back(std::string(1, "xyz"[axis]));
    return {{"same_connectivity", known(comparison.same_connectivity)},
            {"same_order", comparison.same_order},
            {"mirrored", known(comparison.mirrored)},
            {"source_inside_out", comparison.source_inside_out},
            {"target_inside_out", comparison.target_inside_out},
            {"scale", comparison.scale},
            {"axes", axes},
            {"distance", comparison.distance},
            {"same_places", comparison.same_places},
            {"messages", to_json(comparison.messages)}};
}

void run(const InspectCommand& command) {
    Stopwatch watch;
    const AttributedMesh content = load_attributed_mesh(command.mesh, command.common);
    const TriangleMesh& mesh = content.mesh;
    watch.lap("read");
    const MeshReport report = analyze(mesh);
    const std::vector<MeshObject> objects = mesh_objects(content);
    std::string text = describe(report, command.n_components) + describe(objects) + describe(content);
    Json json = {{"command", "inspect"}, {"mesh", utf8_name(command.mesh)}};
    json.update(mesh_json(report));
    json["attributes"] = attributes_json(content);
    json["objects"] = objects_json(objects);
    if (!command.other.file.empty()) {
        const AttributedMesh other_content = load_attributed_mesh(command.other, command.common);
        const TriangleMesh& other = other_content.mesh;
        const MeshComparison comparison = compare(mesh, other);
        const MeshReport& other_report = comparison.target;
        const std::vector<MeshObject> other_objects = mesh_objects(other_content);
        text = fmt::format("first: {}\n{}\nsecond: {}\n{}{}{}\nfirst and second\n", command.mesh.words(),
                           text, command.other.words(), describe(other_report, command.n_components),
                           describe(other_objects), describe(other_content));
        const MeshPair pair{mesh, other, command.mesh, command.other};
        for (const Message& message : comparison.messages) text += "  " + named(message, pair) + "\n";
        json["other"] = mesh_json(other_report);
        json["other"]["attributes"] = attributes_json(other_content);
        json["other"]["objects"] = objects_json(other_objects);
        const MethodChoice choice = choose_method(mesh, other);
        text += fmt::format("  'match' takes the method {}, because {}\n", to_string(choice.method),
                            choice.reason);
        json["comparison"] = comparison_json(comparison);
        json["comparison"]["method"] = to_string(choice.method);
        json["comparison"]["reason"] = choice.reason;
    }
    watch.lap("analyze");
    json["seconds"] = to_json(watch.stages());
    write_report(json, command.common);
    print(command.common, text);
}

}  // namespace

void add_inspect(CLI::App& program) {
    auto command = std::make_shared<InspectCommand>();
    CLI::App* inspect =
        program.add_subcommand("inspect", "Print mesh statistics and defects, or compare two meshes");
    add_mesh(*inspect, command->common.files, "MESH", "--object", command->mesh, "Mesh file")->required();
    add_mesh(*inspect, command->common.files, "OTHER", "--other-object", command->other,
             "Another mesh file to compare with: connectivity, scale, up axis, mirrored, parts missing");
    inspect->add_option("--components", command->n_components, "Number of components to list")
        ->check(whole_number(0))
        ->capture_default_str();
    add_common_options(*inspect, command->common);
    on_run(*inspect, command->common, [command] { run(*command); });
}

}  // namespace counterpart::cli
