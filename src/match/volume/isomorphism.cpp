// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/volume/isomorphism.hpp"

#include "base/parallel.hpp"
#include "match/isomorphism/counting.hpp"
#include "match/isomorphism/first_difference.hpp"
#include "match/symmetry/component_assignment.hpp"
#include "match/volume/solid_map.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <optional>
#include <unordered_map>

#include <fmt/format.h>

namespace counterpart::volume {
namespace {

// Of the isomorphisms of one component compared by geometry: a cube has 24, and what has more is round, so
// that one of the first is as good.
constexpr std::size_t max_compared = 96;
// Tetrahedra visited by walks that failed, in sizes of the mesh: beyond, colors are refined further.
constexpr std::size_t max_wasted = 20;

// The image of each source vertex so far, and back.
struct Pairing {
    Pairing(Index n_source, Index n_target) : image(to_size(n_source), -1), origin(to_size(n_target), -1) {}
    bool pair(Index v, Index w) {
        if (image[to_size(v)] < 0 && origin[to_size(w)] < 0) {
            image[to_size(v)] = w;
            origin[to_size(w)] = v;
            added.push_back(v);
        }
        return image[to_size(v)] == w && origin[to_size(w)] == v;
    }
    void take_back(std::size_t n_kept) {
        for (; added.size() > n_kept; added.pop_back()) {
            origin[to_size(image[to_size(added.back())])] = -1;
            image[to_size(added.back())] = -1;
        }
    }
    std::vector<Index> image, origin, added;
};

using Permutation = std::array<int, 4>;  // target corner of each source corner
bool is_odd(const Permutation& p) {
    int inversions = 0;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < i; ++j) inversions += p[j] > p[i] ? 1 : 0;
    return inversions % 2 == 1;
}

// Walks through a component of both solids in step.
class Walk {
  public:
    Walk(const SolidMap& a, const SolidMap& b, Pairing& pairing)
        : a_(a), b_(b), pairing_(pairing), image_(to_size(a.mesh.n_tetrahedra()), -1) {}

    // Pairs all vertices of the component of `root`, or none.
    bool run(Index root, Index root_image, const Permutation& corners, Index size) {
        const std::size_t before = pairing_.added.size();
        bool agree = true;
        for (int c = 0; c < 4 && agree; ++c)
            agree = pairing_.pair(a_.corner(root, c), b_.corner(root_image, corners[to_size(c)]));
        queue_.clear();
        if (agree) visit(root, root_image);
        for (std::size_t k = 0; k < queue_.size() && agree; ++k) agree = step(queue_[k]);
        agree = agree && static_cast<Index>(queue_.size()) == size;
        steps_ += queue_.size();
        for (const Index t : queue_) image_[to_size(t)] = -1;
        if (!agree) pairing_.take_back(before);
        return agree;
    }
    std::size_t steps() const { return steps_; }

  private:
    void visit(Index t, Index image) {
        image_[to_size(t)] = image;
        queue_.push_back(t);
    }

    bool step(Index t) {
        const Index u = image_[to_size(t)];
        for (int c = 0; c < 4; ++c) {
            const Index over = a_.across[4 * to_size(t) + to_size(c)];
            const Index w = pairing_.image[to_size(a_.corner(t, c))];
            int d = 0;
            while (d < 4 && b_.corner(u, d) != w) ++d;
            if (d == 4) return false;
            const Index image_over = b_.across[4 * to_size(u) + to_size(d)];
            if ((over < 0) != (image_over < 0)) return false;
            if (over < 0) continue;
            const Index known = image_[to_size(over / 4)];
            if (known >= 0 ? known != image_over / 4
                           : !pairing_.pair(a_.corner(over / 4, over % 4),
                                            b_.corner(image_over / 4, image_over % 4)))
                return false;
            if (known < 0) visit(over / 4, image_over / 4);
        }
        return true;
    }

