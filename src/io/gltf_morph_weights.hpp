// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "io/gltf_document.hpp"

#include <cstdint>
#include <vector>

namespace counterpart::io {

/// Removes the weights of a mesh's blend shapes and the animation of them: those of another set of blend
/// shapes say nothing any more.
void forget_morph_weights(GltfDocument& document, std::size_t mesh);

/// Removes the animation of the blend shapes that these nodes show, given in increasing order.
void forget_weight_channels(GltfDocument& document, const std::vector<std::int64_t>& nodes);

/// Adds an animation that shows each mesh as it is, then its blend shapes one after the other, in place of
/// any that moves their weights. Nothing if there are no blend shapes. `frames_per_second` is above 0.
void play_morph_targets(GltfDocument& document, double frames_per_second);

}  // namespace counterpart::io
