"""Named arrays as safetensors bytes."""

from collections.abc import Mapping

import numpy as np
import numpy.typing as npt
from safetensors import SafetensorError
from safetensors.numpy import load, save

from singulate.exceptions import CheckpointError

Tensors = dict[str, npt.NDArray[np.generic]]


def encode_tensors(tensors: Mapping[str, npt.NDArray[np.generic]]) -> bytes:
    """Arrays of any shape as bytes.

    Raises:
        CheckpointError: If a value is not finite or a dtype cannot be stored.
    """
    for name, array in tensors.items():
        check_finite(name, array)
    try:
        return bytes(save({name: np.asarray(array, order="C") for name, array in tensors.items()}))
    except (SafetensorError, KeyError, TypeError, ValueError) as error:
        raise CheckpointError(f"tensors cannot be stored: {one_line(error)}") from error


def decode_tensors(data: bytes, source: str = "tensors") -> Tensors:
    """The inverse of `encode_tensors`; the arrays are writable copies.

    Args:
        data: What `encode_tensors` returned, possibly damaged since.
        source: What to call it in an error.

    Raises:
        CheckpointError: If the bytes are not whole, valid safetensors with finite values.
    """
    try:
        tensors = {name: np.array(array) for name, array in load(data).items()}
    except (SafetensorError, KeyError, TypeError, ValueError, AttributeError) as error:
        raise CheckpointError(f"{source}: not valid safetensors: {one_line(error)}") from error
    for name, array in tensors.items():
        check_finite(f"{source}: {name}", array)
    return tensors


def check_finite(name: str, array: npt.NDArray[np.generic]) -> None:
    """Refuse an array with NaN or infinity.

    Raises:
        CheckpointError: If there is one.
    """
    if np.issubdtype(array.dtype, np.inexact) and not np.isfinite(array).all():
        raise CheckpointError(f"{name}: holds values that are not finite")


def one_line(error: Exception) -> str:
    """An exception's text on a single line."""
    return " ".join(str(error).split()) or type(error).__name__
