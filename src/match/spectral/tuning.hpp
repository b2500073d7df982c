// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Every constant of the method, stage by stage in the order in which the stages run. Lengths are geodesic, at
// unit surface area; times are of heat diffusion, squared lengths. docs/spectral.md says what each stage and
// the more important constants are worth (benchmarks/ablation measures it).
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
    /// Vertices. With 8000, meshes of 16 000 to 250 000 vertices take 10 % longer and maps are as accurate
    /// (mean errors with 6000 and 8000: 1.60 and 1.64, 1.43 and 1.54, 0.85 and 0.86; of 10 000 vertices 0.76
    /// and 0.66).
    Index proxy_size = 6000;
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
    /// end go. By the nearest sample alone, with slack 0.1, of weights 0.5, 1, 3 and 10 the two large ones
    /// made maps of unlike shapes worse, where the right map stretches the landmark's limb; with slack 0.2, 1
    /// and 2 do the same.
    double weight = 2;
    /// Which coarse maps cannot help. One landmark takes nine wrong pairs of unlike shapes from 7.9 to 8.0
    /// with 0.1 (two of them are worse by 3 and 4), to 7.1 with 0.2 (nearest sample). A right map takes the
    /// surroundings about 0.1 away.
    double slack = 0.2;
    /// Of the samples around a landmark, of whose images' distances the median counts. By the nearest sample
    /// alone, which a pin holds while all around it stays elsewhere, 17 wrong pairs have 7.0 with one
    /// landmark, with this 6.6.
    double radius = 0.15;
    double excluded_weight = 10;    ///< of what is missing to the radius below
    double excluded_radius = 0.15;  ///< images this near to an excluded vertex are on the wrong limb
    /// Of what is missing to the correlation below, of the coordinates along a common direction.
    double direction_weight = 1.5;
    /// From here on a correlation says no more: bodies lean and rear. Of six pairs with a hippo, "up" alone
    /// leaves four as they are and mends one with 0.2; with 0.5 it turns three head to tail, with 1 five.
    double enough_correlation = 0.2;
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

/// What counts how much in a score. Round numbers, fitted by pairwise ranking of right against wrong maps:
/// orthogonality is most informative for small bases, drift for large ones.
struct ScoreWeights {
    int curvature_scale;  ///< index into PreparationTuning::curvature_times
    double orientation, orthogonality, drift, rigidity;
    double curvature = 1;
};

/// Stage 2, candidates.
struct CandidateTuning {
    ExtremityTuning extremities;
    ExtrinsicTuning extrinsic;
    std::size_t n_samples = 300;      ///< points on which candidates are grown
    double rigidity_radius = 0.3;     ///< of neighborhoods that should move rigidly
    int first_size = 20;              ///< eigenfunctions of the map fitted to descriptors and extremities
    double wave_kernel_weight = 0.2;  ///< of each column, against 1 for a heat kernel at an extremity
    double curvature_weight = 0.3;    ///< likewise
    std::vector<double> heat_times{0.005, 0.02, 0.06};
    /// Of the operators at extremities that tell a map from its mirror image; 0.01 to 1 do about the same.
    double orientation_weight = 0.1;
    double orientation_heat_time = 0.06;
    std::size_t n_reoriented = 8;       ///< candidates whose tips give another start; 0 = none
    int last_size = 30, size_step = 5;  ///< eigenfunctions that candidates are grown to by ZoomOut
    ScoreWeights score{2, 0.15, 2.5, 0, 0.7};
    int n_flip_rounds = 2;               ///< rounds in which low columns of the best are negated; 0 = never
    std::size_t n_flipped = 24;          ///< candidates varied per round
    int first_flip = 5, last_flip = 17;  ///< columns, one at a time
    double min_new_difference = 0.03;    ///< flips that begin closer than this to an earlier one are dropped
    Distinctness distinct{.mean = 0.05};
    std::size_t n_pool = 60, n_kept = 24;  ///< candidates between the rounds, and at the end
};