    const SolidMap& a_;
    const SolidMap& b_;
    Pairing& pairing_;
    std::vector<Index> image_, queue_;
    std::size_t steps_ = 0;
};

struct Fit {
    double edges = 0, rigid = 0, offset = 0;
    // Edge lengths decide; where they tie, the distance after the best similarity; then as the solids lie.
    bool is_better_than(const Fit& other, double tolerance) const {
        const auto ties = [&](double a, double b) {
            return std::abs(a - b) <= 0.01 * std::min(a, b) + tolerance;
        };
        if (!ties(edges, other.edges)) return edges < other.edges;
        if (!ties(rigid, other.rigid)) return rigid < other.rigid;
        return offset < other.offset;
    }
};

class Matcher {
  public:
    Matcher(const SolidMap& a, const SolidMap& b, bool reversed, std::size_t budget)
        : a_(a),
          b_(b),
          reversed_(reversed),
          budget_(budget),
          pairing_(a.mesh.n_vertices(), b.mesh.n_vertices()),
          walk_(a, b, pairing_) {
        const Eigen::RowVector3d size =
            b.mesh.vertices.colwise().maxCoeff() - b.mesh.vertices.colwise().minCoeff();
        constexpr double rounding = 1e-9;
        tolerance_ = rounding * size.norm() * rounding * size.norm();
    }

    // False if too many walks failed for these colors; `found` says whether the solids are equal.
    bool run() {
        const std::vector<Color> ours = signatures(a_), theirs = signatures(b_);
        std::vector<Index> order(ours.size());
        std::iota(order.begin(), order.end(), 0);
        std::stable_sort(order.begin(), order.end(),
                         [&](Index i, Index j) { return a_.component_size(i) > a_.component_size(j); });
        std::unordered_map<Color, std::vector<Index>> free;
        for (Index j = 0; j < b_.n_components(); ++j) free[theirs[to_size(j)]].push_back(j);
        for (const Index i : order) {
            std::vector<Index>& like = free[ours[to_size(i)]];
            if (like.size() > 1) ++n_placed_;
            const std::optional<Index> taken = match_component(i, like);
            if (exhausted_) return false;
            if (!taken) {
                failed_ = i;
                return true;
            }
            like.erase(std::find(like.begin(), like.end(), *taken));
        }
        found_ = true;
        return true;
    }

    bool found() const { return found_; }
    Index failed_component() const { return failed_; }
    Index n_placed() const { return n_placed_; }
    Count automorphisms() const {
        Count count = isomorphism::count_from_log10(log10_);
        count.is_lower_bound = is_bound_;
        return count;
    }
    std::vector<Index> take_image() { return std::move(pairing_.image); }

  private:
    static std::vector<Color> signatures(const SolidMap& map) {
        std::vector<Color> all;
        for (Index i = 0; i < map.n_components(); ++i) {
            Color sum = static_cast<Color>(map.component_size(i));
            for (Index k = map.component_begin[to_size(i)]; k < map.component_begin[to_size(i) + 1]; ++k)
                sum += map.color_of(map.order[to_size(k)]);
            all.push_back(sum);
        }
        return all;
    }

    // A tetrahedron whose color occurs least.
    Index rarest(Index component) const {
        std::unordered_map<Color, Index> counts;
        const Index begin = a_.component_begin[to_size(component)],
                    end = a_.component_begin[to_size(component) + 1];
        for (Index k = begin; k < end; ++k) ++counts[a_.color_of(a_.order[to_size(k)])];
        Index best = a_.order[to_size(begin)], least = counts[a_.color_of(best)];
        for (Index k = begin; k < end; ++k) {
            const Index count = counts[a_.color_of(a_.order[to_size(k)])];
            if (count < least) best = a_.order[to_size(k)], least = count;
        }
        return best;
    }

