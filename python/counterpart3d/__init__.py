# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Which point of mesh B is this point of mesh A?

>>> import counterpart3d as cp
>>> a = cp.make_body()
>>> b, truth = cp.shuffle(cp.deform(a, bend=1.0))
>>> result = cp.match(a, b)
>>> result.method
'exact'
>>> picture = cp.render(a, b, result, size=(320, 200))
"""

from . import _core
from ._alignment import AlignResult, align
from ._arrays import FloatArray, IntArray
from ._calls import ProgressLike
from ._comparison import Comparison, MethodChoice, choose_method, compare
from ._connectivity_results import Count, Differences, Edit, ExactResult, FrontiersResult
from ._core import Canceled, InvalidInput, IoError, NumericalError, UnsuitableMesh
from ._evaluation import Evaluation, MapQuality, evaluate, map_quality
from ._landmarks import Landmarks, carry_landmarks, landmark_pairs, read_landmarks, write_landmarks
from ._maps import (
    MapLike,
    SurfaceMap,
    complete_map,
    compose_maps,
    invert_map,
    nearest_corners,
    project_map,
    read_map,
    transfer_values,
    write_map,
)
from ._match_results import (
    Alternative,
    MatchResult,
    PartialAlternative,
    PartialResult,
    SpectralResult,
    UvResult,
    verdict,
)
from ._matching import find_differences, match, match_assignment, match_exact, match_frontiers, match_nearest
from ._mesh_inspection import MeshObject, inspect, objects, vertex_areas, vertex_normals
from ._meshes import Mesh, MeshLike, read, write
from ._messages import Message, Verdict, Where
from ._pictures import Picture, View, render, view
from ._shape_matching import SpectralShape, match_partial, match_spectral
from ._shapes import (
    deform,
    make_body,
    make_grid,
    make_icosphere,
    make_torus,
    move_at_random,
    shuffle,
    subdivide,
)
from ._spectral import (
    Spectrum,
    ZoomOutResult,
    distances,
    functional_map,
    heat_kernel_signature,
    spectrum,
    vertex_map,
    wave_kernel_signature,
    zoom_out,
)
from ._transfer import (
    FitResult,
    MorphResult,
    ReorderResult,
    TransferResult,
    fit,
    morph,
    reorder,
    transfer,
)

__version__ = _core.version
for _error in (InvalidInput, UnsuitableMesh, IoError, NumericalError, Canceled):
    _error.__module__ = __name__

__all__ = [
    "AlignResult",
    "Alternative",
    "Canceled",
    "Comparison",
    "Count",
    "Differences",
    "Edit",
    "Evaluation",
    "ExactResult",
    "FitResult",
    "FloatArray",
    "FrontiersResult",
    "IntArray",
    "InvalidInput",
    "IoError",
    "Landmarks",
    "MapLike",
    "MapQuality",
    "MatchResult",
    "Mesh",
    "MeshLike",
    "MeshObject",
    "Message",
    "MethodChoice",
    "MorphResult",
    "NumericalError",
    "PartialAlternative",
    "PartialResult",
    "Picture",
    "ProgressLike",
    "ReorderResult",
    "SpectralResult",
    "SpectralShape",
    "Spectrum",
    "SurfaceMap",
    "TransferResult",
    "UnsuitableMesh",
    "UvResult",
    "Verdict",
    "View",
    "Where",
    "ZoomOutResult",
    "align",
    "carry_landmarks",
    "choose_method",
    "compare",
    "complete_map",
    "compose_maps",
    "deform",
    "distances",
    "evaluate",
    "find_differences",
    "fit",
    "functional_map",
    "heat_kernel_signature",
    "inspect",
    "invert_map",
    "landmark_pairs",
    "make_body",
    "make_grid",
    "make_icosphere",
    "make_torus",
    "map_quality",
    "match",
    "match_assignment",
    "match_exact",
    "match_frontiers",
    "match_nearest",
    "match_partial",
    "match_spectral",
    "morph",
    "move_at_random",
    "nearest_corners",
    "objects",
    "project_map",
    "read",
    "read_landmarks",
    "read_map",
    "render",
    "reorder",
    "shuffle",
    "spectrum",
    "subdivide",
    "transfer",
    "transfer_values",
    "verdict",
    "vertex_areas",
    "vertex_map",
    "vertex_normals",
    "view",
    "wave_kernel_signature",
    "write",
    "write_landmarks",
    "write_map",
    "zoom_out",
]
