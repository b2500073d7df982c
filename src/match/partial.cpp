// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "base/parallel.hpp"
#include "base/to_size.hpp"
#include "match/partial/cleaned.hpp"
#include "match/partial/confidence.hpp"
#include "match/partial/extent.hpp"
#include "match/partial/fused.hpp"
#include "match/partial/mirror_image.hpp"
#include "match/partial/overlap.hpp"
#include "match/partial/pipeline.hpp"
#include "match/partial/placements.hpp"
#include "match/partial/race.hpp"
#include "match/partial/requests.hpp"
#include "match/partial/roles.hpp"
#include "match/spectral/priors.hpp"
#include "match/spectral/requests.hpp"
#include "match/surface/openness.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/match/partial.hpp>
#include <counterpart/mesh/measure.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <fmt/format.h>

namespace counterpart {
namespace {

using namespace partial_match;
using surface_match::Preprocessed;

void require_valid(const PartialOptions& options, MeshView source, MeshView target) {
    if (options.n_samples < 200 || options.n_samples > 5000)
        throw InvalidInput(
            fmt::format("the number of samples must be from 200 to 5000, not {}", options.n_samples));
    spectral_match::require_valid(as_of_spectral(options), source.n_vertices(), target.n_vertices());
    // Each of a part's samples and landmarks has 12 candidates, whose agreement with all others is kept.
    constexpr int most_part_samples = 2000;
    const int most_pairs = most_part_samples - options.n_samples / SurfaceTuning().samples_ratio;
    for (const auto* pairs : {&options.landmarks, &options.excluded})
        if (std::ssize(*pairs) > most_pairs)
            throw InvalidInput(
                fmt::format("{} {} pairs with {} samples: the agreement of all with all takes more than 2.3 "
                            "GB; give at most {}, or a map of all to begin with",
                            pairs->size(), pairs == &options.landmarks ? "landmark" : "excluded",
                            options.n_samples, most_pairs));
}

TriangleMesh in_units(MeshView mesh, double unit) {
    TriangleMesh result = mesh.copy();
    const Eigen::RowVector3d center = surface_centroid(mesh).transpose();
    result.vertices.rowwise() -= center;
    result.vertices /= unit;
    return result;
}

// One pair of meshes: the part is bent onto the whole, whichever of them is the source.
class PartialMatching {
  public:
    /// `part` is known, and not neither. The meshes must outlive this.
    PartialMatching(const Preprocessed& source, const Preprocessed& target, Part part,
                    const PartialOptions& options, Stopwatch watch, const ProgressRange& progress)
        : options_(options),
          progress_(progress),
          watch_(std::move(watch)),
          source_(source),
          target_(target),
          bends_source_(part == Part::source ||
                        (part == Part::both &&
                         surface_match::openness(source_.mesh) >= surface_match::openness(target_.mesh))) {
        result_.part = part;
    }

    PartialResult run() {
        // Measured from 5000 to 290000 vertices: distances grow with the vertices, trying scales does not.
        const double measured = options_.same_scale ? 0.6 : 0.3,
                     scaled = options_.same_scale ? measured : 0.75;
        measure(progress_.part(0, measured));
        if (!options_.same_scale) rescale(progress_.part(measured, scaled));
        const SamplePair pair(*part_, *whole_, static_cast<Index>(options_.landmarks.size()),
                              tuning_.surface);
        const ProgressRange fitting = progress_.part(scaled, 0.9);
        std::vector<Fit> found = part_is_covered()
                                     ? fits(pair, pins(), tuning_, options_.seed, watch_, fitting)
                                     : fits_of_two_parts(pair, fitting);
        if (found.empty()) throw NumericalError("no two samples of the meshes can be matched");
        rank(found, *part_, *whole_, requests(), tuning_.requests);
        take(found, finish(pair, found.front().bent, part_is_covered(), tuning_, progress_.part(0.9, 0.98)));
        result_.stages = watch_.stages();
        return std::move(result_);
    }

  private:
    const Preprocessed& of_part() const { return bends_source_ ? source_ : target_; }
    const Preprocessed& of_whole() const { return bends_source_ ? target_ : source_; }
    int n_part_samples() const { return options_.n_samples / tuning_.surface.samples_ratio; }
    bool part_is_covered() const { return result_.part != Part::both; }

