"""From a checkpoint to a policy: rebuilt from its configuration, never unpickled."""

from pathlib import Path

import numpy as np
import numpy.typing as npt
import torch

from singulate.agents.baselines import BASELINES
from singulate.agents.policy import Policy
from singulate.agents.registry import agent_kind
from singulate.checkpoints import Checkpoint, latest_checkpoint, read_checkpoint
from singulate.checkpoints.tensors import Tensors
from singulate.envs import EnvConfig
from singulate.exceptions import CheckpointError, InvalidValueError


def load_policy(path: str | Path) -> Policy:
    """Load a trained agent.

    Args:
        path: A checkpoint directory, a run directory (its newest checkpoint), or the name of a
            policy without learning (a key of `BASELINES`).

    Raises:
        CheckpointError: If it is missing, damaged or not one of ours.
    """
    if str(path) in BASELINES:
        return BASELINES[str(path)]()
    return policy_from_checkpoint(read_checkpoint(checkpoint_directory(path), with_files=False))


def checkpoint_directory(path: str | Path) -> Path:
    """The checkpoint that a checkpoint or run directory stands for.

    Raises:
        CheckpointError: If a run directory has none that verifies.
    """
    directory = Path(path)
    if not (directory / "checkpoints").is_dir() or (directory / "manifest.json").exists():
        return directory
    newest = latest_checkpoint(directory / "checkpoints")
    if newest is None:
        raise CheckpointError(f"{directory}: this run has no intact checkpoint yet")
    return newest


def policy_from_checkpoint(checkpoint: Checkpoint) -> Policy:
    """Rebuild the policy that a checkpoint describes.

    Raises:
        CheckpointError: If its configuration or its tensors do not fit any agent of ours.
    """
    manifest = checkpoint.manifest
    try:
        kind = agent_kind(manifest.agent)
        config = kind.make_config(manifest.agent_config)
        env_config = EnvConfig.from_dict(manifest.env_config)
    except (InvalidValueError, TypeError) as error:
        raise CheckpointError(f"checkpoint: {error}") from error
    policy, network = kind.build_policy(config, env_config)
    load_tensors(network, checkpoint.tensors)
    network.eval()
    return policy


def load_tensors(network: torch.nn.Module, tensors: Tensors) -> None:
    """Fill a network; names, shapes and types have to be exactly its own.

    Raises:
        CheckpointError: If anything is missing, unknown or of another shape or type.
    """
    expected = network.state_dict()
    for name in sorted(expected.keys() ^ tensors.keys()):
        problem = "is missing" if name in expected else "is unknown"
        raise CheckpointError(f"checkpoint: tensor {name} {problem}")
    for name, parameter in expected.items():
        _check_tensor(name, tensors[name], parameter)
    network.load_state_dict({name: torch.from_numpy(array) for name, array in tensors.items()})


def tensors_of(network: torch.nn.Module) -> dict[str, npt.NDArray[np.generic]]:
    """Copies of a network's tensors by name."""
    return {name: value.numpy().copy() for name, value in network.state_dict().items()}


def _check_tensor(name: str, array: npt.NDArray[np.generic], parameter: torch.Tensor) -> None:
    shape, dtype = tuple(parameter.shape), parameter.numpy().dtype
    if array.shape != shape or array.dtype != dtype:
        raise CheckpointError(
            f"checkpoint: tensor {name} is {array.dtype}{list(array.shape)}, "
            f"not {dtype}{list(shape)}"
        )
