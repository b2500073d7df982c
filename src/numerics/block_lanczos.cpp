// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "numerics/block_lanczos.hpp"

#include "base/random.hpp"
#include "numerics/shifted_factor.hpp"
#include "numerics/symmetric_eigen.hpp"
#include "numerics/tall_product.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

namespace counterpart::numerics {
namespace {

// Vectors of a block: more use memory better, fewer converge in a smaller space. 4, 8, 16 tried.
constexpr Eigen::Index first_block = 8;
// Size of the first space that is looked at. With 1.6, 200 functions of a body of 5000 vertices have
// converged to 1e-3 at once, with 1.9 to 1e-6.
constexpr double vectors_per_pair = 1.6;

// Mass-orthonormal vectors that span more and more of the block Krylov space, and the shifted inverse
// (stiffness - shift * mass)^-1 mass restricted to them.
class KrylovSpace {
  public:
    KrylovSpace(const ShiftedFactor& inverse, const SparseMatrix& mass, Eigen::Index block,
                Eigen::Index capacity)
        : inverse_(inverse), mass_(mass), block_(block), random_(1), basis_(mass.rows(), 0) {
        reserve(std::max(capacity, block));
        append(random_vectors(block), Vector::Zero(block));
    }

    Eigen::Index size() const { return size_; }

    // One block more.
    void extend() {
        reserve(size_ + 2 * block_);
        Eigen::MatrixXd next = inverse_.solve(mass_ * basis_.middleCols(size_, block_));
        size_ += block_;
        const Vector lengths = norms(next);
        // The last two blocks are all that there is without rounding; what is left is small and taken
        // exactly.
        const Eigen::Index recent = std::min(2 * block_, size_);
        auto column = restricted_.block(0, size_ - block_, size_, block_);
        column.setZero();
        column.bottomRows(recent) = without(size_ - recent, next);
        column += without(0, next);
        append(std::move(next), lengths);
    }

    struct RitzPairs {
        Vector values;            // of the shifted inverse
        Eigen::MatrixXd vectors;  // in terms of the basis
        Vector residuals;         // norms, relative to the values
    };
    RitzPairs ritz_pairs() const {
        const auto [values, vectors] = symmetric_eigen(
            Eigen::MatrixXd(restricted_.topLeftCorner(size_, size_).selfadjointView<Eigen::Upper>()));
        const Vector residuals = (coupling_ * vectors.bottomRows(block_)).colwise().norm();
        return {values, vectors, residuals.cwiseQuotient(values.cwiseAbs())};
    }

    Eigen::MatrixXd in_space(const Eigen::MatrixXd& coefficients) const {
        return times(basis_.leftCols(size_), coefficients.topRows(size_));
    }

  private:
    void reserve(Eigen::Index capacity) {
        if (capacity <= basis_.cols()) return;
        const Eigen::Index n = std::max(capacity, basis_.cols() * 5 / 4);
        basis_.conservativeResize(Eigen::NoChange, n);
        restricted_.conservativeResize(n, n);
    }

    // Takes the components along the basis from its vector `first` on away; returns them.
    Eigen::MatrixXd without(Eigen::Index first, Eigen::MatrixXd& vectors) const {
        const Eigen::Index count = size_ - first;
        Eigen::MatrixXd components = transposed_times(basis_.middleCols(first, count), mass_ * vectors);
        vectors -= times(basis_.middleCols(first, count), components);
        return components;
    }

    double norm(const Vector& vector) const { return std::sqrt(std::max(0.0, vector.dot(mass_ * vector))); }
    Vector norms(const Eigen::MatrixXd& vectors) const {
        return (mass_ * vectors).cwiseProduct(vectors).colwise().sum().cwiseMax(0).cwiseSqrt();
    }

    // The vectors, orthogonal to the basis, made orthonormal become the block after it; what remains of them
    // there is the coupling. One of which only rounding remains is replaced by a random one.
    void append(Eigen::MatrixXd vectors, const Vector& lengths) {
        constexpr double rounding = 1e-12;
        coupling_ = Eigen::MatrixXd::Zero(block_, block_);
        for (Eigen::Index j = 0; j < block_; ++j) {
            Vector vector = vectors.col(j);
            for (int pass = 0; pass < 2; ++pass) {  // twice is enough
                const Vector shares = basis_.middleCols(size_, j).transpose() * (mass_ * vector);
                vector -= basis_.middleCols(size_, j) * shares;
                coupling_.col(j).head(j) += shares;
            }
            coupling_(j, j) = norm(vector);
            if (!(coupling_(j, j) > rounding * lengths[j])) {
                coupling_(j, j) = 0;
                vector = fresh_vector(j);
            }
            basis_.col(size_ + j) = vector / norm(vector);
        }
    }

    Eigen::MatrixXd random_vectors(Eigen::Index count) {
        Eigen::MatrixXd vectors(basis_.rows(), count);
        for (Eigen::Index i = 0; i < vectors.size(); ++i) vectors.data()[i] = random_.uniform(-1, 1);
        return vectors;
    }

    // Orthogonal to the basis and to the block's first j vectors.
    Vector fresh_vector(Eigen::Index j) {
        Vector vector = random_vectors(1);
        const auto known = basis_.leftCols(size_ + j);
        for (int pass = 0; pass < 2; ++pass) vector -= known * (known.transpose() * (mass_ * vector)).eval();
        return vector;
    }

