"""Random generators as plain values, so that a continued run draws what it would have drawn."""

import random
from collections.abc import Mapping
from typing import Any

import numpy as np
import numpy.typing as npt
import torch

Tensors = dict[str, npt.NDArray[np.generic]]


def capture_global_generators() -> tuple[dict[str, Any], Tensors]:
    """States of Python's, NumPy's and torch's global generators, which stable-baselines3 uses.

    Returns:
        Plain values and arrays for `restore_global_generators`.
    """
    version, python_words, python_gauss = random.getstate()
    legacy = np.random.get_state(legacy=False)
    assert isinstance(legacy, dict)
    values = {
        "python": {"version": version, "gauss": python_gauss},
        "numpy": {
            "position": int(legacy["state"]["pos"]),
            "has_gauss": int(legacy["has_gauss"]),
            "gauss": float(legacy["gauss"]),
        },
    }
    tensors: Tensors = {
        "random.python": np.array(python_words, dtype=np.uint32),
        "random.numpy": np.array(legacy["state"]["key"], dtype=np.uint32),
        "random.torch": torch.get_rng_state().numpy().copy(),
    }
    return values, tensors


def restore_global_generators(
    values: Mapping[str, Any], tensors: Mapping[str, npt.NDArray[np.generic]]
) -> None:
    """The inverse of `capture_global_generators`."""
    python = values["python"]
    words = tuple(int(word) for word in tensors["random.python"])
    random.setstate((python["version"], words, python["gauss"]))
    numpy_values = values["numpy"]
    np.random.set_state(
        {
            "bit_generator": "MT19937",
            "state": {"key": tensors["random.numpy"], "pos": numpy_values["position"]},
            "has_gauss": numpy_values["has_gauss"],
            "gauss": numpy_values["gauss"],
        }
    )
    torch.set_rng_state(torch.from_numpy(np.array(tensors["random.torch"], dtype=np.uint8)))


def capture_generators(generators: Mapping[str, np.random.Generator]) -> dict[str, Any]:
    """States of named generators as plain values."""
    return {name: generator.bit_generator.state for name, generator in generators.items()}


def restore_generators(
    generators: Mapping[str, np.random.Generator], states: Mapping[str, Any]
) -> None:
    """The inverse of `capture_generators`, in place."""
    for name, generator in generators.items():
        generator.bit_generator.state = states[name]