    // The component of the target that it is paired with, all its vertices with it.
    std::optional<Index> match_component(Index component, const std::vector<Index>& like) {
        const Index root = rarest(component), size = a_.component_size(component);
        const Color color = a_.color_of(root);
        struct Found {
            Index component, root;
            Permutation corners;
            Fit fit;
        };
        std::optional<Found> best;
        std::size_t n_first = 0;  // isomorphisms onto the first component that has any
        for (const Index j : like) {
            std::size_t n_here = 0;
            for (Index k = b_.component_begin[to_size(j)]; k < b_.component_begin[to_size(j) + 1]; ++k) {
                const Index u = b_.order[to_size(k)];
                if (b_.color_of(u) != color) continue;
                Permutation corners{0, 1, 2, 3};
                do {
                    if (is_odd(corners) != reversed_ || !colors_agree(root, u, corners)) continue;
                    const std::size_t before = pairing_.added.size(), steps = walk_.steps();
                    if (!walk_.run(root, u, corners, size)) {
                        wasted_ += walk_.steps() - steps;
                        if (wasted_ > budget_) exhausted_ = true;
                        if (exhausted_) return std::nullopt;
                        continue;
                    }
                    ++n_here;
                    const Fit fit = fit_since(before);
                    if (!best || fit.is_better_than(best->fit, tolerance_)) best = {j, u, corners, fit};
                    pairing_.take_back(before);
                } while (std::next_permutation(corners.begin(), corners.end()) && n_here < max_compared);
                if (n_here >= max_compared) is_bound_ = true;
                if (n_here >= max_compared) break;
            }
            if (n_first == 0) n_first = n_here;
        }
        if (!best) return std::nullopt;
        log10_ += std::log10(static_cast<double>(n_first) *
                             static_cast<double>(std::max<std::size_t>(1, like.size())));
        walk_.run(root, best->root, best->corners, size);
        return best->component;
    }

    bool colors_agree(Index t, Index u, const Permutation& corners) const {
        for (int c = 0; c < 4; ++c)
            if (a_.colors[to_size(a_.corner(t, c))] != b_.colors[to_size(b_.corner(u, corners[to_size(c)]))])
                return false;
        return true;
    }

    // Of the vertices paired since, or of all of a component that shares its vertices with others.
    Fit fit_since(std::size_t before) const {
        const std::size_t n = pairing_.added.size() - before;
        if (n < 3) return {};
        std::vector<symmetry::PointPair> pairs;
        Fit fit;
        for (std::size_t k = before; k < pairing_.added.size(); ++k) {
            const Index v = pairing_.added[k];
            pairs.push_back({a_.mesh.vertices.row(v), b_.mesh.vertices.row(pairing_.image[to_size(v)]), 1});
            fit.offset += (pairs.back().source - pairs.back().target).squaredNorm() / static_cast<double>(n);
        }
        const symmetry::Alignment alignment = symmetry::fit_alignment(pairs, reversed_);
        fit.rigid = symmetry::squared_error(alignment, pairs);
        // Neighbors in the walk's order are near each other: their distances stand for edges.
        const double scale = alignment.similarity.scale;
        for (std::size_t k = 0; k + 1 < n; ++k) {
            const double ours = (pairs[k + 1].source - pairs[k].source).norm() * scale,
                         theirs = (pairs[k + 1].target - pairs[k].target).norm();
            fit.edges += (ours - theirs) * (ours - theirs) / static_cast<double>(n);
        }
        return fit;
    }

