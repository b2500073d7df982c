# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""The commands `counterpart collection` and `counterpart retrieve`."""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Callable

from .. import Canceled, InvalidInput, IoError

REFUSED, NOT_UNDERSTOOD, NOT_WRITTEN, INTERRUPTED = 1, 2, 3, 130


def collection(arguments: list[str] | None = None) -> int:
    """The program `counterpart-collection`."""
    return _answered(_collection_parser(), _make, arguments)


def retrieve(arguments: list[str] | None = None) -> int:
    """The program `counterpart-retrieve`."""
    return _answered(_retrieve_parser(), _retrieve, arguments)


def _collection_parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="counterpart collection",
        description="All meshes of a folder in one correspondence: registered meshes, landmarks, mean, modes, scores, "
        "a table of quality and a report. Run it again to go on where it was stopped.",
    )
    add = parser.add_argument
    add("folder", metavar="FOLDER", help="with one mesh for each specimen")
    add("-o", "--output", metavar="OUT", required=True, help="folder to write to; it keeps what has been computed")
    add("--template", metavar="MESH", help="whose triangles all get; default: the specimen in the middle")
    add("--landmarks", metavar="FILE", help="points on one specimen, carried to all; the file is named like it")
    add(
        "--landmark-axes",
        choices=["LPS", "RAS"],
        help="what the meshes are in: landmarks whose file says otherwise are turned to it (default: as they are)",
    )
    add("--semi", metavar="N", type=int, default=0, help="so many evenly spread points on all (default: 0)")
    add(
        "--mirror",
        choices=["never", "auto"],
        default="never",
        help="auto: left and right may be mixed (twice the time)",
    )
    add("--same-scale", action="store_true", help="the meshes share their unit, and size is part of the shape")
    add("--sequence", action="store_true", help="frames in time, in the order of their names")
    add("--pairs", choices=["sparse", "all"], default="sparse", help="which pairs are matched (default: sparse, O(N))")
    add(
        "--rounds", metavar="N", type=int, default=3, help="most rounds with the mean as template, 1 .. 10 (default: 3)"
    )
    add("--seed", metavar="N", type=int, default=0, help="of the random pairs (default: 0)")
    add("--add", action="store_true", help="the meshes of FOLDER join the collection OUT, which stays as it is")
    _add_running(parser)
    return parser


def _retrieve_parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="counterpart retrieve", description="The specimens of a collection that are most like a mesh."
    )
    parser.add_argument("query", metavar="QUERY", help="a mesh")
    parser.add_argument("--in", dest="collection", metavar="OUT", required=True, help="folder of the collection")
    parser.add_argument("-k", metavar="N", type=int, default=5, help="how many (default: 5)")
    parser.add_argument("--report", metavar="FILE", help="write the answer as JSON")
    return parser


def _add_running(parser: argparse.ArgumentParser) -> None:
    group = parser.add_argument_group("where it runs")
    group.add_argument(
        "--scheduler",
        metavar="ADDRESS",
        help="of a Dask cluster, as tcp://host:8786; default: processes on this machine",
    )
    group.add_argument(
        "--workers", metavar="N", type=int, default=0, help="processes (default: one for each processor)"
    )
    group.add_argument("-q", "--quiet", action="store_true", help="no progress")


def _make(given: argparse.Namespace) -> None:
    from . import Collection

    if given.add:
        _refuse_beside_add(given)
        found = Collection(given.output).add(
            given.folder, scheduler=given.scheduler, workers=given.workers, progress=not given.quiet
        )
        print(
            f"{len(found.names)} specimens in {given.output}, {len(found.left_out)} left out: "
            f"see {given.output}/quality.csv"
        )
        _print_left_out(found.left_out)
        return
    if given.sequence and given.pairs == "all":
        raise InvalidInput("--sequence and --pairs all: say one")
    found = Collection.build(
        given.folder,
        given.output,
        template=given.template,
        landmarks=given.landmarks,
        landmark_axes=given.landmark_axes,
        semi=given.semi,
        mirror=given.mirror,
        same_scale=given.same_scale,
        pairs="sequence" if given.sequence else given.pairs,
        rounds=given.rounds,
        seed=given.seed,
        scheduler=given.scheduler,
        workers=given.workers,
        progress=not given.quiet,
    )
    print(
        f"{len(found.names)} specimens in one correspondence, {len(found.left_out)} left out: "
        f"{given.output}/report.html"
    )
    _print_left_out(found.left_out)
    for sentence in found.notices:
        print(f"  note: {sentence}")


def _print_left_out(left_out: dict[str, str]) -> None:
    for name, why in left_out.items():
        print(f"  {name}: {why}")


def _refuse_beside_add(given: argparse.Namespace) -> None:
    settings = ("template", "landmarks", "landmark_axes", "semi", "mirror", "same_scale", "sequence", "pairs", "rounds")
    for name in (*settings, "seed"):
        if getattr(given, name) != _collection_parser().get_default(name):
            raise InvalidInput(
                f"--{name.replace('_', '-')} is not used with --add: the collection stays as it was made"
            )


def _retrieve(given: argparse.Namespace) -> None:
    from . import Collection

    found = Collection(given.collection).retrieve(given.query, given.k)
    for answer in found:
        print(f"{answer.name}: score {answer.score:.3f}, descriptors {answer.distance:.3f} apart")
    if given.report:
        with open(given.report, "w", encoding="utf-8") as file:
            json.dump([vars(answer) for answer in found], file, indent=1)


def _answered(
    parser: argparse.ArgumentParser, work: Callable[[argparse.Namespace], None], arguments: list[str] | None
) -> int:
    """Runs a command and says what went wrong in a line, with the codes of the program."""
    given = parser.parse_args(arguments)
    try:
        work(given)
    except (KeyboardInterrupt, Canceled):
        print("interrupted; run it again to go on", file=sys.stderr)
        return INTERRUPTED
    except (InvalidInput, IoError) as error:
        print(f"error: {error}", file=sys.stderr)
        return REFUSED
    except OSError as error:
        print(f"error: {error.filename or 'output'}: {error.strerror or error}; run it again to go on", file=sys.stderr)
        return NOT_WRITTEN
    except ModuleNotFoundError as error:
        print(f"error: {error}", file=sys.stderr)
        return REFUSED
    return 0
