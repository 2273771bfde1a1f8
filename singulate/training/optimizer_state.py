"""What an optimizer remembers, such as Adam's moments, as arrays."""

from collections.abc import Mapping

import numpy as np
import numpy.typing as npt
import torch


def capture_optimizer(
    name: str, optimizer: torch.optim.Optimizer
) -> dict[str, npt.NDArray[np.generic]]:
    """Copies of its tensors; their names begin with its own."""
    return {
        f"{name}.{index}.{key}": tensor.numpy().copy()
        for index, state in optimizer.state_dict()["state"].items()
        for key, tensor in state.items()
    }


def restore_optimizer(
    name: str,
    optimizer: torch.optim.Optimizer,
    tensors: Mapping[str, npt.NDArray[np.generic]],
) -> None:
    """The inverse of `capture_optimizer`, in place; other tensors are passed over.

    Raises:
        ValueError: If a name is malformed or the tensors do not fit.
    """
    state: dict[int, dict[str, torch.Tensor]] = {}
    for full_name, array in tensors.items():
        if full_name.startswith(f"{name}."):
            _, index, key = full_name.split(".")
            state.setdefault(int(index), {})[key] = torch.from_numpy(np.array(array))
    groups = optimizer.state_dict()["param_groups"]
    optimizer.load_state_dict({"state": state, "param_groups": groups})
