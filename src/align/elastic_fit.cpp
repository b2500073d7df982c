// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "align/elastic_fit.hpp"

#include "numerics/sparse_cholesky.hpp"

#include <counterpart/base/errors.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace counterpart::align {
namespace {

// The matrix with each vertex in its pattern, and where these entries are.
struct WithDiagonal {
    SparseMatrix matrix;
    std::vector<Eigen::Index> diagonal;

    explicit WithDiagonal(const SparseMatrix& stiffness) : matrix(stiffness) {
        for (Eigen::Index v = 0; v < matrix.cols(); ++v) matrix.coeffRef(v, v) += 0;
        matrix.makeCompressed();
        for (Eigen::Index v = 0; v < matrix.cols(); ++v) {
            const int* begin = matrix.innerIndexPtr() + matrix.outerIndexPtr()[v];
            const int* end = matrix.innerIndexPtr() + matrix.outerIndexPtr()[v + 1];
            diagonal.push_back(std::lower_bound(begin, end, static_cast<int>(v)) - matrix.innerIndexPtr());
        }
    }

    SparseMatrix plus(const Vector& on_diagonal) const {
        SparseMatrix sum = matrix;
        for (std::size_t v = 0; v < diagonal.size(); ++v)
            sum.valuePtr()[diagonal[v]] += on_diagonal[static_cast<Eigen::Index>(v)];
        return sum;
    }
};

// Rounding makes a pivot that should be 0 a tiny one, against what it is left of.
bool is_held(const numerics::SparseCholesky& factor, const SparseMatrix& matrix) {
    constexpr double least = 1e-13;
    for (Eigen::Index v = 0; v < matrix.cols(); ++v)
        if (!(factor.diagonal()[factor.order()[v]] > least * matrix.coeff(v, v))) return false;
    return true;
}

}  // namespace

struct ElasticFit::System {
    // Of the stiffness plus a pull.
    struct Factored {
        Vector pull;
        numerics::SparseCholesky factor;
    };

    Springs springs;
    WithDiagonal stiffness;
    ElasticFitOptions options;
    std::vector<Factored> factored = {};  // last used first
    LocalSimilarities similarities = {};  // of the last positions: those of the next are near

    const numerics::SparseCholesky& factor_for(const Vector& pull) {
        auto known = std::find_if(factored.begin(), factored.end(), [&](const Factored& other) {
            return other.pull.size() == pull.size() && other.pull == pull;  // none after a failure
        });
        if (known == factored.end()) {
            const auto most = static_cast<std::size_t>(std::max(options.n_kept_factors, 1));
            if (factored.size() < most) factored.push_back({{}, numerics::SparseCholesky(stiffness.matrix)});
            known = factored.end() - 1;
            known->pull.resize(0);
            const SparseMatrix matrix = stiffness.plus(pull);
            if (!known->factor.factorize(matrix) || !is_held(known->factor, matrix))
                throw NumericalError("the elastic system cannot be factorized: nothing holds the surface");
            known->pull = pull;
        }
        std::rotate(factored.begin(), known, known + 1);
        return factored.front().factor;
    }
};

ElasticFit::ElasticFit(PointsView rest, const SparseMatrix& stiffness, const ElasticFitOptions& options)
    : system_(std::make_unique<System>(System{Springs(stiffness, rest), WithDiagonal(stiffness), options})) {}

ElasticFit::~ElasticFit() = default;
ElasticFit::ElasticFit(ElasticFit&&) noexcept = default;

Points ElasticFit::operator()(PointsView towards, const Vector& pull, PointsView start, int n_iterations,
                              const ProgressRange& progress, const std::vector<char>& spoiled) {
    System& s = *system_;
    const numerics::SparseCholesky& factor = s.factor_for(pull);
    Points pulled(towards.rows(), 3);
    for (Eigen::Index v = 0; v < towards.rows(); ++v)
        for (int c = 0; c < 3; ++c) pulled(v, c) = pull[v] > 0 ? pull[v] * towards(v, c) : 0;
    Points now = start;
    for (int i = 0; i < n_iterations; ++i) {
        progress.check();
        s.similarities = local_similarities(s.springs, now, s.options.scales, std::move(s.similarities));
        if (!spoiled.empty())
            s.similarities = continued_inward(s.springs, spoiled, std::move(s.similarities));
        Points next = factor.solve(Points(pulled + moved_differences(s.springs, s.similarities)));
        now.swap(next);
        if (s.options.settled > 0 &&
            std::sqrt((now - next).squaredNorm() / static_cast<double>(now.rows())) < s.options.settled)
            break;
    }
    return now;
}

void ElasticFit::forget_rotations() { system_->similarities.clear(); }

double ElasticFit::strain(PointsView now) const {
    return align::strain(system_->springs, now,
                         local_similarities(system_->springs, now, system_->options.scales));
}

}  // namespace counterpart::align
