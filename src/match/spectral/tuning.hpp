// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Every constant of the method, stage by stage in the order in which the stages run. Lengths are geodesic, at
// unit surface area; times are of heat diffusion, squared lengths. docs/methods/spectral.md describes
// the stages; a constant changes only where benchmarks/compare.py shows an interval without 0.
#pragma once

#include <counterpart/base/types.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace counterpart::spectral_match {

/// An index into a container.
constexpr std::size_t at(Eigen::Index i) { return static_cast<std::size_t>(i); }

/// Stage 1, each shape for itself.
struct PreparationTuning {
    double min_component_share = 0.1;  ///< of the largest component's area; smaller components are left out
    /// Sources of rows of geodesic distance. They measure how far two maps are apart, and the average
    /// distance of a vertex, whose local maxima are the extremities.
    int n_distance_samples = 150;
    /// Distance within which an extremity is the most distant point.
    double extremity_radius = 0.08;
    /// Distance within which no more distant extremity lies beside a prominent one: an ear is one even where
    /// the neck beside it is more distant, a finger is not.
    double prominent_apart = 0.15;
    int max_extremities = 12;  ///< prominent ones first, so that no finger takes the place of the head
    /// Diffusion times of mean curvature, fine to coarse.
    std::array<double, 4> curvature_times{0.0005, 0.001, 0.003, 0.01};
    int curvature_percentile = 95;  ///< magnitudes above are clamped, so that spikes do not outweigh the rest
    /// Of one step of smoothing, for fine relief. A disk of radius r averages like 8 t = r^2: 0.05 and, after
    /// `n_relief_steps`, 0.1, the best of the radii from 0.025 to 0.2.
    double relief_time = 0.0003;
    int n_relief_steps = 4;
    /// Above this many vertices a mesh is matched by a proxy; where that does not do, eigenfunctions are
    /// sought in a subspace of local functions.
    Index large_mesh = 8000;
    Index proxy_size = 6000;       ///< vertices; 8000 are as accurate and take 10 % longer
    double min_proxy_area = 0.85;  ///< of a proxy, as a share of the full surface's
    /// Of the eigenfunctions: matching does not ask whether the last five of 200 are mixed with the next.
    /// 1e-3 takes half the time of 1e-8.
    double basis_tolerance = 1e-3;
    int min_local_functions = 3000, local_functions_per_eigenfunction = 10;
    /// Of a local function, in radii of a disk that is one sample's share of the area (Magnet and
    /// Ovsjanikov).
    double local_radius = 3;
};

/// How far apart two maps must be to count as two: on average, or in a limb. Exchanged hind legs move the
/// mean by 0.06 only: by the mean alone the right map of a horse to a cow was merged into the wrong one.
struct Distinctness {
    double mean;             ///< distance
    double moved_share = 1;  ///< of the samples, that are moved; 1 = the mean alone tells
    double moved = 0.2;      ///< a sample whose images are farther apart than this has moved
};

/// What a person says about the map, against the other scores, which are about 1.
struct PriorTuning {
    /// Of the distance beyond the slack between one end of a landmark and where the surroundings of the other
    /// end go.
    double weight = 2;
    double slack = 0.2;    ///< a right map takes the surroundings about 0.1 away
    double radius = 0.15;  ///< of the samples around a landmark, of whose images' distances the median counts
    double excluded_weight = 10;    ///< of what is missing to the radius below
    double excluded_radius = 0.15;  ///< images this near to an excluded vertex are on the wrong limb
    /// Of what is missing to the correlation below, of the coordinates along a common direction.
    double direction_weight = 1.5;
    double enough_correlation = 0.2;  ///< from here on it says no more: bodies lean and rear
};

/// Stage 2a, partial matchings of extremities that keep geodesic distances.
struct ExtremityTuning {
    std::size_t n_matchings = 24;       ///< of prominent extremities; 0 = none
    std::size_t n_fine_matchings = 12;  ///< of all extremities; 0 = none
    std::size_t beam_width = 2000;      ///< partial matchings kept while the next extremity is assigned
    std::size_t min_pairs = 3;          ///< fewer fix no map
    double average_weight = 0.5;   ///< of a difference in average distance against one in pairwise distance
    double landmark_weight = 2;    ///< likewise of one in the distance from a landmark
    double skip_cost = 0.25;       ///< of an extremity without a partner, as a distance
    double min_difference = 0.08;  ///< mean distance between the maps that two kept matchings mean
};