/// Stage 3, selection.
struct SelectionTuning {
    // 3a: all on more functions and samples.
    std::size_t n_samples = 600;
    double rigidity_radius = 0.2;
    std::vector<int> sizes{40, 50, 60, 80};
    ScoreWeights score{1, 0.25, 0, 10, 2};
    std::size_t n_kept = 14;  ///< of all
    Distinctness distinct{.mean = 0.08, .moved_share = 0.05};
    /// Of the best map. Below, shapes are alike, and maps are grown on; above, growth pulls unlike bodies to
    /// where isometry would put them, and candidates are refined as they are. (Of 40 pairs of animals and 14
    /// of people the 17 up to 0.0072 have all limbs right; 0.0122 is the next.)
    double near_isometry_drift = 0.01;
    double max_behind = 0.3;  ///< the best; those farther behind are not grown on,
    std::size_t n_least = 4;  ///< except so many, to be reported as runners-up
    // 3b: the finalists on all samples.
    double final_rigidity_radius = 0.15;
    std::vector<int> final_sizes{95, 110, 130, 150};
    int final_scored_size = 100;  ///< functions that scores are taken on
    bool final_masked = true;     ///< damp entries between far frequencies (Hu et al. 2021)
    ScoreWeights final_score{0, 0.25, 0, 10, 2};
    /// A map of less drift that is so far ahead of the next one is right, and the candidates are not varied,
    /// which takes a quarter of the whole time. Of 306 pairs of people and animals 113 have such a map at
    /// drifts below 0.008, all right; up to 0.01, 32 more, of which one centaur's is wrong. Leads of right
    /// maps are from 0.04 on, of wrong ones up to 0.007 (drifts up to 0.009).
    double decided_drift = 0.007, decided_lead = 0.05;
    std::size_t n_looked_at = 14;  ///< the best candidates, among which it is sought
    std::size_t n_finalists = 8;
    Distinctness distinct_finalists{.mean = 0.05, .moved_share = 0.05};
};

/// Patches that a map takes elsewhere than all that is around them.
struct IslandTuning {
    /// An edge is torn if its ends go so much farther apart than the edges around it suggest: by the
    /// median of their factors. 14 pairs of animals (13 with a hippo, and one that a fixed factor of 3
    /// spoils) have 7.2 with their lengths alone, 6.7 with the median, 7.3 with the 75 % quantile.
    double gap = 0.04;
    /// Or so much farther apart along the surface: what jumps from one leg to the other beside it is near
    /// through space. Of 43 pairs with a hippo it changes three (12.9 to 5.0, 9.6 to 7.9, 9.6 to 15.1). With
    /// 0.04, 22 of them have 4.7 (5.0 with 0.2), but the others get worse, 20 of them 4.9 to 5.1.
    double jump = 0.2;
    double most_growth = 4;  ///< what is expected of an edge, as a factor, at most; no other was tried
    double max_share = 0.1;  ///< of the area; with 0.25 the maps of 60 pairs of animals are the same
    /// Of the refinement from which on they are put back, each time. On the 32 pairs of animals that this
    /// changes (when an edge was torn by its length alone) the mean error is 5.72 without, 4.57 in round 4
    /// only, 4.07 from it on; from round 2 on (4.30) two right maps are spoiled. The final choice has fewer
    /// rounds: there a wrong map won by it (one of 24 pairs).
    int first_round = 4;
};

