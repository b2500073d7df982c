// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/align/thin_plate_spline.hpp>
#include <counterpart/base/progress.hpp>

namespace counterpart {

/// Temperatures are in squared units of the input; the weights have no unit (points are scaled to unit extent
/// internally).
struct TpsRpmOptions {
    double initial_temperature = 0;      ///< 0 = the largest squared distance between the two sets
    double final_temperature = 0;        ///< 0 = 0.1 x the mean squared nearest-neighbor distance
    double annealing_rate = 0.93;        ///< temperature factor per step, in (0, 1)
    int iterations_per_temperature = 5;  ///< alternations of assignment and spline, at least 1
    int sinkhorn_iterations = 10;        ///< rounds of normalization per assignment, at least 1
    double bending_weight = 1;           ///< lambda_1 = bending_weight * N * temperature; > 0
    double affine_weight = 0.01;         ///< lambda_2 = affine_weight * N * temperature; >= 0
    /// Stop a temperature when no point moves by more than this part of sqrt(temperature), and the annealing
    /// when the assignment is hard and no longer changes (the spline is then fitted at the final
    /// temperature). 0 = never stop early.
    double tolerance = 0.01;
    Progress progress{};
};

struct TpsRpmResult {
    ThinPlateSpline transform;     ///< target from source
    Matrix transformed;            ///< N x D, the source points under `transform`
    Matrix soft_assignment;        ///< N x M, rows and columns sum to at most 1; the rest is outlier
    double final_temperature = 0;  ///< at which annealing ended
    int iterations = 0;            ///< alternations done
    bool converged = false;        ///< the assignment became hard, or no point moved at the end
};

/// Robust point matching with a thin-plate spline: H. Chui and A. Rangarajan, "A new point matching algorithm
/// for non-rigid registration", CVIU 2003. Softassign with an outlier row and column and deterministic
/// annealing, alternating with spline fits; lambda_1 and lambda_2 follow the temperature. `source`: N x D,
/// `target`: M x D, D = 2 or 3, N and M at least 1 and not necessarily equal. Throws InvalidInput for other
/// sizes, values that are not finite and options out of range. O(N^3) once, then O(N M + N^2) per
/// alternation.
TpsRpmResult tps_rpm(const Matrix& source, const Matrix& target, const TpsRpmOptions& options = {});

}  // namespace counterpart