/// Stage 2b, shapes in similar poses laid onto each other in space.
struct ExtrinsicTuning {
    bool enabled = true;
    int n_iterations = 10;  ///< of ICP from each of 24 alignments of the principal axes
    int n_functions = 5;    ///< similar poses say little more than what the coarsest functions hold
};

/// What counts how much in the promise of a proposal, against 1 for curvature. Round numbers, fitted by
/// pairwise ranking of right against wrong maps.
struct PromiseTuning {
    int curvature_scale = 2;  ///< index into PreparationTuning::curvature_times
    double orientation = 0.15, orthogonality = 2.5, rigidity = 0.7;
    double radius = 0.3;  ///< of neighborhoods that should move rigidly
};

/// Stage 2, proposals.
struct CandidateTuning {
    ExtremityTuning extremities;
    ExtrinsicTuning extrinsic;
    std::size_t n_samples = 300;    ///< points on which proposals are grown
    int first_size = 20;            ///< eigenfunctions of the map fitted to curvature and extremities
    double curvature_weight = 0.3;  ///< of each column, against 1 for a heat kernel at an extremity
    std::vector<double> heat_times{0.005, 0.02, 0.06};
    double orientation_weight =
        0.1;  ///< of the operators at extremities that tell a map from its mirror image
    double orientation_heat_time = 0.06;
    std::size_t n_reoriented = 8;       ///< proposals whose tips give another start
    int last_size = 30, size_step = 5;  ///< eigenfunctions that proposals are grown to by ZoomOut
    PromiseTuning promise;
    std::size_t n_flipped = 16;          ///< proposals whose low columns are negated
    int first_flip = 5, last_flip = 17;  ///< columns, one at a time
    double min_new_difference = 0.03;    ///< flips that begin closer than this to an earlier one are dropped
    Distinctness distinct{.mean = 0.05};
    std::size_t n_pool = 60;
};

/// Patches that a map takes elsewhere than all that is around them.
struct IslandTuning {
    /// An edge is torn if its ends go so much farther apart than the edges around it suggest, by the median
    /// of their factors: a limb that goes to a longer one stretches all along.
    double gap = 0.04;
    double jump = 0.2;  ///< or so much farther apart along the surface: from one leg to the one beside it
    double most_growth = 4;  ///< what is expected of an edge, as a factor, at most
    double max_share = 0.1;  ///< of the area
};

/// What refinement compares. Weights are relative to the spectral coordinates, whose squared length is about
/// their number.
struct RefinementTuning {
    float feature_weight = 5;     ///< of curvature and wave kernel, each of variance 1
    int n_wave_kernel = 8;        ///< of the 40 columns, evenly spaced
    float position_weight = 200;  ///< of positions after an elastic fit of either surface to its images
    float normal_weight = 14;     ///< of the normals there
    double min_scale = 0.3, max_scale = 3;  ///< of a neighborhood in the fits, so that nothing vanishes
    double settled = 1e-4;                  ///< root mean square step at which a fit ends
    int n_kept_factors = 8;                 ///< of each shape, where it is coarse: all maps share them
    Eigen::Index most_kept_vertices = 3000;
    double pin_mass = 0.005;      ///< share of the area that a pinned vertex pulls like, in the fits
    float landmark_reach = 0.3F;  ///< nearness to a landmark is 1 there and 1/e at the reach
    float guide_weight = 100;     ///< of a vertex's share of nearness to a guide,
    float guide_offset = 0.01F;   ///< by the inverse square of the distance from it plus this
    float height_weight = 120;    ///< of the height along a common direction, from 0 to 1
    double least_height = 0.01;   ///< of a shape: flatter ones have no up there, but rounding
    IslandTuning islands{};
};

