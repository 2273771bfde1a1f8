"""Everything beyond the weights that a run needs to go on as if it had never stopped.

stable-baselines3's own files are pickles and leave out the random generators.
"""

import json
import math
from collections.abc import Mapping
from typing import Any

import numpy as np
import numpy.typing as npt
import torch
from stable_baselines3.common.base_class import BaseAlgorithm
from stable_baselines3.common.buffers import ReplayBuffer

from singulate.agents.loading import load_tensors, tensors_of
from singulate.checkpoints import decode_tensors, encode_tensors
from singulate.exceptions import CheckpointError
from singulate.training.envs import TrainingEnvs
from singulate.training.episode_state import EpisodeState
from singulate.training.optimizer_state import capture_optimizer, restore_optimizer
from singulate.training.random_states import (
    capture_generators,
    capture_global_generators,
    restore_generators,
    restore_global_generators,
)
from singulate.training.replay_state import capture_replay, restore_replay

STATE_FILE = "training_state.json"
TENSORS_FILE = "training_state.safetensors"
COUNTERS = ("num_timesteps", "_n_updates", "_episode_num", "_n_calls", "exploration_rate")

Tensors = dict[str, npt.NDArray[np.generic]]


def capture_training(model: BaseAlgorithm, envs: TrainingEnvs) -> dict[str, bytes]:
    """The state of a training between two rollouts, as files for a checkpoint.

    Args:
        model: The model.
        envs: Its environments.

    Raises:
        CheckpointError: If the training has diverged to values that are not finite.
    """
    values: dict[str, Any] = {
        "counters": {name: getattr(model, name) for name in COUNTERS if hasattr(model, name)},
        "episode_starts": np.asarray(model._last_episode_starts).tolist(),
        "episodes": [state.to_dict() for state in envs.states],
        "generators": capture_generators(_generators(model)),
    }
    tensors: Tensors = {f"policy.{k}": array for k, array in tensors_of(model.policy).items()}
    for name, optimizer in _optimizers(model).items():
        tensors.update(capture_optimizer(name, optimizer))
    tensors.update({f"extra.{k}": t.detach().numpy().copy() for k, t in _extra(model).items()})
    values["random"], random_tensors = capture_global_generators()
    tensors.update(random_tensors)
    buffer = _replay_buffer(model)
    if buffer is not None:
        values["replay"], replay = capture_replay(buffer, envs.config.env.observation)
        tensors.update(replay)
    return {STATE_FILE: json.dumps(values).encode(), TENSORS_FILE: encode_tensors(tensors)}


def restore_training(model: BaseAlgorithm, envs: TrainingEnvs, files: Mapping[str, bytes]) -> None:
    """The inverse of `capture_training`, into a freshly built model and its environments.

    Raises:
        CheckpointError: If the checkpoint holds no training state or it does not fit.
    """
    if STATE_FILE not in files or TENSORS_FILE not in files:
        raise CheckpointError("checkpoint: holds no training state, it cannot be continued")
    tensors = decode_tensors(files[TENSORS_FILE], TENSORS_FILE)
    try:
        values = json.loads(files[STATE_FILE])
        prefix = "policy."
        weights = {k[len(prefix) :]: a for k, a in tensors.items() if k.startswith(prefix)}
        load_tensors(model.policy, weights)
        for name, optimizer in _optimizers(model).items():
            restore_optimizer(name, optimizer, tensors)
        for name, tensor in _extra(model).items():
            _fill(tensor, tensors[f"extra.{name}"])
        buffer = _replay_buffer(model)
        if buffer is not None:
            restore_replay(buffer, envs.config.env.observation, values["replay"], tensors)
        states = [EpisodeState.from_dict(state) for state in values["episodes"]]
        if len(states) != envs.num_envs:
            raise ValueError(f"it has {len(states)} environments, not {envs.num_envs}")
        model._last_obs = envs.restore(states)
        model._last_episode_starts = np.array(values["episode_starts"], dtype=np.bool_)
        for name in COUNTERS:
            if hasattr(model, name):
                setattr(model, name, _counter(name, values["counters"][name], getattr(model, name)))
        restore_generators(_generators(model), values["generators"])
        restore_global_generators(values["random"], tensors)
    except (KeyError, ValueError, TypeError, RuntimeError, IndexError) as error:
        raise CheckpointError(f"checkpoint: training state does not fit: {error}") from error


def _counter(name: str, value: object, present: int | float) -> int | float:
    """The value, if it is a number of the present one's type that counts something."""
    is_same_type = type(value) is type(present)
    if is_same_type and isinstance(value, int | float) and 0 <= value < math.inf:
        return value
    raise ValueError(f"{name} is {value!r:.50}")


def _replay_buffer(model: BaseAlgorithm) -> ReplayBuffer | None:
    buffer = getattr(model, "replay_buffer", None)
    return buffer if isinstance(buffer, ReplayBuffer) else None


def _generators(model: BaseAlgorithm) -> dict[str, np.random.Generator]:
    own: dict[str, np.random.Generator] = getattr(model, "generators", {})
    return {"action_space": model.action_space.np_random, **own}


def _optimizers(model: BaseAlgorithm) -> dict[str, torch.optim.Optimizer]:
    """The agent's own list, or else the one of its policy."""
    own: dict[str, torch.optim.Optimizer] | None = getattr(model, "optimizers", None)
    return {"optimizer": model.policy.optimizer} if own is None else own


def _extra(model: BaseAlgorithm) -> dict[str, torch.Tensor]:
    """Tensors that are learnt, but belong to no network."""
    own: dict[str, torch.Tensor] = getattr(model, "extra_tensors", {})
    return own


def _fill(tensor: torch.Tensor, array: npt.NDArray[np.generic]) -> None:
    if array.shape != tuple(tensor.shape):
        raise ValueError(f"a tensor is {list(array.shape)}, not {list(tensor.shape)}")
    with torch.no_grad():
        tensor.copy_(torch.from_numpy(np.array(array)))
