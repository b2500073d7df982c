# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Stage three: the template on every specimen, their mean as the next template, until it rests."""

from __future__ import annotations

import dataclasses
import hashlib
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from .. import InvalidInput, vertex_areas
from .._arrays import FloatArray, IntArray
from .choice import Network
from .consensus import Neighbor, agree, agreement_key, located, located_key, refit, refit_key
from .pairs import pair_key
from .procrustes import Alignment, generalized_procrustes
from .registration import register, registration_key
from .runner import Progress, Runner
from .settings import Settings
from .shapes import described
from .specimens import Specimen
from .store import Store, key_of
from .surfaces import area, diagonal

Task = Callable[..., str | None]
AT_REST = 1e-3  # of the diagonal
AGREEMENTS = 3
SOUND = 0.5  # corruption up to which a map takes part in the consensus
NO_SHAPE = 0.9  # a mean that has lost more than a tenth of the area of the shapes


@dataclasses.dataclass(frozen=True)
class Registered:
    """All specimens in the connectivity of the template.

    Attributes
    ----------
    members : list of int
        Those that have been registered.
    keys : list of str
        Of their `registrations`.
    triangles : ndarray of int32
    weights : ndarray
        Area of each vertex of the mean.
    template : str
        Key of the `shapes` that was fitted.
    alignment : Alignment
    movement : list of float
        Of the mean in each round, as a fraction of the diagonal.
    failures : dict of int to str
    notices : list of str
    """

    members: list[int]
    keys: list[str]
    triangles: IntArray
    weights: FloatArray
    template: str
    alignment: Alignment
    movement: list[float]
    failures: dict[int, str]
    notices: list[str]


def registered_specimens(
    runner: Runner,
    store: Store,
    specimens: list[Specimen],
    network: Network,
    settings: Settings,
    progress: Progress,
    apart: int | None,
) -> Registered:
    """Register all that belong; `apart` is the specimen that only serves as the template.

    Raises
    ------
    InvalidInput
        Fewer than two could be registered.
    """
    root = network.tree.root
    reached = np.isfinite(network.tree.cost)
    members = [i for i in range(len(specimens)) if reached[i] and i not in network.strangers and i != apart]
    failures = {i: "no pair leads to it" for i in range(len(specimens)) if not reached[i]}
    template, movement, notices = specimens[root].key, [], []
    triangles = store.get("shapes", template)["triangles"]
    starts = {i: ("starts", _kept_start(store, network.from_root(i))) for i in members}
    alignment = None
    for number in range(1, settings.rounds + 1):
        what = f"round {number}: fitted"
        failed = _round(runner, store, specimens, network, template, starts, what, progress)
        failures |= failed
        members = [i for i in members if i not in failed]
        if len(members) < 2:
            why = "".join(f"; {specimens[i].name}: {message}" for i, message in list(failures.items())[:1])
            raise InvalidInput(f"fewer than two specimens could be registered{why}")
        keys = [registration_key(template, specimens[i].key, bool(network.mirrored[i]), starts[i][1]) for i in members]
        shapes = np.stack([store.get("registrations", key)["vertices"] for key in keys])
        before = store.get("shapes", template)["vertices"]
        weights = vertex_areas((before, triangles))
        alignment = generalized_procrustes(shapes, weights, keep_size=settings.same_scale)
        movement.append(_movement(before, alignment.mean, weights))
        progress.say(f"round {number}: the mean moved by {100 * movement[-1]:.2f} % of the diagonal")
        kept_area = area(alignment.mean, triangles) / np.mean([area(s, triangles) for s in alignment.aligned])
        if kept_area < NO_SHAPE:
            notices.append(
                f"the shapes differ in pose: their mean has {100 * kept_area:.0f} % of their area and is no shape "
                f"of its kind, so {specimens[root].name} stays the template"
            )
        if movement[-1] < AT_REST or number == settings.rounds or kept_area < NO_SHAPE:
            break
        template = kept_template(store, alignment.mean, triangles)
        starts = {i: ("registrations", key) for i, key in zip(members, keys, strict=True)}
    assert alignment is not None
    return Registered(members, keys, triangles, weights, template, alignment, movement, failures, notices)


