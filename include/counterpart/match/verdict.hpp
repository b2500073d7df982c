// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/message.hpp>
#include <counterpart/match/match.hpp>

#include <string>
#include <vector>

namespace counterpart {

/// Whether to rely on a map.
enum class Advice {
    use,
    check,       ///< look at it first
    do_not_use,  ///< it is most likely wrong
};
/// "use", "check", "do not use".
std::string to_string(Advice advice);

struct Verdict {
    Advice advice = Advice::use;
    std::vector<Message> reasons;  ///< the gravest first; none where the advice is to use the map
};
/// "use", or "check: " and the reasons.
std::string to_string(const Verdict& verdict);
/// The reasons alone, as one sentence.
std::string reason(const Verdict& verdict);

/// What these messages come to: the gravest of their severities decides, and all but notices are
/// reasons, whatever their order.
Verdict verdict(const std::vector<Message>& messages);

/// Of a result of match: its messages tell all that is known of its map.
Verdict verdict(const MatchResult& result);

/// What a map and its confidence say, vertex by vertex, as match adds it to its messages: how many vertices
/// are to be doubted, and where (below 0.2; a tenth of them is a caution, half of them too many), and how
/// many have no partner. An empty confidence is none. O(V).
std::vector<Message> doubts(const VertexMap& target_from_source, const Vector& confidence, MeshView source);

/// Why a map that these messages are about may be wrong, the likeliest first, as match tells it in its
/// result. Empty where they are mere notices. O((V + F) log F).
std::vector<Message> probable_causes(MeshView source, MeshView target, const std::vector<Message>& messages);

}  // namespace counterpart
