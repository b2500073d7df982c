// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/message.hpp>
#include <counterpart/base/progress.hpp>
#include <counterpart/map/vertex_map.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace counterpart {

namespace spectral_match {
struct PreparedShape;
}

struct SpectralShapeOptions {
    int basis_size = 200;  ///< Laplace-Beltrami eigenfunctions, 30 .. 500
    int n_samples = 1000;  ///< farthest-point samples on which maps are searched, 200 .. 5000
    /// 0: sampling starts at the vertex farthest from the center; otherwise at a vertex drawn from this seed.
    /// Good maps hardly depend on it; a map that changes with the seed is doubtful.
    std::uint64_t seed = 0;
    int n_threads = 0;  ///< 0 = all; does not change the result
    /// Called from the calling thread a few times a second; not by match_spectral, which has its own.
    Progress progress{};
};

struct SpectralOptions;
struct SpectralResult;

/// What is computed for one mesh before the other is known; keep it to match one mesh with many. Cheap to
/// copy.
class SpectralShape {
  public:
    /// Throws InvalidInput for invalid meshes, meshes without area or with fewer than 20 distinct vertex
    /// positions, and options out of range; Canceled. About O(V^1.2 basis_size) up to 8000 vertices; above,
    /// O(V log V).
    explicit SpectralShape(MeshView mesh, const SpectralShapeOptions& options = {});

    Index n_vertices() const;  ///< of the mesh

    /// The shape to be kept: about 2.4 kB for each vertex up to 8000, 15 MB and 60 B for each beyond.
    /// O(size).
    std::string to_bytes() const;
    /// A shape that matches exactly as that which was kept. Throws InvalidInput with a reason for bytes of
    /// another version, cut short, or that to_bytes cannot have made. O(size).
    static SpectralShape from_bytes(std::string_view bytes);

  private:
    explicit SpectralShape(std::shared_ptr<const spectral_match::PreparedShape> shape)
        : shape_(std::move(shape)) {}

    friend SpectralResult match_spectral(const SpectralShape& source, const SpectralShape& target,
                                         const SpectralOptions& options);
    std::shared_ptr<const spectral_match::PreparedShape> shape_;
};

/// Whether the target may be the mirror image of what the source shows: a left bone and a right one.
enum class Mirror {
    automatic,  ///< both readings are searched where a glance at the second promises more; it is taken if
                ///< clearly better
    never,      ///< the map keeps the orientation
    always,     ///< the map reverses the orientation: left to right on a symmetric body
};

struct SpectralOptions {
    /// Known pairs (source vertex, target vertex), from 0; one on a limb that was taken for another one
    /// mostly mends the whole map. They hold exactly in target_from_source, and in source_from_target where
    /// no two have the same target.
    std::vector<std::pair<Index, Index>> landmarks{};
    bool soft_landmarks = false;  ///< landmarks guide the map, but need not hold exactly
    /// Pairs that do not correspond: maps that take the source vertex to within 0.15 sqrt(area) of the target
    /// vertex lose.
    std::vector<std::pair<Index, Index>> excluded{};
    /// Both meshes stand in the same frame: what is left, up and in front in one is so in the other, if only
    /// roughly. Their poses, positions and sizes may differ. Not with `symmetric`.
    bool aligned = false;
    /// Directions that are the same in both frames, of any length; zero = unknown. `facing` needs `up`.
    Eigen::Vector3d up = Eigen::Vector3d::Zero(), facing = Eigen::Vector3d::Zero();
    Mirror mirror = Mirror::automatic;
    bool symmetric = false;  ///< the same as Mirror::always
    /// A map from source to target vertices (-1 = unmatched) to be refined instead of searching one: what was
    /// drawn by hand, composed of other maps, or found before. Of the given map and what refinement makes of
    /// it the one with the better score is returned.
    std::optional<VertexMap> initial{};
    int n_alternatives = 3;  ///< runners-up to report, 0 .. 10
    int n_threads = 0;       ///< 0 = all; does not change the result
    /// Called from the calling thread a few times a second, while the work runs on others.
    Progress progress{};
};

inline bool is_mirror_asked(const SpectralOptions& options) {
    return options.symmetric || options.mirror == Mirror::always;
}

/// A runner-up.
struct SpectralAlternative {
    VertexMap target_from_source;  ///< every source vertex is matched; refined less than the best map
    double score = 0;         ///< that of the best map less how far behind this one was when it was dropped
    std::string description;  ///< how it differs from the best map: mirrored, turned, another part
};

struct SpectralResult {
    VertexMap target_from_source, source_from_target;  ///< every vertex is matched
    /// Per source vertex, in [0, 1]: above 0.8 is reliable, below 0.2 is not; 0 for vertices that only follow
    /// their nearest one.
    Vector confidence;
    double score = 0;   ///< of the best map (equation 4), larger is better: 1.5 = the same shape, bent
    double margin = 0;  ///< over the best runner-up's score; infinite if there is none
    /// The map reverses the orientation: the target is read as a mirror image.
    bool mirrored = false;
    std::vector<SpectralAlternative> alternatives;  ///< best first
    std::vector<Message> messages;                  ///< what was noticed and what may be wrong
    std::vector<StageTime> stages;                  ///< seconds of each, named as in docs/methods/spectral.md
};

/// Automatic dense correspondence of two surfaces of different connectivity: two poses of one body, two
/// people, two animals. Extremities are matched by geodesic distances; the maps that they suggest are grown
/// through the eigenfunctions of the Laplace-Beltrami operator (bijective ZoomOut: Ren et al. 2020, Melzi et
/// al. 2019) and race each other on coarse copies, bent onto each other (Sorkine and Alexa 2007); one score,
/// of relief, normals and the way there and back, tells which is refined on all vertices. Independent of
/// pose, position, scale and numbering. docs/methods/spectral.md describes the method.
///
/// With progress the work runs on a thread of its own while the calling thread reports; cancelling takes
/// effect within about half a second at 100 000 vertices. Throws InvalidInput as SpectralShape, and for
/// options out of range; Canceled. About O(V^1.2 basis_size) time and O(V basis_size) memory up to 8000
/// vertices; above, a proxy of 6000 vertices is matched in their place, and O(V log V) time and O(V) memory
/// are added.
SpectralResult match_spectral(MeshView source, MeshView target, const SpectralOptions& options = {},
                              const SpectralShapeOptions& shape_options = {});
SpectralResult match_spectral(const SpectralShape& source, const SpectralShape& target,
                              const SpectralOptions& options = {});

}  // namespace counterpart