    const ShiftedFactor& inverse_;
    const SparseMatrix& mass_;
    Eigen::Index block_, size_ = 0;
    Random random_;
    Eigen::MatrixXd basis_;       // size_ columns, the block after them, and room
    Eigen::MatrixXd restricted_;  // upper triangle of the operator in the basis
    Eigen::MatrixXd coupling_;    // of the last block with the next
};

// Factorizes at a shift below which about half of the wanted eigenvalues lie; where there is no such shift,
// as with an eigenvalue that is repeated thousands of times, below that. Returns the shift;
// nothing if all factorizations break down.
std::optional<double> factorize_in_the_middle(ShiftedFactor& factor, double guess, int count) {
    const double least = std::floor(0.4 * count), most = std::max(1.0, std::ceil(0.55 * count));
    constexpr int max_trials = 20;
    constexpr double max_step = 8;
    const double least_shift = 1e-6 * guess;  // below, rounding decides how many eigenvalues 0 lie below
    double low = 0, high = std::numeric_limits<double>::infinity(), shift = guess;
    for (int trial = 0; trial < max_trials && shift > least_shift; ++trial) {
        if (!factor.factorize(shift)) {
            shift *= 1.001;  // on an eigenvalue, of a leading block or of the whole
            continue;
        }
        const int n = factor.n_below();
        if (n >= least && n <= most) return shift;
        (n < least ? low : high) = shift;
        const double linear = shift * std::clamp(0.5 * count / std::max(n, 1), 1 / max_step, max_step);
        shift = linear > low && linear < high ? linear : (low + high) / 2;
    }
    shift = low > least_shift ? low : -10 * least_shift;
    return factor.factorize(shift) ? std::optional(shift) : std::nullopt;
}

struct Found {
    Eigenpairs pairs;
    bool converged = false;
};

// The `count` smallest eigenvalues that the space knows.
Found smallest_in(const KrylovSpace& space, double shift, int count, double tolerance) {
    const KrylovSpace::RitzPairs ritz = space.ritz_pairs();
    const Vector values = shift + ritz.values.cwiseInverse().array();
    const double rounding = std::max(1e-6, tolerance) * std::abs(shift);
    std::vector<Eigen::Index> order;  // values below 0 belong to vectors that have not converged
    for (Eigen::Index i = 0; i < values.size(); ++i)
        if (values[i] > -rounding) order.push_back(i);
    std::sort(order.begin(), order.end(),
              [&](Eigen::Index a, Eigen::Index b) { return values[a] < values[b]; });
    if (std::ssize(order) < count) return {};
    order.resize(static_cast<std::size_t>(count));
    if (ritz.residuals(order).maxCoeff() > tolerance) return {};
    return {{values(order), space.in_space(ritz.vectors(Eigen::all, order))}, true};
}

// How many eigenvalues are missing below the middle of the last gap between those found.
int n_missing(const Vector& values, double shift, ShiftedFactor& factor) {
    const double gap = 1e-5 * std::abs(shift);  // what tells two values apart for certain
    for (Eigen::Index i = values.size(); --i > 0;)
        if (values[i] - values[i - 1] > gap && factor.factorize((values[i] + values[i - 1]) / 2))
            return factor.n_below() - static_cast<int>(i);
    return 0;
}

// From blocks of one size; nothing if they do not converge in a reasonable space.
std::optional<Eigenpairs> iterate(const ShiftedFactor& factor, double shift, const SparseMatrix& mass,
                                  int count, Eigen::Index block, double tolerance, const Progress& progress) {
    Eigen::Index wanted =
        std::max(static_cast<Eigen::Index>(vectors_per_pair * count) + 4 * first_block, 2 * block);
    // Beyond that, repeated eigenvalues are in the way.
    const Eigen::Index most =
        std::min<Eigen::Index>(3 * count + 16 * first_block + 4 * block, mass.rows() - 2 * block);
    if (wanted > most) return std::nullopt;
    KrylovSpace space(factor, mass, block, wanted + 2 * block);
    double done = 0;
    const auto report = [&] {  // the space's final size is unknown: each block is a share of the rest
        report_progress(progress, done);
        done += (1 - done) * static_cast<double>(block) / static_cast<double>(2 * wanted);
    };
    for (; wanted <= most; wanted += std::max(wanted / 10, block)) {
        while (space.size() < wanted) {
            report();
            space.extend();
            report();
        }
        if (Found found = smallest_in(space, shift, count, tolerance); found.converged)
            return std::move(found.pairs);
    }
    return std::nullopt;
}

}  // namespace

std::optional<Eigenpairs> block_lanczos(const SparseMatrix& stiffness, const SparseMatrix& mass, int count,
                                        double tolerance, const Progress& progress) {
    ShiftedFactor factor(stiffness, mass);
    // Weyl: a surface has about lambda * area / (4 pi) eigenvalues below lambda.
    const double guess = 2 * std::numbers::pi * count / mass.sum();
    // A block finds at most as many eigenvectors of a repeated eigenvalue as it has vectors: where some are
    // missing, a wider one goes over it again.
    Eigen::Index block = first_block;
    for (int trial = 0; trial < 2; ++trial) {
        const std::optional<double> shift = factorize_in_the_middle(factor, guess, count);
        if (!shift) return std::nullopt;
        std::optional<Eigenpairs> found = iterate(factor, *shift, mass, count, block, tolerance,
                                                  part_of(progress, trial * 0.5, trial * 0.5 + 0.5));
        const int missing = found ? n_missing(found->values, *shift, factor) : 0;
        if (found && missing == 0) return found;
        block = std::max(8 * first_block, static_cast<Eigen::Index>(std::min(missing, count)));
    }
    return std::nullopt;
}

}  // namespace counterpart::numerics