/// Stage 5, refinement on all vertices. Weights are relative to the spectral coordinates. The rounds go from
/// few functions and stiff surfaces to many functions and pliable ones.
struct RefinementTuning {
    int first_match_size = 80;             ///< eigenfunctions of the maps that the first round starts from
    int first_size = 30, last_size = 200;  ///< eigenfunctions of the first and last round
    bool masked = true;
    float feature_weight = 5;     ///< of curvature and wave kernel, each of variance 1
    int n_wave_kernel = 8;        ///< of the 40 columns, evenly spaced
    float position_weight = 200;  ///< of positions after an elastic fit of either surface to its images
    float normal_weight = 14;     ///< of the normals there
    double first_length = 0.3, last_length = 0.06;  ///< the fits keep shapes below this size
    double min_scale = 0.3, max_scale = 3;  ///< of a neighborhood in the fits, so that nothing vanishes
    int n_iterations = 16;                  ///< of an elastic fit, at most
    /// Root mean square step at which a fit ends. Eight iterations throughout do the same for people, and
    /// make maps of animals 5 % worse, which move on for all of the 16.
    double settled = 1e-4;
    double pin_mass = 0.005;  ///< share of the area that a pinned vertex pulls like, in the fits
    /// Of nearness to a landmark, 1 there and 1/e at the reach. One landmark takes the 21 wrong pairs of
    /// unlike shapes from 8.9 to 7.6 without, to 6.9 with 40, 6.7 with 100 (fewer of them right), 8.0 with
    /// 100 and reach 1; fading from round to round changes nothing. 23 right pairs stay as they are (1.97,
    /// 1.96), and so do 12 pairs with 40 landmarks each (2.30, 2.25); with five they have 3.15 without and
    /// 3.59, one of a hippo 5.4 and 9.7.
    float landmark_weight = 40;
    float landmark_reach = 0.3F;
    /// Of a vertex's share of nearness to a guide, by the inverse square of the distance from it plus the
    /// offset. Of RematchingTuning's 14 pairs, 6 are above 6 after it, with 60 instead of 100 it is 9. On 22
    /// pairs with 30, 100, 200 and 400 and no other matching tried: 4.94, 4.79, 4.86, 5.05 (5.25 without).
    float guide_weight = 100;
    float guide_offset = 0.01F;  ///< no other was tried
    /// Of the height along a common direction, from 0 to 1, where priors guide a map.
    /// RematchingTuning's 14 pairs with "up" given, on coarse copies: 7.0 and 6.5 with 60 and 120 in all
    /// guided refinements, 6.6 with 0, so that the gain is in trying both: each matching with 0 and with
    /// 120, 6.1. No other was tried. 120 in the refinements of all rivals as well: 17, two are turned head to
    /// tail.
    float height_weight = 120;
    double least_height = 0.01;  ///< of a shape: flatter ones have no up there, but rounding
    /// Where both maps pull in the fits: what the other one takes to a vertex, by so many times its area.
    /// From the first refinement on, the 14 pairs (IslandTuning) have 6.7, 6.6, 6.5 and 7.4 with 0, 1, 3
    /// and 10, but a right map of two others loses (RivalTuning::n_pull_rounds).
    double back_pull = 3;
    int first_rings = 2, rings = 1;  ///< of samples' cells around an image, in which partners are sought
    IslandTuning islands{};          ///< put back in the later rounds
    int n_rounds = 8;                ///< 0 = spectral coordinates and features alone, or the brief refinement
    /// A map that has been refined before goes on from there by the last rounds only: it has come as far.
    /// Errors of people change by 0.01 with 3, 4 or 5 rounds, by 0.02 with 2; one body in two poses: 0.44,
    /// 0.42, 0.39 with 3, 4, 5 rounds, 0.36 with all. Of unlike shapes, which have been refined on coarse
    /// copies: 24 pairs of animals 3.26, 3.24 and 3.25 with 3, 5 and all. Each takes 0.02 s for 5000
    /// vertices.
    bool goes_on = true;
    int n_continued_rounds = 5;
    Index huge_mesh = 60000;  ///< above this many vertices there are fewer rounds
    int n_rounds_if_huge = 2;
};

/// What tells refined maps apart, and how much it counts beside the score of the selection.
struct CueTuning {
    double radius = 0.15;                     ///< of the neighborhoods that are fitted by similarities
    double wring_from = 0.1, wring_to = 0.3;  ///< between neighborhoods whose rotations are compared
    double wring_quantile = 0.9;
    double relief_weight = 6, residual_weight = 2, wring_weight = 0.06;
    /// Of Scores::drift, once more: alone it tells exchanged legs from right ones. 0 to 60 tried: 8
    /// to 30 choose right on 213 of 217 pairs of animals and people in unlike poses, 0 on 210; from 20 on a
    /// cat is wrong that was right.
    double drift_weight = 15;
};

/// Stage 4 of near isometries, the final choice among briefly refined finalists.
struct FinalChoiceTuning {
    std::size_t n_tried = 8;    ///< at most
    double close_score = 0.15;  ///< those farther behind in the selection are matched but not refined
    CueTuning cues;
    RefinementTuning refinement{
        .last_size = 80, .last_length = 0.1, .n_iterations = 8, .n_rounds = 3, .n_rounds_if_huge = 1};
};

