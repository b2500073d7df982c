// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "commands.hpp"
#include "console.hpp"

#include <counterpart/io/npy.hpp>
#include <counterpart/spectral/eigen_basis.hpp>

#include <memory>

#include <fmt/format.h>

namespace counterpart::cli {
namespace {

struct SpectrumCommand {
    CommonOptions common;
    MeshInput mesh;
    std::filesystem::path eigenvalues, functions, mass;
    int count = 100;
};

void run(const SpectrumCommand& command) {
    const TriangleMesh mesh = load_mesh(command.mesh, command.common);
    const LaplaceBeltrami laplacian = laplace_beltrami(mesh);
    const EigenBasis basis =
        eigen_basis(laplacian, command.count, progress_bar("eigenfunctions", command.common));
    write_npy(basis.eigenvalues, command.eigenvalues);
    if (!command.functions.empty()) write_npy(Matrix(basis.eigenfunctions), command.functions);
    if (!command.mass.empty()) write_npy(basis.mass, command.mass);
    say(command.common, fmt::format("{} eigenvalues from {:.6g} to {:.6g} (1 / squared mesh units) -> {}",
                                    basis.size(), basis.eigenvalues[0], basis.eigenvalues[basis.size() - 1],
                                    utf8_name(command.eigenvalues)));
    write_report({{"command", "spectrum"},
                  {"mesh", utf8_name(command.mesh)},
                  {"vertices", mesh.n_vertices()},
                  {"components", laplacian.n_components},
                  {"flipped_edges", laplacian.n_flips},
                  {"edges_treated_as_boundary", laplacian.n_cut_edges},
                  {"eigenvalues", std::vector<double>(basis.eigenvalues.begin(), basis.eigenvalues.end())}},
                 command.common);
}

}  // namespace

void add_spectrum(CLI::App& program) {
    auto command = std::make_shared<SpectrumCommand>();
    CLI::App* spectrum =
        program.add_subcommand("spectrum", "Compute Laplace eigenvalues and eigenfunctions of a mesh");
    add_mesh(*spectrum, command->common.files, "MESH", "--object", command->mesh, "Mesh file")->required();
    add_output(*spectrum, command->common.files, "-o,--output", command->eigenvalues, Content::matrix,
               "Eigenvalues, a vector (.npy)")
        ->required();
    add_output(*spectrum, command->common.files, "--functions", command->functions, Content::matrix,
               "Eigenfunctions, vertices x count (.npy)");
    add_output(*spectrum, command->common.files, "--mass", command->mass, Content::matrix,
               "Vertex areas (.npy): the mass matrix under which eigenfunctions are orthonormal");
    spectrum->add_option("--count", command->count, "Number of eigenvalues; 1 to 1000")
        ->check(whole_number(1, 1000))
        ->capture_default_str();
    add_common_options(*spectrum, command->common);
    on_run(*spectrum, command->common, [command] { run(*command); });
}

}  // namespace counterpart::cli
