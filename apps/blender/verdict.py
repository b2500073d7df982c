# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""How far to trust a map, in one word and one sentence, as `counterpart match` says it."""

from __future__ import annotations

from dataclasses import dataclass

import counterpart3d as cp

DOUBTFUL = 0.2  # confidence below which a vertex is not to be relied on (see cp.SpectralResult)
LOOK_SHARE, REJECT_SHARE = 0.05, 0.5  # of doubtful vertices: from here on look at the map, or do not use it


@dataclass(frozen=True)
class Verdict:
    word: str  # "use", "check" or "do not use"
    reason: str  # empty for "use"


def verdict_on(result: cp.MatchResult, n_ignored: int = 0) -> Verdict:
    """`n_ignored`: landmarks that the map does not hold."""
    matched = result.target_from_source >= 0
    doubtful = matched & (result.confidence < DOUBTFUL)
    reasons = [sentence for sentence in result.warnings if not sentence.startswith(("source: ", "target: "))][:1]
    if n_ignored:
        reasons.append(f"{n_ignored} landmarks are not kept, the connectivity says otherwise")
    unmatched_share, doubtful_share = 1 - matched.mean(), doubtful.mean()
    if unmatched_share > 0.5:
        reasons.append(f"{unmatched_share:.0%} of the vertices have no counterpart")
    rejected = doubtful_share > REJECT_SHARE or any("do not rely" in reason for reason in reasons)
    if reasons or doubtful_share > LOOK_SHARE:
        if doubtful.any():
            reasons.append(f"{max(doubtful_share, 0.01):.0%} of the vertices are doubtful")
        return Verdict("do not use" if rejected else "check", "; ".join(reasons))
    return Verdict("use", "")
