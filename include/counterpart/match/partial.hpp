// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/message.hpp>
#include <counterpart/base/progress.hpp>
#include <counterpart/map/vertex_map.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace counterpart {

/// Which of two meshes is a part of what the other shows, so that the other has more than it.
enum class Part {
    unknown,  ///< seen from the meshes: their boundaries and areas
    source,   ///< every source vertex has a partner, not every target vertex
    target,   ///< every target vertex has a partner, not every source vertex
    both,     ///< parts that overlap: neither
    neither,  ///< two whole surfaces, of which one may be fused where it touches itself; of open ones, where
              ///< both are found to show the same region
};
/// "unknown", "source", ...
std::string to_string(Part part);

struct PartialOptions {
    Part part = Part::unknown;
    /// The files share their unit of length, as scans usually do. Otherwise the scale is searched, which is
    /// less certain and takes longer.
    bool same_scale = false;
    /// Known pairs (source vertex, target vertex), from 0; none to 2000 less a quarter of n_samples. They
    /// hold exactly in both maps, where no two share a vertex.
    std::vector<std::pair<Index, Index>> landmarks{};
    bool soft_landmarks = false;  ///< landmarks guide the search only
    /// What is known of the map besides, as in SpectralOptions: maps that go against it lose. At most as many
    /// pairs as landmarks.
    std::vector<std::pair<Index, Index>> excluded{};
    bool aligned = false;
    Eigen::Vector3d up = Eigen::Vector3d::Zero(), facing = Eigen::Vector3d::Zero();
    /// The target is read as a mirror image: the map reverses the orientation, left to left of a part of a
    /// left bone and a right one. Not with `aligned`.
    bool mirrored = false;
    int n_samples = 900;  ///< farthest-point samples of the whole, 200 .. 5000; a quarter as many of the part
    int n_alternatives = 3;  ///< runners-up to report, 0 .. 10
    std::uint64_t seed = 0;  ///< of the groups that are tried; good maps do not depend on it
    int n_threads = 0;       ///< 0 = all; does not change the result
    Progress progress{};     ///< see base/progress.hpp
};

/// A runner-up.
struct PartialAlternative {
    VertexMap target_from_source;
    double score = 0;
    double moved = 0;  ///< share of the matched vertices that it takes to another place than the best map
};

struct PartialResult {
    /// Unmatched (-1): what has no partner on the other mesh.
    VertexMap target_from_source, source_from_target;
    /// Per source vertex, in [0, 1]: above 0.8 is reliable, below 0.2 is not; of an unmatched vertex, that it
    /// is so.
    Vector confidence;
    Part part = Part::unknown;                  ///< as given or as seen; never unknown
    bool mirrored = false;                      ///< the map reverses the orientation
    double scale = 1;                           ///< by which the source was multiplied
    double source_share = 0, target_share = 0;  ///< of the area with a partner
    /// How alike the matched surfaces look, in [0, 1]: right maps reach about 0.6 and more. Of two whole
    /// surfaces the score of match_spectral.
    double score = 0;
    double agreement = 0;  ///< in [0, 1]; of a part, of distances; of two: what fits of all that should
    double margin = 0;     ///< over the best runner-up's score; infinite if there is none
    /// Of two parts: by how much more of them fits, in [-2, 2], where one is laid on the other's mirror image
    /// as a whole; otherwise 0. Ends of bones of two sides: 0.07 to 0.19.
    double gain_in_mirror = 0;
    std::vector<PartialAlternative> alternatives;  ///< best first
    /// Of two whole surfaces: vertices where one seems to be fused with another part of itself; increasing.
    std::vector<Index> source_touching, target_touching;
    std::vector<Message> messages;  ///< what was noticed and what may be wrong
    std::vector<StageTime> stages;  ///< seconds of each stage, named as in docs/methods/partial.md
};

/// Automatic dense correspondence where a mesh shows only a part of the other, has holes, or is fused with
/// itself. Samples are matched by local shape (SHOT) and by distances along the surfaces, of which cuts leave
/// only bounds; the part is then bent onto the other mesh. Two whole surfaces are matched as by
/// match_spectral. Common connectivity is not used. Independent of position, rotation and numbering, and of
/// scale unless same_scale says that it is known. docs/methods/partial.md describes the method.
///
/// Throws InvalidInput for invalid meshes, meshes without area or with fewer than 50 distinct vertices, and
/// for options out of range, or more vertices times samples than 450 million; Canceled. About O(V^1.2) time;
/// memory: 8 (n_samples + landmarks) bytes per vertex and 576 (n_samples / 4 + landmarks)^2 bytes.
PartialResult match_partial(MeshView source, MeshView target, const PartialOptions& options = {});

}  // namespace counterpart