/// How a map is refined: from few functions and stiff surfaces to many functions and pliable ones.
struct Schedule {
    int n_rounds = 0;
    int first_size = 0, last_size = 0;         ///< eigenfunctions of the first and last round
    double first_length = 0, last_length = 0;  ///< the fits keep shapes below this size
    int n_iterations = 8;                      ///< of an elastic fit, at most
    int islands_from = 1000;                   ///< the round from which on islands are put back
    double back_pull = 0;        ///< of what the other map takes to a vertex, by so many times its area
    float relief_weight = 0;     ///< of fine relief, of variance 1
    float landmark_weight = 40;  ///< of nearness to a landmark; 0: they need not be followed
    /// Eigenfunctions by which the map of samples is spread over all vertices first (0: the map of vertices
    /// goes on), within one or two rings of cells around the images of samples, or, if 0, anywhere.
    int start_size = 80;
    int start_rings = 2;
};

/// Equation 4.
struct ScoreTuning {
    double normal_weight = 0.5;
    double normal_radius = 0.3;  ///< of the neighborhoods that are turned
    double damage_weight = 5;
    double most_damage = 0.2;  ///< of a vertex: what has gone astray counts no more
};

/// One stage of the race: what goes on from it.
struct Heat {
    std::size_t n_kept;  ///< maps, at most
    double behind;       ///< the best, at most, by equation 4
};

/// Stage 3, the race on coarse copies.
struct RaceTuning {
    Index n_coarse = 1000;                    ///< vertices
    std::size_t n_first = 24, n_varied = 14;  ///< proposals that enter before and after they are varied
    double close_proposal = 0.3;              ///< those whose promise is farther behind do not enter
    double min_new_difference = 0.05;         ///< nor those closer than this to one that has
    Schedule first{.n_rounds = 3,
                   .first_size = 30,
                   .last_size = 45,
                   .first_length = 0.3,
                   .last_length = 0.12,
                   .n_iterations = 5};
    /// The race is over after the first schedule where the best map is so far ahead of the next one, and then
    /// reaches so much by the second schedule.
    double sure_lead = 0.05, sure_score = 1.2;
    Heat after_first{8, 0.15}, after_second{4, 0.1}, last{3, 0.1};
    Schedule second{.n_rounds = 6,
                    .first_size = 30,
                    .last_size = 80,
                    .first_length = 0.3,
                    .last_length = 0.08,
                    .islands_from = 3};
    /// Maps are the same where they are this close, and in no limb apart.
    Distinctness distinct{.mean = 0.05, .moved_share = 0.05};
};

/// Stage 4, moves: other matchings of extremities, tried on the leaders of the race.
struct MoveTuning {
    double good_score = 1.15;  ///< a leader of so much is left as it is
    double most_apart = 0.6;   ///< there and back, of extremities that a map takes to each other
    std::size_t n_tried = 8;   ///< other matchings for each map
    Schedule guided{.n_rounds = 4,
                    .first_size = 30,
                    .last_size = 60,
                    .first_length = 0.3,
                    .last_length = 0.1,
                    .start_rings = 0};
    Schedule free{.n_rounds = 3,
                  .first_size = 30,
                  .last_size = 80,
                  .first_length = 0.2,
                  .last_length = 0.08,
                  .islands_from = 2};
    /// Moved maps begin far behind and gain 0.1 to 0.2 in two more refinements by `RaceTuning::second`.
    Heat after_moves{5, 0.25}, after_second{3, 0.12};
    Heat last{3, 0.06};  ///< before and after the moves
};

