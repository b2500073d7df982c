// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Every constant of the method, in the order in which its steps run. Lengths are in units of sqrt(area of the
// full shape). docs/methods/partial.md says what each step is worth.
#pragma once

#include "match/spectral/tuning.hpp"

#include <counterpart/base/types.hpp>

#include <array>
#include <cstddef>

namespace counterpart::partial_match {

/// Step 1, each surface for itself.
struct SurfaceTuning {
    int samples_ratio = 4;                          ///< samples of the whole for each of the part
    std::array<double, 3> radii{0.06, 0.10, 0.15};  ///< of SHOT; no single one serves all shapes
    double spacing = 0.008;                         ///< of the points that SHOT counts
    double max_points = 60000;                      ///< about; a part of a wrong scale would have any number
    int n_boundary = 250;  ///< boundary vertices through which lower bounds are taken
};

/// Step 2, samples matched by agreement of distances.
struct ConsensusTuning {
    int n_candidates =
        12;  ///< target samples per source sample; with 6 a person with holes is wrong once in 10
    double sigma = 0.03, sigma_slope = 0.06;  ///< tolerance of a distance d: sigma + sigma_slope * d
    double interval_length = 0.15;            ///< a distance known to within this counts half
    double far_length = 0.3;                  ///< a distance of this length counts half
    double min_distance = 0.02;               ///< closer pairs say nothing
    double frame_distance = 0.25;             ///< closer pairs must agree in how their normals are turned
    double frame_sigma = 0.35;
    double landmark_weight = 10;  ///< of a pair with a known partner against other pairs
    int n_seeds = 60, n_seeds_per_sample = 3;
    int n_power_steps = 8, n_gated_steps = 3;
    double gate = 0.01;         ///< of the greatest affinity to the seed: below, a match is not its friend
    double loser_weight = 0.3;  ///< of the square of what a candidate has against its sample's best
    int n_choice_rounds = 8;
    double min_support = 0.45;  ///< of the median; samples of less do not vote
    double same_share = 0.8;    ///< of equal images at which two clusters are one
    double min_total = 0.7;     ///< of the best cluster's, to be kept
    std::size_t n_clusters = 8;
};

/// Step 3, images chosen among all target samples.
struct RelabelingTuning {
    int n_rounds = 6;
    double sigma = 0.02, sigma_slope = 0.05, near_length = 0.06;
    double similarity_weight = 0.15;
    double min_changed = 0.02;                 ///< share of samples that move; below it the rounds end
    double vote_from = 0.5, vote_range = 0.4;  ///< of the median support: a vote counts 0 below, 1 above
};

/// Step 4, a map of all vertices from that of the samples.
struct AnchoringTuning {
    std::size_t n_anchors = 16;
    double min_vote = 0.05;
    double radius_factor = 1.3, radius_margin = 0.08;
    double max_difference = 0.12, near_length = 0.03;
};

/// Step 2 for two parts, one laid onto the other as a whole.
struct PlacementTuning {
    double cell = 0.03, margin = 0.2;  ///< of the grids in which the nearest vertices are looked up
    int n_points = 225;                ///< of each surface, that ask for what is nearest on the other
    int n_first_points = 60;           ///< the same, before ICP
    int n_from = 40, n_to = 150, n_angles = 16;  ///< samples laid on samples, turned about the normal
    double gap = 0.06;                           ///< standard deviation
    double misfit_weight = 0.7;
    double landmark_weight = 1, far = 0.5;  ///< of what landmarks are apart, at most
    int n_settled = 600, n_icp_rounds = 15;
    double same_place = 0.12;
    int n_placements = 10;
};

/// Steps 5 and 8, the source bent onto the target.
struct FitTuning {
    int n_rounds = 8, n_first_iterations = 12, n_iterations = 4;
    double first_length = 1, last_length = 0.14;  ///< the fits keep shapes below this size
    double normal_weight = 0.1;                   ///< a full turn of the normal counts as twice this distance
    double robust_factor = 2, min_scale = 0.005;  ///< of the median distance: points farther away hardly pull
    double pin_trust = 1;  ///< in a landmark; the most that another vertex has; no other was tried
    /// Of its trust, in what must not pull: where a fit is wrong about that, it can still come back. With
    /// 1e-6 throughout, errors of parts of one shape are 2.5 in place of 3.1 where they overlap by 40 % and
    /// more, and one pair of animals in seven goes astray. Above 0, so that a piece without any pull has a
    /// place.
    double held_share = 1e-3, least_trust = 1e-6;
    double min_trust = 1e-3, turned_trust = 0.05, min_cosine = 0.2;
    double beyond_trust = 0.05;  ///< in an image on the target's boundary: the part may go on beyond it
};

/// Steps 7 and 8, who has a partner.
struct OverlapTuning {
    double normal_weight = 0.1;
    double max_gap = 0.06, min_cosine = 0;  ///< between partners
    /// This far beyond a boundary, in mean edge lengths there, a vertex still has a partner. Whole to holes
    /// (dev), missed and invented: 7.4 and 10.7 % at 1, 7.9 and 10.1 % at 0.75, 8.4 and 9.3 % at 0.5.
    /// Distances along the surface, out of the boundary, in place of those in space give 6.3 and 11.4 % at
    /// 0.5, 8.2 and 10.3 % at 0: no better.
    double beyond_edges = 0.5;
};

/// Of step 7, where both meshes are parts. On 9 pairs of parts of one shape, chosen on them, islands cost 1 %
/// more missed vertices and take a quarter of the invented ones away.
struct IslandTuning {
    double min_share = 0.2;  ///< of the area of the largest region; no other was tried
};

/// Where the scale is not known: the part's area is taken to be at least `min_share` and at most `max_share`
/// of the whole's, and of two parts neither more than `max_ratio` times the other's.
struct ScaleTuning {
    double min_share = 0.1, max_share = 1.1, max_ratio = 4;
    double step = 1.15;  ///< between scales that are tried
    int n_refinements = 3;
    int n_samples = 100;                             ///< of the part, for each scale that is tried
    double min_distance = 0.05, max_distance = 0.5;  ///< of the pairs that refine it
};

/// Confidence and messages. None of these changes the map.
struct ConfidenceTuning {
    /// Of the logistic curve: on people and cut shapes, scores of 0.7 and more go with mean errors of 1 to 3,
    /// of 0.64 with 2 to 6, of 0.6 and less with 4 to 12. 0.5 (too sure of wrong maps between parts) tried.
    double half_score = 0.63, score_width = 0.04;
    /// Difference of totals at which a runner-up counts 1 / e. Where it is below 0.05, one map in two is
    /// wrong; 0.02 tried.
    double temperature = 0.05;
    /// Likewise of scores, of two parts: what lies falsely on the other part may fit it best and yet look no
    /// more like it than elsewhere. Of 6 pairs of ends of femurs that do not overlap, runners-up look as
    /// alike in 5 (mean confidence 0.25 and less, else up to 0.52), of 6 that do in none. 0: totals alone
    /// count.
    double likeness_temperature = 0;
    /// Of the larger share of a mesh that has partners; if one is covered by the other, it is 1.
    double half_share = 0, share_width = 0.04;
    double same_place = 0.15;  ///< images closer than this agree
    double gap_length = 0.05;  ///< between a vertex and its image, at which confidence falls to 1 / e
    /// Of two parts (see PartnerMaps): 7 pairs of cuts that do not overlap have misfits of 0.20 to 0.60,
    /// 4 wrong maps of parts that do 0.22 to 0.49, 10 of 13 right ones below 0.2.
    double half_misfit = 0.25, misfit_width = 0.04, much_misfit = 0.2;
    double poor_score = 0.5, close_margin = 0.03;
    double all_fits = 0.95;  ///< share of the area of a mesh that has partners, from which on all of it has
    double least_moved =
        0.05;  ///< share of the part that a runner-up takes elsewhere; below, it is the same map
    /// Mean confidence. Of parts matched to shapes of other classes it is 0.26 and less, of half an egg at
    /// some scale on a body up to 0.35; of the 130 right and 22 wrong maps of the parts sets 6 and 1 lie
    /// between 0.3 and 0.4.
    double unsure = 0.4;
};

/// Which of the ways in which a part fits is taken. Set by hand after a look at pairs with right
/// and wrong ways; not fitted.
struct ChoiceTuning {
    double agreement = 0.5;    ///< weight of the agreement of distances, against 1 for likeness
    double strain = 0.03;      ///< of the logarithm of the strain, taken off
    double min_strain = 1e-4;  ///< smaller strains count as this
};

/// Step 8 begins where step 5 ends, and as stiff; what lies up to four times the median distance
/// away pulls, so that the surface slides less as it becomes pliable. Mean errors (dev) of holes, cuts,
/// pfaust_h and pfaust_m are 2.62, 1.06, 1.71 and 1.94 without it, 2.21, 0.82, 1.47 and 1.58 with it, when
/// it still began at the images of step 5 rather than where that had bent the surface to (so, too, what
/// follows). Tried: last lengths of 0.08, 0.04, 0.02, each better than the one before, and 0.01, not better;
/// 8 rounds (holes 2.26, pfaust_h 1.49) and 16 (2.18, 1.43; a tenth of a second more); 3, 4, 6 and 8 medians,
/// within 0.1 of each other. So pliable a fit is not for choosing: wrong ways come closer to right ones.
constexpr FitTuning pliable_fit{
    .n_rounds = 12, .n_first_iterations = 4, .first_length = 0.14, .last_length = 0.02, .robust_factor = 4};

/// Of two parts: what fits, against what does not without a boundary for a reason.
struct GainTuning {
    double gap = 0.03;  ///< standard deviation
    double normal_weight = 0.1;
    double lack_weight = 0.7;
};

/// Of two parts: how many ways are tried, and on how many vertices.
struct RaceTuning {
    Index n_vertices = 3000;
    std::size_t n_groups = 3, n_relabeled = 6, n_leaders = 5;  ///< the leaders are bent on all vertices
    double likeness = 0.5;    ///< weight of SHOT's similarity where the parts fit, against 1 for the gain
    double same_place = 0.1;  ///< mean distance of vertices at which two ways are one
};

/// Of two parts whose scales are not known: fewer placements, at each of many scales.
struct PartScaleTuning {
    double step = 1.2;
    PlacementTuning placement{
        .n_first_points = 40, .n_from = 30, .n_to = 100, .n_angles = 12, .n_settled = 300, .n_placements = 1};
};

/// Of two parts. The score is taken where they fit, and is higher than of a part that must fit as a whole:
/// right maps of one shape have 0.71 to 0.91 (of 8), of unlike animals 0.57 to 0.79, wrong ones up to 0.78.
/// Below a share in common of 0.3, two wrong ones in three score as right ones.
constexpr ConfidenceTuning confidence_of_parts{
    .half_score = 0.77, .likeness_temperature = 0.02, .half_share = 0.3};

struct PartialTuning {
    SurfaceTuning surface;
    ConsensusTuning consensus;
    RelabelingTuning relabeling;
    std::size_t n_fits = 3;      ///< relabeled maps that are tried out on all vertices
    double min_plausible = 0.8;  ///< of the best one's likeness times agreement
    PlacementTuning placement;
    AnchoringTuning anchoring;
    FitTuning fit, finish = pliable_fit;
    GainTuning gain;
    RaceTuning race;
    OverlapTuning overlap;
    /// After step 8, where the whole shows all of the part. Whole to holes (dev), missed and invented by the
    /// largest gap: 5.4 and 12.2 % at 0.06, 6.9 and 7.4 % at 0.03, 9.4 and 5.6 % at 0.02 (and half as far
    /// beyond boundaries). Two parts may be of two animals and keep 0.06: with 0.03, IoU falls from 0.67 to
    /// 0.59.
    OverlapTuning finished_overlap{.max_gap = 0.03};
    IslandTuning islands;
    ScaleTuning scale;
    PartScaleTuning part_scale;
    ChoiceTuning choice;
    ConfidenceTuning confidence, part_confidence = confidence_of_parts;
    spectral_match::PriorTuning requests;
    double judge_radius = 0.10;  ///< of SHOT at the images
};

}  // namespace counterpart::partial_match