    const SolidMap& a_;
    const SolidMap& b_;
    bool reversed_;
    std::size_t budget_, wasted_ = 0;
    Pairing pairing_;
    Walk walk_;
    double tolerance_ = 0, log10_ = 0;
    Index failed_ = -1, n_placed_ = 0;
    bool found_ = false, exhausted_ = false, is_bound_ = false;
};

std::string first_difference(const SolidMap& a, const SolidMap& b) {
    return isomorphism::first_difference(
        {{"tetrahedra", to_size(a.mesh.n_tetrahedra()), to_size(b.mesh.n_tetrahedra())},
         {"vertices", to_size(a.mesh.n_vertices()), to_size(b.mesh.n_vertices())},
         {"vertices without tetrahedra", a.isolated.size(), b.isolated.size()},
         {"components", to_size(a.n_components()), to_size(b.n_components())},
         {"faces at the boundary", to_size(a.boundary_faces), to_size(b.boundary_faces)},
         {"faces with more than two tetrahedra", to_size(a.overlapping_faces),
          to_size(b.overlapping_faces)}});
}

// The vertices without tetrahedra, by position after the alignment of the others.
void pair_isolated(const SolidMap& a, const SolidMap& b, bool reversed, std::vector<Index>& image) {
    if (a.isolated.empty()) return;
    std::vector<symmetry::PointPair> pairs;
    for (std::size_t v = 0; v < image.size(); ++v)
        if (image[v] >= 0)
            pairs.push_back({a.mesh.vertices.row(static_cast<Index>(v)), b.mesh.vertices.row(image[v]), 1});
    const symmetry::Alignment alignment = symmetry::fit_alignment(pairs, reversed);
    std::vector<symmetry::Moments> from, to;
    for (const Index v : a.isolated)
        from.push_back(symmetry::moments_of(alignment(a.mesh.vertices.row(v)), Eigen::Matrix3d::Zero()));
    for (const Index w : b.isolated)
        to.push_back(symmetry::moments_of(b.mesh.vertices.row(w), Eigen::Matrix3d::Zero()));
    const std::vector<Index> chosen = symmetry::assign_components(from, to);
    for (std::size_t i = 0; i < from.size(); ++i)
        if (chosen[i] >= 0) image[to_size(a.isolated[i])] = b.isolated[to_size(chosen[i])];
}

void describe(const SolidMap& a, const Matcher& matcher, VolumeResult& result) {
    const auto add = [&](MessageCode code, std::string sentence, std::vector<Index> vertices = {}) {
        result.messages.push_back(
            {code, Severity::notice, std::move(sentence), {Subject::map, std::move(vertices)}});
    };
    if (result.mirrored) add(MessageCode::mirror_image, "the target is a mirror image of the source");
    if (!result.automorphisms.number || *result.automorphisms.number > 1)
        add(MessageCode::symmetric_connectivity,
            fmt::format("the connectivity is symmetric: {} matches are possible, the choice was made by "
                        "geometry",
                        to_string(result.automorphisms)));
    if (matcher.n_placed() > 0)
        add(MessageCode::interchangeable_components,
            fmt::format("{} components are interchangeable; they were paired by shape and place",
                        matcher.n_placed() + 1));
    if (!a.isolated.empty())
        add(MessageCode::isolated_vertices,
            fmt::format("{} vertices without tetrahedra were paired by position", a.isolated.size()),
            a.isolated);
}

// Colors of few rounds tell nearly all meshes apart; more are worth their time only where walks fail.
std::unique_ptr<Matcher> match_colored(SolidMap& a, SolidMap& b, bool reversed) {
    constexpr std::array<int, 3> more_rounds = {3, 9, 36};
    for (const int rounds : more_rounds) {
        parallel_invoke([&] { a.refine(rounds); }, [&] { b.refine(rounds); });
        const std::size_t budget = rounds == more_rounds.back() ? std::numeric_limits<std::size_t>::max()
                                                                : max_wasted * to_size(a.mesh.n_tetrahedra());
        auto matcher = std::make_unique<Matcher>(a, b, reversed, budget);
        if (matcher->run()) return matcher;
    }
    return nullptr;  // not reached: the last budget has no end
}

}  // namespace

VolumeResult match_connectivity(const TetrahedralMesh& source, const TetrahedralMesh& target,
                                bool allow_mirror, const Progress& progress) {
    VolumeResult result;
    result.method = MatchMethod::exact;
    std::optional<SolidMap> a, b;
    parallel_invoke([&] { a.emplace(source); }, [&] { b.emplace(target); });
    report_progress(progress, 0.5);
    result.n_components = a->n_components();
    result.difference = first_difference(*a, *b);
    if (!result.difference.empty()) return result;
    std::unique_ptr<Matcher> matcher = match_colored(*a, *b, false);
    report_progress(progress, 0.7);
    if (!matcher->found()) {
        const Index component = matcher->failed_component();
        result.difference = fmt::format(
            "no target component has the connectivity of the source component with tetrahedron {} ({} "
            "tetrahedra), or it touches others elsewhere",
            a->order[to_size(a->component_begin[to_size(component)])], a->component_size(component));
        matcher = match_colored(*a, *b, true);
        if (!matcher->found()) return result;
        result.difference = "the target is a mirror image of the source, which must be allowed";
        if (!allow_mirror) return result;
        result.difference.clear();
        result.mirrored = true;
    }
    report_progress(progress, 0.9);
    result.identical = true;
    result.automorphisms = matcher->automorphisms();
    describe(*a, *matcher, result);
    std::vector<Index> image = matcher->take_image();
    pair_isolated(*a, *b, result.mirrored, image);
    result.target_from_source = VertexMap(std::move(image), target.n_vertices());
    result.confidence = Vector::Ones(source.n_vertices());
    report_progress(progress, 1);
    return result;
}

}  // namespace counterpart::volume
