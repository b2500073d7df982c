// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "truth_options.hpp"

#include "checks.hpp"

#include <counterpart/io/map_file.hpp>

#include <cmath>
#include <limits>

namespace counterpart::cli {

void add_truth_options(CLI::App& command, FileArguments& files, TruthOptions& options) {
    CLI::Option* truth =
        add_input(command, files, "--truth", options.truth, "True map: a file like the map's");
    CLI::Option* source_truth = add_input(command, files, "--source-truth", options.source_truth,
                                          "Line k = source vertex of template point k")
                                    ->excludes(truth);
    CLI::Option* target_truth = add_input(command, files, "--target-truth", options.target_truth,
                                          "Line k = target vertex of template point k")
                                    ->needs(source_truth);
    source_truth->needs(target_truth);
    command.add_option("--index-base", options.index_base, "Index of the first vertex in the truth files")
        ->check(whole_number(0, 1))
        ->capture_default_str();
}

std::optional<GroundTruth> read_truth(const TruthOptions& options) {
    const auto read = [&](const std::filesystem::path& file) {
        return read_vertex_map(file, static_cast<IndexBase>(options.index_base));
    };
    if (!options.truth.empty()) return truth_from_map(read(options.truth));
    if (!options.source_truth.empty())
        return truth_from_template(read(options.source_truth), read(options.target_truth));
    return std::nullopt;
}

EvaluationReport evaluated(const LoadedMap& map, const GroundTruth& truth, const TriangleMesh& source,
                           const TriangleMesh& target, const EvaluationOptions& options) {
    return map.points ? evaluate(*map.points, truth, source, target, options)
                      : evaluate(map.vertices, truth, source, target, options);
}

Vector mean_vertex_errors(const GroundTruth& truth, const EvaluationReport& report, PairEnd end,
                          Index n_vertices) {
    const Vector error = report.error * (100 / std::sqrt(report.target_area));
    Vector sum = Vector::Zero(n_vertices), count = Vector::Zero(n_vertices);
    for (std::size_t i = 0; i < truth.pairs.size(); ++i) {
        const Index v = end == PairEnd::source ? truth.pairs[i].first : truth.pairs[i].second;
        const double e = error[static_cast<Eigen::Index>(i)];
        if (!std::isnan(e)) sum[v] += e, count[v] += 1;
    }
    return sum.binaryExpr(
        count, [](double s, double n) { return n > 0 ? s / n : std::numeric_limits<double>::quiet_NaN(); });
}

}  // namespace counterpart::cli