def kept_template(store: Store, vertices: FloatArray, triangles: IntArray) -> str:
    """The key of the `shapes` that a made mesh is kept as."""
    content = hashlib.sha256(vertices.tobytes() + triangles.tobytes()).hexdigest()
    key = key_of("template", content)
    if store.load("shapes", key) is None:
        store.save("shapes", key, {"vertices": vertices, "triangles": triangles, **described(vertices, triangles)})
    return key


def _kept_start(store: Store, image: IntArray) -> str:
    key = key_of("starts", hashlib.sha256(image.tobytes()).hexdigest())
    if store.load("starts", key) is None:
        store.save("starts", key, {"image": image})
    return key


def _movement(before: FloatArray, after: FloatArray, weights: FloatArray) -> float:
    """Root mean square distance between two templates, aligned, as a fraction of the diagonal."""
    both = generalized_procrustes(np.stack([before, after]), weights).aligned
    w = weights / weights.sum()
    return float(np.sqrt(w @ ((both[0] - both[1]) ** 2).sum(axis=1)) / diagonal(after))


def _round(
    runner: Runner,
    store: Store,
    specimens: list[Specimen],
    network: Network,
    template: str,
    starts: dict[int, tuple[str, str]],
    what: str,
    progress: Progress,
) -> dict[int, str]:
    members = sorted(starts)
    items = [(store, template, specimens[i].key, bool(network.mirrored[i]), starts[i]) for i in members]
    failures: dict[int, str] = {}
    progress.start()
    for done, (k, message) in enumerate(runner.outcomes(register, items)):
        if message is not None:
            failures[members[k]] = message
            progress.say(f"{specimens[members[k]].name} could not be fitted: {message}")
        progress.step(what, done + 1, len(items))
    return failures


def agreed_specimens(
    runner: Runner,
    store: Store,
    specimens: list[Specimen],
    network: Network,
    settings: Settings,
    found: Registered,
    progress: Progress,
) -> Registered:
    """The same, each fit moved to where those of the neighbors, through the chosen maps, put it; a few times over, so
    that what a map says reaches shapes farther away.
    """
    whole = dict(zip(found.members, found.keys, strict=True))
    shape = {i: (specimens[i].key, bool(network.mirrored[i])) for i in whole}

    def done_for(what: str, task: Task, items: Mapping[int, tuple[Any, ...]]) -> set[int]:
        failed, members = set(), list(items)
        progress.start()
        for done, (k, message) in enumerate(runner.outcomes(task, [(store, *item) for item in items.values()])):
            if message is not None:
                failed.add(members[k])
            progress.step(what, done + 1, len(items))
        return failed

    lost = done_for("located", located, {i: (*shape[i], key) for i, key in whole.items()})
    key = {i: located_key(registration) for i, registration in whole.items() if i not in lost}
    for number in range(1, AGREEMENTS + 1):
        around = {
            i: [_neighbor(specimens, network, settings, key, i, j) for j in _next_to(network, key, i)] for i in key
        }
        items = {i: (*shape[i], key[i], around[i]) for i in key}
        lost = done_for(f"agreed, {number} of {AGREEMENTS}", agree, items)
        key = {i: own if i in lost else agreement_key(own, around[i]) for i, own in key.items()}
    fits = {i: (found.template, *shape[i], whole[i], agreement) for i, agreement in key.items()}
    lost = done_for("fitted to that", refit, fits)
    keys = [refit_key(k, key[i]) if i in key and i not in lost else k for i, k in whole.items()]
    shapes = np.stack([store.get("registrations", k)["vertices"] for k in keys])
    alignment = generalized_procrustes(shapes, found.weights, keep_size=settings.same_scale)
    return dataclasses.replace(found, keys=keys, alignment=alignment)


def _next_to(network: Network, members: Mapping[int, str], i: int) -> list[int]:
    """The members with a sound chosen map to this one."""
    sound = [edge for edge, corruption in network.choice.corruption.items() if corruption <= SOUND and i in edge]
    return [j for edge in sound for j in edge if j != i and j in members]


def _neighbor(
    specimens: list[Specimen], network: Network, settings: Settings, key: Mapping[int, str], i: int, j: int
) -> Neighbor:
    edge = (min(i, j), max(i, j))
    pair = pair_key(specimens[edge[0]].key, specimens[edge[1]].key, settings.mirror == "auto")
    row = int(network.rows[edge][network.choice.label[edge]])
    return Neighbor(specimens[j].key, key[j], pair, row, edge[0] == j, bool(network.mirrored[j]))
