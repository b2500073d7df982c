# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Arrays of the one type and layout that the library reads, without a copy where they have it already."""

from __future__ import annotations

from typing import Any, Literal

import numpy as np
import numpy.typing as npt

from ._core import InvalidInput

FloatArray = npt.NDArray[np.float64]
IntArray = npt.NDArray[np.int32]

_INT32 = np.iinfo(np.int32)


def _array(values: Any, what: str, kinds: str, noun: str) -> npt.NDArray[Any]:
    try:
        array = np.asarray(values)
    except (ValueError, TypeError, OverflowError) as error:
        raise InvalidInput(f"{what}: not an array: {error}") from None
    empty_list = array.size == 0 and array.dtype == np.float64
    if array.dtype.kind not in kinds and not empty_list:
        raise InvalidInput(f"{what} must hold {noun}, not {array.dtype}")
    return array


def _laid_out(array: npt.NDArray[Any], dtype: Any, order: Literal["C", "F"] = "C") -> npt.NDArray[Any]:
    array = np.asarray(array, dtype, order=order)
    return array if array.flags.aligned else array.copy(order)


def flag(value: Any, what: str) -> bool:
    """True or False, of NumPy too."""
    if not isinstance(value, bool | np.bool_):
        raise InvalidInput(f"{what} must be True or False, not {value!r}")
    return bool(value)


def real_numbers(values: Any, what: str) -> npt.NDArray[Any]:
    """``values`` as an array of any shape and layout."""
    return _array(values, what, "fiu", "real numbers")


def floats(values: Any, what: str, shape: tuple[int, ...], order: Literal["C", "F"] = "C") -> FloatArray:
    """``values`` as contiguous float64 of the shape, in which -1 stands for any length."""
    array = real_numbers(values, what)
    _require_shape(array, what, shape)
    with np.errstate(over="ignore"):
        return _laid_out(array, np.float64, order)


def integers(values: Any, what: str, shape: tuple[int, ...]) -> IntArray:
    """``values`` as C-contiguous int32 of the shape; no number changes."""
    array = _array(values, what, "iu", "integers")
    _require_shape(array, what, shape)
    if array.dtype != np.int32 and array.size and (array.min() < _INT32.min or array.max() > _INT32.max):
        first = int(np.argmax((array < _INT32.min) | (array > _INT32.max)))
        raise InvalidInput(f"{what}: entry {first} is {array.flat[first]}, which is no index")
    return _laid_out(array, np.int32)


def pairs(values: Any, what: str, *, or_map: bool = False) -> IntArray:
    """Pairs of vertices, n x 2, also of a pair (first, second) of two arrays or lists; with `or_map` any array of one
    dimension passes as it is."""
    if isinstance(values, tuple) and len(values) == 2 and all(_is_column(column) for column in values):
        first, second = (integers(column, what, (-1,)) for column in values)
        if len(first) != len(second):
            raise InvalidInput(f"{what}: {len(first)} vertices and {len(second)} make no pairs")
        return np.column_stack([first, second])
    array = real_numbers(values, what)
    return integers(array, what, (-1,) if or_map and array.ndim == 1 else (-1, 2))


def _is_column(value: Any) -> bool:
    """An array or a list, not a tuple: that is one pair."""
    return not isinstance(value, tuple) and getattr(np.asarray(value), "ndim", 0) == 1


def _require_shape(array: npt.NDArray[Any], what: str, shape: tuple[int, ...]) -> None:
    if array.ndim != len(shape) or any(shape[i] not in (-1, array.shape[i]) for i in range(len(shape))):
        wanted = " x ".join("n" if length == -1 else str(length) for length in shape)
        have = " x ".join(map(str, array.shape)) or "a single value"
        raise InvalidInput(f"{what} must be {wanted}, not {have}")
