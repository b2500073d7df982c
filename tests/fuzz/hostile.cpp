// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// hostile FIRST COUNT [small]: matches, transfers, morphs, pictures and shows the hostile pairs of these
// seeds, or those of small meshes, with 1, 2 and 8 threads. A pair fails if that ends otherwise than with a
// result or a refusal, takes over 10 s of CPU, or gives other bytes for another number of threads. Prints one
// JSON line; the exit status is 1 if a pair failed or the memory reached 1 GB.
#include "fuzz/hostile_mesh.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/match/match.hpp>
#include <counterpart/render/figures.hpp>
#include <counterpart/transfer/morph.hpp>
#include <counterpart/transfer/transfer.hpp>
#include <counterpart/viewer/viewer_page.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>

#include <sys/resource.h>

namespace counterpart::fuzz {
namespace {

constexpr double most_seconds = 10;
constexpr double most_megabytes = 1024;

/// What came out, as bytes to compare.
class Bytes {
  public:
    template <class Array>
    void add(const Array& values) {
        text_.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(*values.data()));
    }
    bool operator==(const Bytes&) const = default;

  private:
    std::string text_;
};

class Trial {
  public:
    Trial(const HostilePair& pair, int n_threads, std::map<std::string, int>& refusals)
        : pair_(pair), n_threads_(n_threads), refusals_(refusals) {}

    Bytes run() {
        step("match", [&] {
            MatchOptions options;
            options.n_threads = n_threads_;
            const MatchResult result = match(pair_.source, pair_.target, options);
            map_ = result.target_from_source;
            bytes_.add(map_.image());
            bytes_.add(result.confidence);
        });
        if (map_.source_size() == 0) return bytes_;
        step("transfer", [&] { carry_colors(); });
        step("morph", [&] { morph_once(); });
        step("render", [&] { draw(); });
        step("view", [&] { bytes_.add(viewer_page(pair_.source, pair_.target, {{"map", map_}})); });
        return bytes_;
    }

  private:
    // A refusal is an answer, if it says why.
    template <class Work>
    void step(const std::string& name, const Work& work) {
        try {
            work();
        } catch (const InvalidInput& error) {
            refused(name, error.what());
        } catch (const NumericalError& error) {
            refused(name, error.what());
        }
    }

    void refused(const std::string& name, const std::string& why) {
        if (why.empty()) throw std::logic_error(name + " refuses without a reason");
        if (n_threads_ == 1) ++refusals_[name];
        bytes_.add(why);
    }

    void carry_colors() {
        AttributedMesh source, target;
        source.mesh = pair_.source;
        target.mesh = pair_.target;
        source.colors.push_back({Matrix::Constant(source.mesh.n_vertices(), 3, 0.5), source.mesh.triangles});
        TransferOptions options;
        options.n_threads = n_threads_;
        for (const CornerAttribute& colors : transfer(source, target, map_, options).content.colors)
            bytes_.add(colors.values);
    }

    void morph_once() {
        MorphOptions options;
        options.n_threads = n_threads_;
        const LastPose last = last_pose(pair_.source, pair_.target, surface_map_of(map_, pair_.target));
        for (const Points& frame : morph_frames(pair_.source, last.vertices, 1, options)) bytes_.add(frame);
    }

    void draw() {
        using namespace render;
        const Camera camera = find_camera(pair_.source);
        std::array<Placement, 2> placements = {
            Placement(pair_.source, camera),
            Placement(pair_.target, matching_camera(camera, pair_.source, pair_.target, map_))};
        arrange_in_row(placements);
        RenderOptions options;
        options.width = 96;
        options.height = 64;
        options.n_threads = n_threads_;
        const Image image = render::render(
            line_scene({pair_.source, placements[0]}, {pair_.target, placements[1]}, map_), options);
        bytes_.add(image.rgb);
    }

    const HostilePair& pair_;
    int n_threads_;
    std::map<std::string, int>& refusals_;
    VertexMap map_;
    Bytes bytes_;
};

// Of all threads: it does not depend on what else the machine does.
double cpu_seconds() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const auto seconds = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

double megabytes_at_most() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024;
}

int run(std::uint64_t first, std::uint64_t count, HostileSize size) {
    std::map<std::string, int> refusals;
    int failures = 0;
    double longest = 0;
    std::uint64_t longest_seed = first;
    for (std::uint64_t seed = first; seed < first + count; ++seed) {
        const HostilePair pair = make_hostile_pair(seed, size);
        Bytes alone;
        for (const int n_threads : {1, 2, 8}) {
            const double start = cpu_seconds();
            std::string fault;
            try {
                const Bytes bytes = Trial(pair, n_threads, refusals).run();
                if (n_threads == 1) alone = bytes;
                if (bytes != alone) fault = "other bytes than with one thread";
            } catch (const std::exception& error) {
                fault = std::string("ended by ") + error.what();
            }
            const double seconds = cpu_seconds() - start;
            if (seconds > most_seconds) fault += " took " + std::to_string(seconds) + " s of CPU";
            if (seconds > longest) {
                longest = seconds;
                longest_seed = seed;
            }
            if (fault.empty()) continue;
            ++failures;
            std::cerr << "seed " << seed << ", " << n_threads << " threads: " << fault << '\n';
        }
    }
    std::cout << R"({"first":)" << first << R"(,"pairs":)" << count << R"(,"failures":)" << failures
              << R"(,"longest_s":)" << longest << R"(,"longest_seed":)" << longest_seed
              << R"(,"most_megabytes":)" << megabytes_at_most();
    for (const auto& [name, n] : refusals) std::cout << R"(,"refused_)" << name << R"(":)" << n;
    std::cout << "}\n";
    return failures > 0 || megabytes_at_most() > most_megabytes ? EXIT_FAILURE : EXIT_SUCCESS;
}

}  // namespace
}  // namespace counterpart::fuzz

int main(int argc, char** argv) {
    using counterpart::fuzz::HostileSize;
    const bool is_small = argc == 4 && std::string_view(argv[3]) == "small";
    if (argc != 3 && !is_small) {
        std::cerr << "hostile FIRST COUNT [small]: the seeds FIRST to FIRST + COUNT - 1\n";
        return EXIT_FAILURE;
    }
    return counterpart::fuzz::run(std::strtoull(argv[1], nullptr, 10), std::strtoull(argv[2], nullptr, 10),
                                  is_small ? HostileSize::small : HostileSize::mixed);
}
