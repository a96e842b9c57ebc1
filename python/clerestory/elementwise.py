"""Functions of one number become functions of arrays: scalars in, a float out; arrays in, an array of their shape."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from clerestory.errors import ClerestoryError

FloatOrArray = float | NDArray[np.float64]


def elementwise(
    function: Callable[..., Sequence[NDArray[np.float64]]], *arguments: ArrayLike
) -> tuple[FloatOrArray, ...]:
    """The results of ``function`` of equally long vectors, in the broadcast shape of ``arguments``."""
    try:
        arrays = np.broadcast_arrays(*(np.asarray(argument, dtype=np.float64) for argument in arguments))
    except ValueError:
        shapes = ", ".join(str(np.shape(argument)) for argument in arguments)
        raise ClerestoryError(f"the arguments' shapes must broadcast, got {shapes}; reshape them") from None
    shape = arrays[0].shape
    results = function(*(np.ascontiguousarray(array).ravel() for array in arrays))
    return tuple(float(result[0]) if shape == () else result.reshape(shape) for result in results)