    // Both surfaces in one unit: the square root of the whole's area; of two parts, of the larger one's.
    void measure(const ProgressRange& progress) {
        // Of two at once the larger one tells how far they are.
        const bool part_is_larger = of_part().mesh.n_vertices() > of_whole().mesh.n_vertices();
        const ProgressRange silent;
        const double part_area = surface_area(of_part().mesh), whole_area = surface_area(of_whole().mesh);
        const double area =
            result_.part == Part::both && options_.same_scale ? std::max(part_area, whole_area) : whole_area;
        scale_ = options_.same_scale ? 1 : std::sqrt(whole_area / part_area);
        std::vector<Index> on_part, on_whole;
        for (const auto& [s, t] : options_.landmarks) {
            on_part.push_back(of_part().matched_of_input[static_cast<std::size_t>(bends_source_ ? s : t)]);
            on_whole.push_back(of_whole().matched_of_input[static_cast<std::size_t>(bends_source_ ? t : s)]);
        }
        parallel_invoke(
            [&] {
                part_.emplace(in_units(of_part().mesh, std::sqrt(area) / scale_), n_part_samples(), on_part,
                              tuning_.surface, part_is_larger ? progress : silent);
            },
            [&] {
                whole_.emplace(in_units(of_whole().mesh, std::sqrt(area)), options_.n_samples, on_whole,
                               tuning_.surface, part_is_larger ? silent : progress);
            });
        watch_.lap("surfaces");
    }

    // The landmarks, on the part and on the whole, unless they are soft.
    std::vector<std::pair<Index, Index>> pins() const {
        std::vector<std::pair<Index, Index>> pairs;
        for (std::size_t u = 0; !options_.soft_landmarks && u < options_.landmarks.size(); ++u)
            pairs.emplace_back(part_->samples[u], whole_->samples[u]);
        return pairs;
    }

    // What is known of the map besides landmarks, on the part and on the whole.
    Requests requests() const {
        Requests known{{}, spectral_match::common_directions(as_of_spectral(options_))};
        for (const auto& [s, t] : options_.excluded)
            known.excluded.emplace_back(of_part().matched_of_input[to_size(bends_source_ ? s : t)],
                                        of_whole().matched_of_input[to_size(bends_source_ ? t : s)]);
        return known;
    }

    // Both have unit area now.
    void rescale(const ProgressRange& progress) {
        const ScaleTuning& tuning = tuning_.scale;
        const bool two_parts = result_.part == Part::both;
        const double least = std::sqrt(two_parts ? 1 / tuning.max_ratio : tuning.min_share),
                     most = std::sqrt(two_parts ? tuning.max_ratio : tuning.max_share);
        const auto n_landmarks = static_cast<Index>(options_.landmarks.size());
        const double factor = two_parts ? scale_of_parts(*part_, *whole_, n_landmarks, least, most, tuning_)
                                        : find_scale(*part_, *whole_, n_landmarks, least, most, tuning_,
                                                     options_.seed, progress);
        part_ = rescaled(*part_, factor, tuning_.surface);
        scale_ *= factor;
        watch_.lap("scale");
    }

    std::vector<Fit> fits_of_two_parts(const SamplePair& pair, const ProgressRange& progress) {
        const std::vector<Placement> placed =
            placements(*part_, *whole_, pair.n_landmarks, {1}, tuning_.placement);
        progress.reach(0.1);
        result_.gain_in_mirror =
            gain_in_mirror(*part_, *whole_, pair.n_landmarks, placed.front(), tuning_.placement);
        watch_.lap("placements");
        return fits_of_parts(pair, placed, pins(), tuning_, options_.seed, watch_, progress.part(0.2, 1));
    }

    // A map between the cleaned meshes as one between the inputs.
    static VertexMap lifted(const std::vector<Index>& map, const Preprocessed& from, const Preprocessed& to) {
        std::vector<Index> image;
        for (const Index v : from.matched_of_input) {
            const Index w = map[static_cast<std::size_t>(v)];
            image.push_back(w < 0 ? w : to.input_of_matched[static_cast<std::size_t>(w)]);
        }
        return {std::move(image), static_cast<Index>(to.matched_of_input.size())};
    }

    VertexMap target_from_source(const PartnerMaps& maps) const {
        return lifted(bends_source_ ? maps.whole_from_part : maps.part_from_whole, source_, target_);
    }