/// Stage 5, polish.
struct PolishTuning {
    /// Of the leader, grown to 80 functions: below, the shapes are nearly isometric, and it is grown on.
    double near_isometry_drift = 0.0135;
    std::vector<int> near_sizes{30, 40, 50, 60, 80}, far_sizes{95, 110, 130, 150};
    Schedule near{.n_rounds = 5,
                  .first_size = 102,
                  .last_size = 200,
                  .first_length = 0.15,
                  .last_length = 0.06,
                  .islands_from = 1,
                  .relief_weight = 8,
                  .start_size = 150};
    Index n_coarse = 2000;  ///< vertices on which other shapes are refined before
    Schedule coarse{.n_rounds = 8,
                    .first_size = 30,
                    .last_size = 120,
                    .first_length = 0.3,
                    .last_length = 0.06,
                    .islands_from = 4};
    double repeated = 0.03;  ///< maps at most so far behind are refined once more
    double back_pull = 3;    ///< where both maps pull
    Schedule last{.n_rounds = 3,
                  .first_size = 151,
                  .last_size = 200,
                  .first_length = 0.095,
                  .last_length = 0.06,
                  .islands_from = 0,
                  .back_pull = 3,
                  .relief_weight = 4,
                  .start_size = 0};
    /// Where a map is given instead of found.
    Schedule given{.n_rounds = 4,
                   .first_size = 115,
                   .last_size = 200,
                   .first_length = 0.13,
                   .last_length = 0.06,
                   .islands_from = 1,
                   .back_pull = 3,
                   .start_size = 0};
    double slack = 0.02;  ///< the last refinement counts unless equation 4 falls by more
    int runner_up_size =
        100;  ///< eigenfunctions by which a map that was not taken is spread over all vertices
    double lift_length = 0.06;  ///< as Schedule::last_length, where a map is carried to more vertices
    int n_lift_iterations = 8;
};

/// Stage 6, confidence and messages. None of these changes the map, save `min_mirror_gain`.
struct ConfidenceTuning {
    double half_score = 0.9;     ///< at which a map is trusted by half
    double score_width = 0.12;   ///< of the logistic curve around it
    double temperature = 0.01;   ///< a runner-up so far behind counts 1 / e
    double same_place = 0.15;    ///< images closer than this agree
    double doubt_length = 0.12;  ///< of a round trip plus tear, at which confidence falls to 1 / e
    double island_trust = 0.2;   ///< what is left of it in patches that refinement has not put back
    double poor_score = 0.6;     ///< below it the map is not to be used
    /// Below the first a caution; below the second where a runner-up is close, or wherever it takes more of
    /// the surface elsewhere than `much_moved`. Of 14 right maps with close runners-up these move 2 to 18 %,
    /// one 88 %; of two wrong ones 12 and 35 %.
    double doubtful_score = 1.05, doubtful_close_score = 1.11, much_moved = 0.2;
    /// Where one mesh has more holes through it: of 12 pairs of voxelized people the 6 of unlike genus have
    /// 1.285 and more where right, 1.117 and less where wrong (4).
    double doubtful_fused_score = 1.2;
    double close_margin = 0.03;     ///< between the two best scores, below it a caution
    double min_mirror_gain = 0.03;  ///< the mirror image of an inside-out mesh must score better by this
    double moved = 0.2;             ///< a sample whose images are farther apart than this has moved
    double part_share = 0.02,
           turn_share = 0.6;      ///< of samples moved: below, a shift; above, another part, a turn
    Index many_components = 100;  ///< from here on the mesh is called disconnected fragments
    double sphere_ratio = 1.03;   ///< of the third to the first eigenvalue, below it a shape is sphere-like
};

/// Whether the target is read in the mirror.
struct MirrorTuning {
    /// From here on the glance at the mirror image is brief: `few_candidates` from n_first matchings.
    double good_score = 1.2;
    /// Proposals of the mirrored reading that are refined at first, and how much better than the best of the
    /// other reading one must be for a search.
    std::size_t n_first = 4;
    double promising = 0.06;
    /// How much better the map of a mirrored search must be to be taken, and how much worse it may be to be
    /// the first runner-up.
    double clear_gain = 0.06, close = 0.06;
    /// Where normals agree less by the other reading, poses differ, and the map must be better by so much
    /// than that of either shape to its own mirror image: of bodies in poses that mirror each other it is by
    /// 0.05 to 0.09 (3 pairs, normals 0.82 to 0.89), of bones, hands and hemispheres by 0.14 and more. Warped
    /// shapes in one pose (normals 0.93) are better by as little as 0.02.
    double same_pose = 0.9;
    double clear_of_own = 0.11;
};

struct SpectralTuning {
    PreparationTuning preparation;
    PriorTuning priors;
    CandidateTuning candidates;
    RefinementTuning refinement;
    ScoreTuning score;
    RaceTuning race;
    MoveTuning moves;
    MirrorTuning mirror;
    PolishTuning polish;
    ConfidenceTuning confidence;
};

}  // namespace counterpart::spectral_match
