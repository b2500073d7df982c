// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/partial/readings.hpp"

#include "match/partial/cleaned.hpp"
#include "match/partial/roles.hpp"

#include <counterpart/base/errors.hpp>

#include <utility>

#include <fmt/format.h>

namespace counterpart::partial_match {
namespace {

// Parts of one shape score 0.92 and more; those of other individuals 0.65 to 0.83, and the half of a bone on
// the bone of the other side no less. Read in the mirror the latter gains 0.09 (2 pairs), one of bodies that
// are alike left and right at most 0.01 where its map is right (10 pairs).
constexpr double one_shape = 0.85, clear_gain = 0.06;

// Of gain_in_mirror. Ends of bones of two sides gain 0.07 to 0.19 (12 pairs), pieces of shafts 0.07 and less
// (12), parts of animals 0.03 and less (15 of 16).
constexpr double clear_gain_of_parts = 0.05;

bool is_told(const PartialOptions& options) {
    return options.mirrored || options.aligned || !options.landmarks.empty() || !options.excluded.empty() ||
           !options.up.isZero(0) || !options.facing.isZero(0);
}

// Of two parts the mirror is only named: the left half of a body looks like the mirror image of the right
// half of another, with which it shares nothing.
void name_mirror(PartialResult& of_parts) {
    const double gain = of_parts.gain_in_mirror;
    if (gain > clear_gain_of_parts)
        of_parts.messages.push_back(
            {MessageCode::handedness_unknown, Severity::caution,
             fmt::format(
                 "laid on each other's mirror image the parts fit better (by {:.2f}), as a left and a "
                 "right side do: mirror=always if one shows the other's mirror image",
                 gain)});
    else if (gain > -clear_gain_of_parts)
        of_parts.messages.push_back(
            {MessageCode::handedness_unknown, Severity::notice,
             "laid on each other's mirror image the parts fit about as well: mirror=never and mirror=always "
             "tell which is meant"});
}

}  // namespace

PartialResult match_both_readings(MeshView source, MeshView target, const PartialOptions& options) {
    if (is_told(options)) return match_partial(source, target, options);
    const Part part = options.part == Part::unknown
                          ? seen_part(cleaned(source, "source").mesh, cleaned(target, "target").mesh)
                          : options.part;
    const bool one_is_whole = part == Part::source || part == Part::target;
    PartialOptions reading = options;
    reading.progress = part_of(options.progress, 0, one_is_whole ? 0.5 : 1);
    PartialResult found = match_partial(source, target, reading);
    if (found.part == Part::both) name_mirror(found);
    if (!one_is_whole || found.score >= one_shape) return found;
    reading.progress = part_of(options.progress, 0.5, 1);
    reading.mirrored = true;
    PartialResult mirrored;
    try {
        mirrored = match_partial(source, target, reading);
    } catch (const NumericalError&) {  // nothing fits in the mirror: the other reading stands
        return found;
    }
    if (mirrored.score > found.score + clear_gain) {
        mirrored.messages.push_back(
            {MessageCode::mirror_image, Severity::notice,
             fmt::format("one mesh shows a part of the other's mirror image (score {:.2f}, without mirroring "
                         "{:.2f}): the map reverses orientation (left to left)",
                         mirrored.score, found.score)});
        return mirrored;
    }
    if (mirrored.score > found.score - clear_gain)
        found.messages.push_back(
            {MessageCode::handedness_unknown, Severity::notice,
             fmt::format("read as a part of the mirror image it fits about as well (score {:.2f} against "
                         "{:.2f}): mirror=never and mirror=always tell which is meant",
                         mirrored.score, found.score)});
    return found;
}

}  // namespace counterpart::partial_match