/// Equation 7, of refined maps. On 62 pairs of unlike shapes (16 with a hippo, 34 of other animals, 12
/// gorillas) the chosen maps have mean errors of 6.1, 2.5 and 10.0; with normal weights 0 and
/// 1: 7.1, 2.5, 12.8 and 6.1, 2.5, 10.0; with half of the score of the selection as well: 7.4, 2.8, 10.0.
/// Twice the damage: 6.4, 2.5, 10.0.
struct RefinedScoreTuning {
    double normal_weight = 0.5;
    double normal_radius = 0.3;  ///< of the neighborhoods that are turned
    double damage_weight = 5;
    double most_damage = 0.2;  ///< of a vertex: what has gone astray counts no more
};

/// Which of the refined maps is taken, and how often each is refined.
struct RivalTuning {
    RefinedScoreTuning score{};
    /// Those at most so far behind the best are refined in full. Of near isometries 0.03, 0.06, 0.1 and 0.3
    /// (then all finalists) are within 0.003 of each other, and the least takes the least time.
    double close_score = 0.03;
    std::size_t n_refined = 4;  ///< at most; at least 1
    /// How many of the best are then refined again from their own result, round by round, unless that gained
    /// nothing before.
    std::vector<std::size_t> n_repeated{};
    /// How often the winner is finally refined once more with both maps pulling, while that gains. If they
    /// pull in all refinements, a hippo is turned half round; if in all but the first, a gorilla. 15 pairs of
    /// animals (14 with a hippo) have 7.3 without, 5.9 so, 6.1 if they pull in all repeats, 6.7 if each
    /// repeat tries both ways.
    std::size_t n_pull_rounds = 0;
    /// A rival that refinement has made the same map is none. As of finalists.
    Distinctness distinct{.mean = 0.05, .moved_share = 0.05};
};

/// Other matchings of extremities tried on the winner. Of 14 pairs with a hippo above 6 (mean 8.6) it leaves
/// 6 above 6 (6.4).
struct RematchingTuning {
    double most_apart =
        0.6;               ///< there and back, of extremities that may correspond; with 0.5 and 0.06, 8 of 14
    double settled = 0.1;  ///< closer ones keep their partners
    /// Nothing goes so near to a bare extremity. Of 15 pairs with a hippo one is mended (12.6 to 6.9), the
    /// others stay as they are, in the same time. If all without a partner within `most_apart` are tried with
    /// each other instead, 84 searches of pairs with a hippo have 4.72 instead of 4.80, for a third to a half
    /// more time. No other radius was tried.
    double bare = 0.15;
    int far_rings = 8;  ///< RefinementTuning::first_rings where they guide; no other was tried with them
    /// By equation 7: what scores so much is left as it is. On 66 pairs of animals without a hippo rematching
    /// takes errors from 2.42 to 2.32 in 5.7 s of a processor for each pair; applied only to maps below 1.15,
    /// 1.2 and 1.25, to 2.36, 2.33 and 2.32 in 2.0, 3.9 and 4.4 s.
    double good_score = 1.2;
    int n_rounds = 2;  ///< at most, while each gains: 6.6, 6.4 and 6.4 with 1, 2 and 3; 0 = none
};