    void take(const std::vector<Fit>& found, const Finished& finished) {
        watch_.lap("finish");
        const PartnerMaps& best = finished.maps;
        result_.target_from_source = target_from_source(best);
        result_.source_from_target =
            lifted(bends_source_ ? best.part_from_whole : best.whole_from_part, target_, source_);
        result_.scale = bends_source_ ? scale_ : 1 / scale_;
        result_.score = found.front().score;
        result_.agreement = found.front().agreement;
        result_.margin =
            found.size() > 1 ? found[0].total - found[1].total : std::numeric_limits<double>::infinity();
        const double part_share = matched_area(best.whole_from_part, of_part().mesh),
                     whole_share = matched_area(best.part_from_whole, of_whole().mesh);
        result_.source_share = bends_source_ ? part_share : whole_share;
        result_.target_share = bends_source_ ? whole_share : part_share;
        for (std::size_t i = 1; i < found.size() && static_cast<int>(i) <= options_.n_alternatives; ++i)
            result_.alternatives.push_back(
                {target_from_source(partners(*part_, *whole_, found[i].bent, part_is_covered(),
                                             tuning_.overlap, tuning_.islands)),
                 found[i].score, share_moved(found[0].bent, found[i].bent, *whole_, tuning_.confidence)});
        const ConfidenceTuning& trust = part_is_covered() ? tuning_.confidence : tuning_.part_confidence;
        const Finish finish{finished.misfit, part_is_covered() ? 1 : std::max(part_share, whole_share)};
        const Vector of_part_vertices = confidence(*part_, *whole_, found, finish, trust);
        result_.confidence.resize(result_.target_from_source.source_size());
        for (Index v = 0; v < result_.confidence.size(); ++v) {
            const Index own = source_.matched_of_input[static_cast<std::size_t>(v)];
            const Index on_part = bends_source_ ? own : best.part_from_whole[static_cast<std::size_t>(own)];
            result_.confidence[v] = result_.target_from_source[v] == VertexMap::unmatched
                                        ? whole_confidence(found.front(), finish, trust)
                                        : of_part_vertices[on_part];
        }
        result_.messages =
            messages_on(result_, source_, target_, finished.misfit,
                        best_elsewhere(found, *whole_, tuning_.confidence), tuning_.confidence);
        watch_.lap("confidence");
    }

    static double matched_area(const std::vector<Index>& map, MeshView mesh) {
        const Vector areas = vertex_areas(mesh);
        double matched = 0;
        for (std::size_t v = 0; v < map.size(); ++v) matched += map[v] < 0 ? 0 : areas[static_cast<Index>(v)];
        return matched / areas.sum();
    }

    const PartialOptions& options_;
    const ProgressRange& progress_;
    const PartialTuning tuning_;
    Stopwatch watch_;
    const Preprocessed &source_, &target_;
    bool bends_source_;
    double scale_ = 1;  // by which the part is multiplied, relative to the whole
    std::optional<Surface> part_, whole_;
    PartialResult result_;
};

}  // namespace

std::string to_string(Part part) {
    switch (part) {
        case Part::unknown:
            return "unknown";
        case Part::source:
            return "source";
        case Part::target:
            return "target";
        case Part::both:
            return "both";
        case Part::neither:
            return "neither";
    }
    return "unknown";
}

PartialResult match_partial(MeshView source, MeshView target, const PartialOptions& options) {
    counterpart::require_valid(source);
    counterpart::require_valid(target);
    require_valid(options, source, target);
    if (options.mirrored) {
        PartialOptions of_image = options;
        of_image.mirrored = false;
        PartialResult result =
            match_partial(source, mirror_image(target, options.up, options.facing), of_image);
        result.mirrored = true;
        result.gain_in_mirror = 0 - result.gain_in_mirror;  // of the target as given, and never -0
        return result;
    }
    return with_progress(options.progress, [&](const ProgressRange& progress) {
        return with_threads(options.n_threads, [&] {
            Stopwatch watch;
            const Preprocessed a = cleaned(source, "source"), b = cleaned(target, "target");
            const Part part = options.part == Part::unknown ? seen_part(a.mesh, b.mesh) : options.part;
            const int n_samples = options.n_samples + static_cast<int>(options.landmarks.size());
            if (part != Part::neither) require_room_for_distances(a, b, n_samples);
            watch.lap("clean");
            if (part == Part::neither)
                return match_fused(source, target, options, {}, {}, std::move(watch), progress);
            const bool may_be_whole = options.part == Part::unknown && part == Part::both;
            PartialResult found = PartialMatching(a, b, part, options, std::move(watch),
                                                  progress.part(0, may_be_whole ? 0.8 : 1))
                                      .run();
            if (!may_be_whole ||
                !show_the_same_region(a, b, found.target_from_source, found.source_from_target))
                return found;
            PartialResult whole = match_fused(source, target, options, std::move(found.target_from_source),
                                              {}, Stopwatch(), progress.part(0.8, 1));
            whole.stages.insert(whole.stages.begin(), found.stages.begin(), found.stages.end());
            return whole;
        });
    });
}

}  // namespace counterpart
