// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// morph FIRST LAST [IN_BETWEENS [THREADS]]: seconds of set-up and per frame (median), and how well the
// in-betweens keep edge lengths and volume, with linear blending beside them.
#include <counterpart/base/progress.hpp>
#include <counterpart/io/mesh_file.hpp>
#include <counterpart/transfer/morph.hpp>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>

namespace {

using namespace counterpart;

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

struct Worst {
    MorphQuality value{0, 0, 1e300, 0};
    void add(const MorphQuality& quality) {
        value.mean_edge_error = std::max(value.mean_edge_error, quality.mean_edge_error);
        value.largest_edge_error = std::max(value.largest_edge_error, quality.largest_edge_error);
        value.volume_ratio = std::min(value.volume_ratio, quality.volume_ratio);
        value.inverted_triangles += quality.inverted_triangles;
    }
    void print(const char* method, const char* extra) const {
        std::printf(
            "{\"method\": \"%s\", \"worst_mean_edge_error\": %.5f, \"largest_edge_error\": %.4f, "
            "\"least_volume_ratio\": %.4f, \"inverted_triangles\": %d%s}\n",
            method, value.mean_edge_error, value.largest_edge_error, value.volume_ratio,
            value.inverted_triangles, extra);
    }
};

int run(int argc, char** argv) {
    const TriangleMesh first = read_mesh(argv[1]).mesh;
    const Points last = read_mesh(argv[2]).mesh.vertices;
    const int count = argc > 3 ? std::atoi(argv[3]) : 24;
    MorphOptions options;
    options.n_threads = argc > 4 ? std::atoi(argv[4]) : 0;
    auto start = std::chrono::steady_clock::now();
    const Morph morph(first, last, options);
    const double set_up = seconds_since(start);
    const std::vector<Points> frames = morph_frames(first, last, count, options);
    Worst rigid, linear;
    std::vector<double> seconds;
    Points before = first.vertices, linear_before = first.vertices;
    for (int k = 1; k <= count + 1; ++k) {
        const double time = static_cast<double>(k) / (count + 1);
        start = std::chrono::steady_clock::now();
        if (k <= count) {
            morph.at(time);
            seconds.push_back(seconds_since(start));
        }
        Points frame = k <= count ? frames[static_cast<std::size_t>(k) - 1] : last;
        rigid.add(measure_morph(first, last, time, frame, before));
        before = std::move(frame);
        Points blend = (1 - time) * first.vertices + time * last;
        linear.add(measure_morph(first, last, time, blend, linear_before));
        linear_before = std::move(blend);
    }
    std::sort(seconds.begin(), seconds.end());
    char extra[200];
    std::snprintf(extra, sizeof extra,
                  ", \"vertices\": %d, \"frames\": %d, \"threads\": %d, \"set_up_seconds\": %.4f, "
                  "\"frame_seconds\": %.4f",
                  first.n_vertices(), count, options.n_threads, set_up, seconds[seconds.size() / 2]);
    rigid.print("morph", extra);
    linear.print("linear", "");
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 3) {
        std::fputs("usage: morph FIRST LAST [IN_BETWEENS [THREADS]]\n", stderr);
        return 2;
    }
    try {
        return run(argc, argv);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "error: %s\n", error.what());
        return 1;
    }
}