/// Stage 4 of unlike shapes.
struct UnlikeTuning {
    /// With more pinned landmarks the pair is not searched without them as well, which takes as long again:
    /// together they say where everything is. One was tried.
    std::size_t max_unguided_pins = 8;
    /// Vertices of the coarse copies. With 6 rivals and repeats {2, 1}, 700, 1000, 1500 and all 5000
    /// give 5.5, 4.3, 4.1, 4.5 (12 pairs with a hippo), 2.3, 2.2, 2.2, 2.3 (12 of other animals), in 6.8,
    /// 8, 10.5 and 26 s of a processor. With the rivals below, 12 gorillas have 5.3 with 1000 and 2000; but
    /// of 19 pairs of one person bent far over 1000 and 1500 turn one half round and are sure of it, 2000
    /// none.
    Index n_coarse = 2000;
    /// Candidates that score so much less than the best are not tried: of 62 pairs the one taken is at most
    /// 0.17 behind.
    double close_candidate = 0.2;
    /// By equation 7. On copies of 1000 vertices, with 6 rivals and repeats {2, 1} the 12 pairs of gorillas
    /// have 9.5 (a half-turn), with repeats {4, 2, 1, 1} 9.4; with 12 or 24 rivals and {4, 2, 1} 5.27; with
    /// 24 and {12, 6, 2, 1} 5.25. In 191 searches (66 pairs of animals without a hippo, 42 with one, two
    /// seeds, some both ways) the rival that won was at most 0.153 behind before it was refined in full; the
    /// 12 gorillas have the same maps with 0.3 and 0.16.
    RivalTuning rivals{.close_score = 0.16, .n_refined = 12, .n_repeated = {4, 2, 1}, .n_pull_rounds = 2};
    RematchingTuning rematching{};
    /// By equation 7, on coarse copies. Where the best map has less, the pair is searched from B to A as
    /// well: 25 of 42 pairs with a hippo, 2 of 133 pairs of other animals. With 0, 1 and 1.05 the 42
    /// have 4.9, 4.7 and 4.6, 12, 10 and 9 of them above 6 (PreparationOptions::seed 1, which nothing else
    /// was chosen by).
    double doubtful_score = 1.05;
    /// Where the winner is rematched and from then on, what counts more in refinement. The true maps of 22
    /// pairs, refined twice with both maps pulling, go off by 3.5 with 200 and 14, by 3.2 with 400 and 30, by
    /// 3.4 with 800 and 60. Used for all rivals, 22 pairs have 5.9 (5.2).
    float position_weight = 400, normal_weight = 30;
};

/// Stage 6, confidence and warnings. None of these changes the map, save `min_mirror_gain`.
struct ConfidenceTuning {
    // Least calibration error (0.02) on all 420 pairs (people, animals, gorillas; benchmarks/candidates,
    // scripts/fit_choice.py) among the settings that call no pair above 6 more than 0.76 sure. Without
    // hippos, gorillas, cats and centaurs 0.7 and 0.18 fit best, which call a wrong map of those 0.85 sure.
    /// By equation 7, at which a map is trusted by half, 0.7 to 1.1 tried: maps of people have 1.19 to 1.44,
    /// right ones of animals 0.88 to 1.42, wrong ones 0.77 to 1.08.
    double half_score = 0.9;
    double score_width = 0.12;   ///< of the logistic curve around it, 0.06 to 0.18 tried
    double temperature = 0.01;   ///< a runner-up so far behind counts 1 / e, 0.01 to 0.03 tried
    double same_place = 0.15;    ///< images closer than this agree
    double doubt_length = 0.12;  ///< of a round trip plus tear, at which confidence falls to 1 / e
    /// Patches that refinement has not put back, and what is left of the confidence there. On 40 pairs of
    /// animals 62 % of their vertices are off by more than 5, 96 % of those above 0.5 without this.
    IslandTuning islands{};
    double island_trust = 0.2;
    double poor_score = 0.35;       ///< below it a warning
    double close_margin = 0.03;     ///< between the two best scores, below it a warning
    double min_mirror_gain = 0.03;  ///< the mirror image of an inside-out mesh must score better by this
    double moved = 0.2;             ///< a sample whose images are farther apart than this has moved
    double limb_share = 0.02,
           turn_share = 0.6;      ///< of samples moved: below, a shift; above, another limb, a turn
    Index many_components = 100;  ///< from here on the mesh is called disconnected fragments
    double sphere_ratio = 1.03;   ///< of the third to the first eigenvalue, below it a shape is sphere-like
};

struct SpectralTuning {
    PreparationTuning preparation;
    PriorTuning priors;
    CandidateTuning candidates;
    SelectionTuning selection;
    FinalChoiceTuning final_choice;
    RefinementTuning refinement;
    RivalTuning rivals;
    UnlikeTuning unlike;
    ConfidenceTuning confidence;
};

}  // namespace counterpart::spectral_match
