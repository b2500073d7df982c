# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Stage two: match some of the pairs, and choose their maps for all at once."""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping

import numpy as np

from .. import InvalidInput
from .._arrays import FloatArray, IntArray
from . import chirality, cycles, graph
from .graph import Edge
from .pairs import match_pair, pair_key
from .runner import Progress, Runner
from .settings import Settings
from .specimens import Specimen
from .store import Store
from .tree import Tree, composed, spanning_tree

STRANGE = 0.5  # corruption: maps that lead nowhere
DOUBTFUL = 0.4  # of the usual confidence


@dataclasses.dataclass(frozen=True)
class Network:
    """The chosen maps between the specimens.

    Attributes
    ----------
    families : dict of Edge to Family
        Of all pairs that were matched.
    rows : dict of Edge to ndarray
        Where each map of a family stands in the result `pairs`.
    choice : Choice
        Of those that are not held out.
    held_out : list of Edge
    tree : Tree
    mirrored : ndarray of bool, (n,)
    strangers : dict of int to str
        Specimens that do not belong, and why.
    failures : dict of Edge to str
    usual_confidence : float
        Median of the specimens' best.
    """

    families: Mapping[Edge, cycles.Family]
    rows: Mapping[Edge, IntArray]
    choice: cycles.Choice
    held_out: list[Edge]
    tree: Tree
    mirrored: np.ndarray
    strangers: dict[int, str]
    failures: dict[Edge, str]
    usual_confidence: float

    def step(self, i: int, j: int) -> IntArray:
        """The chosen map from a specimen to a neighbor."""
        edge = (min(i, j), max(i, j))
        family, label = self.families[edge], self.choice.label[edge]
        image: IntArray = (family.forward if i < j else family.backward)[label]
        return image

    def from_root(self, shape: int) -> IntArray:
        """The map from the root's vertices, composed along the tree."""
        if shape == self.tree.root:
            edge, family = next((edge, family) for edge, family in self.families.items() if shape in edge)
            rows = family.forward if edge[0] == shape else family.backward
            return np.arange(rows.shape[1], dtype=np.int32)
        return composed(self.tree, shape, self.step)


def network_of(
    runner: Runner,
    store: Store,
    specimens: list[Specimen],
    settings: Settings,
    progress: Progress,
    root: int | None,
    apart: int | None,
) -> Network:
    """Match and choose; `root` is the template if it was given, `apart` too if it is none of the specimens.

    Raises
    ------
    InvalidInput
        No pair could be matched.
    """
    edges = pairs_to_match(store, specimens, settings, root, apart)
    mirror = settings.mirror == "auto"
    progress.say(f"{len(edges)} pairs of {len(specimens)} shapes are matched")
    failures = _match(runner, store, specimens, edges, mirror, progress)
    edges = [edge for edge in edges if edge not in failures]
    if not edges:
        raise InvalidInput(f"no pair could be matched; the first: {next(iter(failures.values()))}")
    loaded = {e: store.get("pairs", pair_key(specimens[e[0]].key, specimens[e[1]].key, mirror)) for e in edges}
    mirrored = np.zeros(len(specimens), bool)
    if mirror:
        evidence = [(*e, _best(found, False) - _best(found, True)) for e, found in loaded.items()]
        mirrored = chirality.mirrored_shapes(len(specimens), evidence)[0]
        if root is not None and mirrored[root]:
            mirrored = ~mirrored  # the template is as it is
    families, numbers = {}, {}
    for (i, j), found in loaded.items():
        rows = numbers[i, j] = np.flatnonzero(found["mirrored"] == (mirrored[i] != mirrored[j])).astype(np.int32)
        families[i, j] = cycles.Family(found["forward"][rows], found["backward"][rows], found["score"][rows])
    kept_out = graph.held_out(edges, len(specimens), settings.seed) if len(specimens) > 4 else []
    shapes = [specimen.points(store) for specimen in specimens]
    choice = cycles.choose({e: f for e, f in families.items() if e not in kept_out}, shapes)
    confidence = {edge: float(loaded[edge]["confidence"][rows].max()) for edge, rows in numbers.items() if len(rows)}
    most = most_confident(len(specimens), confidence)
    strangers = strangers_among(len(specimens), choice, confidence)
    allowed = np.array([i not in strangers and not mirrored[i] for i in range(len(specimens))])
    tree = spanning_tree(len(specimens), choice.corruption, allowed, root)
    return Network(families, numbers, choice, kept_out, tree, mirrored, strangers, failures, float(np.median(most)))


def pairs_to_match(
    store: Store, specimens: list[Specimen], settings: Settings, root: int | None, apart: int | None
) -> list[Edge]:
    """The pairs, as the settings want them."""
    if settings.pairs == "all":
        return graph.all_pairs(len(specimens))
    if settings.pairs == "sequence":
        return graph.pairs_in_time(len(specimens) - (apart is not None), template=root)
    descriptors = np.stack([specimen.shape(store)["descriptor"] for specimen in specimens])
    return graph.sparse_pairs(descriptors, settings.seed, apart)


def strangers_among(n: int, choice: cycles.Choice, confidence: Mapping[Edge, float]) -> dict[int, str]:
    """Specimens all of whose maps disagree with those around them, or are far less confident than is usual here."""
    if n < 4:
        return {}
    least, most = np.full(n, np.inf), most_confident(n, confidence)
    for edge, corruption in choice.corruption.items():
        least[list(edge)] = np.minimum(least[list(edge)], corruption)
    usual = float(np.median(most))
    said = {i: strangeness(float(least[i]), float(most[i]), usual) for i in range(n)}
    found = {i: why for i, why in said.items() if why is not None}
    return {} if 2 * len(found) >= n else found


def most_confident(n: int, confidence: Mapping[Edge, float]) -> FloatArray:
    """Of each specimen, the confidence of its best map, (n,)."""
    most = np.zeros(n)
    for edge, value in confidence.items():
        most[list(edge)] = np.maximum(most[list(edge)], value)
    return most


def strangeness(least: float, confidence: float, usual: float) -> str | None:
    """Why a specimen does not belong: by the least corruption of its maps, or the confidence of the best."""
    if confidence < DOUBTFUL * usual:
        return f"does not belong: its best map has a confidence of {confidence:.2f}, where {usual:.2f} is usual"
    if least > STRANGE:
        return "does not belong: no map to or from it agrees with the maps between the others"
    return None


def _best(found: Mapping[str, np.ndarray], mirrored: bool) -> float:
    return float(found["score"][found["mirrored"] == mirrored].max())


def _match(
    runner: Runner, store: Store, specimens: list[Specimen], edges: list[Edge], mirror: bool, progress: Progress
) -> dict[Edge, str]:
    failures: dict[Edge, str] = {}
    items = [(store, specimens[i].key, specimens[j].key, mirror) for i, j in edges]
    progress.start()
    for done, (k, message) in enumerate(runner.outcomes(match_pair, items)):
        if message is not None:
            failures[edges[k]] = message
            names = " and ".join(specimens[i].name for i in edges[k])
            progress.say(f"{names} could not be matched: {message}")
        progress.step("pairs", done + 1, len(items))
    return failures
