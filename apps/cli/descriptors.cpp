// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "commands.hpp"
#include "console.hpp"

#include <counterpart/descriptor/descriptors.hpp>
#include <counterpart/io/npy.hpp>

#include <memory>

#include <fmt/format.h>

namespace counterpart::cli {
namespace {

struct DescriptorsCommand {
    CommonOptions common;
    MeshInput mesh;
    std::filesystem::path output;
    std::string kind = "wks";
    int columns = 40;
};

Eigen::MatrixXd compute(const DescriptorsCommand& command, const TriangleMesh& mesh) {
    const LaplaceBeltrami laplacian = laplace_beltrami(mesh);
    if (command.kind == "curvature") return mean_curvature(mesh, laplacian);
    const EigenBasis basis = eigen_basis(laplacian, 100);
    if (command.kind == "hks") return heat_kernel_signature(basis, {.n_times = command.columns});
    return wave_kernel_signature(basis, {.n_energies = command.columns});
}

void run(const DescriptorsCommand& command) {
    const TriangleMesh mesh = load_mesh(command.mesh, command.common);
    const Matrix descriptors = compute(command, mesh);
    write_npy(descriptors, command.output);
    say(command.common, fmt::format("{}: {} vertices x {} -> {}", command.kind, descriptors.rows(),
                                    descriptors.cols(), utf8_name(command.output)));
    write_report({{"command", "descriptors"},
                  {"mesh", utf8_name(command.mesh)},
                  {"kind", command.kind},
                  {"rows", descriptors.rows()},
                  {"columns", descriptors.cols()}},
                 command.common);
}

}  // namespace

void add_descriptors(CLI::App& program) {
    auto command = std::make_shared<DescriptorsCommand>();
    CLI::App* descriptors = program.add_subcommand("descriptors", "Compute per-vertex descriptors of a mesh");
    add_mesh(*descriptors, command->common.files, "MESH", "--object", command->mesh, "Mesh file")->required();
    add_output(*descriptors, command->common.files, "-o,--output", command->output, Content::matrix,
               "NumPy file (.npy): float64, vertices x columns")
        ->required();
    descriptors
        ->add_option("--kind", command->kind, "wks (wave kernel), hks (heat kernel) or curvature (mean)")
        ->check(one_of({"wks", "hks", "curvature"}))
        ->capture_default_str();
    descriptors
        ->add_option("--columns", command->columns,
                     "Number of energies (wks) or times (hks); curvature has one column")
        ->check(whole_number(2, 1000))
        ->capture_default_str();
    add_common_options(*descriptors, command->common);
    on_run(*descriptors, command->common, [command] { run(*command); });
}

}  // namespace counterpart::cli
