// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/geodesic/distances.hpp>

#include <algorithm>
#include <limits>
#include <span>

namespace counterpart::geodesic {

/// use(i, distances from sources[i]) for each source, in order and on the calling thread, while only a few
/// rows are held at a time: sums over rows come out the same for any number of threads.
template <class Use>
void for_each_row(const DistanceGraph& graph, std::span<const Index> sources, const DistanceOptions& options,
                  const Use& use) {
    constexpr std::size_t block = 64;  // of rows: enough for eight threads
    const auto share = [&](std::size_t n) {
        return static_cast<double>(n) / static_cast<double>(sources.size());
    };
    for (std::size_t begin = 0; begin < sources.size(); begin += block) {
        const std::size_t end = std::min(begin + block, sources.size());
        const Matrix rows =
            distance_rows(graph, sources.subspan(begin, end - begin),
                          {options.n_threads, part_of(options.progress, share(begin), share(end))});
        for (Eigen::Index i = 0; i < rows.rows(); ++i) use(static_cast<Eigen::Index>(begin) + i, rows.row(i));
    }
}

/// Mean over rows of distances, leaving out the infinite ones; infinite where all are.
class RunningAverage {
  public:
    explicit RunningAverage(Index n) : sum_(Vector::Zero(n)), count_(Vector::Zero(n)) {}
    template <class Row>
    void add(const Row& row) {
        const auto reached = row.array() < std::numeric_limits<double>::infinity();
        sum_.array() += reached.select(row.array(), 0.0).transpose();
        count_.array() += reached.template cast<double>().transpose();
    }
    Vector result() const {
        return (count_.array() > 0)
            .select(sum_.array() / count_.array(), std::numeric_limits<double>::infinity());
    }

  private:
    Vector sum_, count_;
};

}  // namespace counterpart::geodesic
