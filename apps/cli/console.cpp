// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "console.hpp"

#include "interrupt.hpp"
#include "platform/process.hpp"

#include <counterpart/io/file.hpp>
#include <counterpart/io/mesh_file.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>
#include <utility>

#include <fmt/format.h>

namespace counterpart::cli {
namespace {

using Clock = std::chrono::steady_clock;

// ", about 40 s left", once there is something to tell it by.
std::string time_left(double fraction, double elapsed) {
    constexpr double least_fraction = 0.05, least_seconds = 3;
    if (fraction < least_fraction || elapsed < least_seconds || fraction >= 1) return "";
    const double seconds = elapsed * (1 - fraction) / fraction;
    if (seconds < 90) return fmt::format(", about {:.0f} s left", seconds);
    return fmt::format(", about {:.0f} min left", seconds / 60);
}

ReadOptions reading(const MeshInput& mesh, const CommonOptions& options) {
    ReadOptions read = options.read;
    read.object = mesh.object;
    return read;
}

// "source_object" of "--source-object".
std::string key_of(const std::string& option) {
    std::string key = option.substr(2);
    std::replace(key.begin(), key.end(), '-', '_');
    return key;
}

class Bar {
  public:
    explicit Bar(std::string label) : label_(std::move(label)) {}
    Bar(const Bar&) = delete;
    Bar& operator=(const Bar&) = delete;
    ~Bar() {
        if (shown_) std::fputs("\r\033[K", stderr);
    }

    void show(double fraction) {
        const auto now = Clock::now();
        if (now - start_ < std::chrono::seconds(1) || now - last_ < std::chrono::milliseconds(100)) return;
        last_ = now;
        shown_ = true;
        constexpr int width = 40;
        const auto filled = std::lround(fraction * width);
        std::fputs(fmt::format("\r{} [{}{}] {:3.0f} %{}\033[K", label_,
                               std::string(static_cast<std::size_t>(filled), '='),
                               std::string(static_cast<std::size_t>(width - filled), ' '), 100 * fraction,
                               time_left(fraction, std::chrono::duration<double>(now - start_).count()))
                       .c_str(),
                   stderr);
        std::fflush(stderr);
    }

  private:
    std::string label_;
    Clock::time_point start_ = Clock::now(), last_ = start_;
    bool shown_ = false;
};

}  // namespace

void add_common_options(CLI::App& command, CommonOptions& options) {
    command
        .add_option("--threads", options.threads, "Number of threads; 0 = all. Does not change the result")
        ->check(whole_number(0, 1024))
        ->capture_default_str();
    command.add_flag("--allow-external", options.read.allow_external,
                     "Let glTF files refer to files outside their own folder; only for files you trust");
    command.add_flag(
        "--strict", options.read.strict,
        "Refuse meshes with vertices whose coordinates are no numbers, instead of leaving these out");
    command.add_flag("-q,--quiet", options.quiet, "Print only warnings and errors");
    add_output(command, options.files, "--report", options.report, Content::report,
               "Write results and timings to this JSON file");
}

std::string counted(Index count, const std::string& noun) {
    return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

std::string readable(double number) {
    const bool is_plain = std::abs(number) >= 100 && std::abs(number) < 1e6;
    return is_plain ? fmt::format("{:.0f}", number) : fmt::format("{:.3g}", number);
}

std::string rounded_percent(double share) {
    constexpr double least = 0.005;  // that is not 0 % when rounded
    return share > 0 && share < least ? "less than 1 %" : fmt::format("{:.0f} %", 100 * share);
}

void say(const CommonOptions& options, const std::string& message) {
    if (!options.quiet) std::fputs((message + "\n").c_str(), stderr);
}

void print(const CommonOptions& options, const std::string& text) {
    if (!options.quiet) print(text);
}

void warn(const std::string& message) { std::fputs(("warning: " + message + "\n").c_str(), stderr); }

TriangleMesh load_mesh(const MeshInput& mesh, const CommonOptions& options) {
    MeshFile loaded = read_mesh(mesh, reading(mesh, options));
    for (const std::string& notice : loaded.notices) say(options, utf8_name(mesh) + ": " + notice);
    return std::move(loaded.mesh);
}

AttributedMesh load_attributed_mesh(const MeshInput& mesh, const CommonOptions& options) {
    AttributedMeshFile loaded = read_attributed_mesh(mesh, reading(mesh, options));
    for (const std::string& notice : loaded.notices) say(options, utf8_name(mesh) + ": " + notice);
    return std::move(loaded.content);
}

bool holds_tetrahedra(const std::filesystem::path& file) {
    const std::vector<std::string> solids = mesh_extensions().written_solids;
    return std::find(solids.begin(), solids.end(), lower_extension(file)) != solids.end();
}

std::optional<TetrahedralMesh> load_solid(const MeshInput& mesh, const CommonOptions& options) {
    if (mesh.object && *mesh.object != "0") return std::nullopt;  // load_mesh refuses any other
    std::optional<TetrahedralMeshFile> loaded = read_tetrahedral_mesh(mesh);
    if (!loaded) return std::nullopt;
    for (const std::string& notice : loaded->notices) say(options, utf8_name(mesh) + ": " + notice);
    return std::move(loaded->mesh);
}

std::optional<std::pair<TetrahedralMesh, TetrahedralMesh>> load_solids(const MeshInput& source,
                                                                       const MeshInput& target,
                                                                       const CommonOptions& options) {
    const std::vector<std::string> known = mesh_extensions().read_solids;
    for (const MeshInput* mesh : {&source, &target})
        if (std::find(known.begin(), known.end(), lower_extension(*mesh)) == known.end()) return std::nullopt;
    auto first = load_solid(source, options);
    if (!first) return std::nullopt;
    auto second = load_solid(target, options);
    if (!second) return std::nullopt;
    return std::pair(*std::move(first), *std::move(second));
}

Progress progress_bar(const std::string& label, const CommonOptions& options) {
    if (options.quiet || !platform::is_terminal()) return [](double) { return !is_interrupted(); };
    return [bar = std::make_shared<Bar>(label)](double fraction) {
        bar->show(fraction);
        return !is_interrupted();
    };
}

void write_report(const Json& report, const CommonOptions& options) {
    if (options.report.empty()) return;
    Json whole = report;
    for (const FileArgument& file : options.files)
        if (file.mesh != nullptr && file.mesh->object) whole[key_of(file.object_option)] = *file.mesh->object;
    whole["peak_memory_bytes"] = platform::peak_memory();
    // Names in files may be in any encoding.
    write_file(whole.dump(2, ' ', false, Json::error_handler_t::replace) + "\n", options.report);
}

Json to_json(const std::vector<StageTime>& stages) {
    Json json = Json::object();
    for (const StageTime& stage : stages) json[stage.stage] = stage.seconds;
    return json;
}

}  // namespace counterpart::cli
