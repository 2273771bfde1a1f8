"""A replay memory for saving: each observation as the mask that it was made from."""

import math
from collections.abc import Mapping
from typing import Any

import numpy as np
import numpy.typing as npt
from stable_baselines3.common.buffers import ReplayBuffer

from singulate.perception import distance_map

FloatMaps = npt.NDArray[np.float32]
Tensors = dict[str, npt.NDArray[np.generic]]

PLAIN_ARRAYS = ("actions", "rewards", "dones", "timeouts")
IMAGE_ARRAYS = ("observations", "next_observations")


def capture_replay(buffer: ReplayBuffer, observation: str) -> tuple[dict[str, Any], Tensors]:
    """A replay memory as plain values and small arrays.

    A distance map is a pure function of its mask, so 512 bytes stand for its 16 KiB, exactly.

    Args:
        buffer: The memory.
        observation: Name of the observation in it.
    """
    size = buffer.size()
    tensors: Tensors = {f"replay.{name}": getattr(buffer, name)[:size] for name in PLAIN_ARRAYS}
    for name in IMAGE_ARRAYS:
        images = getattr(buffer, name)[:size].reshape(-1, *buffer.obs_shape)
        tensors[f"replay.{name}"] = pack_observations(images, observation)
    return {"position": buffer.pos, "full": buffer.full}, tensors


def restore_replay(
    buffer: ReplayBuffer,
    observation: str,
    values: Mapping[str, Any],
    tensors: Mapping[str, npt.NDArray[np.generic]],
) -> None:
    """The inverse of `capture_replay`, in place."""
    buffer.pos, buffer.full = int(values["position"]), bool(values["full"])
    size = buffer.size()
    for name in PLAIN_ARRAYS:
        getattr(buffer, name)[:size] = tensors[f"replay.{name}"]
    for name in IMAGE_ARRAYS:
        shape = buffer.obs_shape
        packed = tensors[f"replay.{name}"]
        images = unpack_observations(packed, shape, observation)
        getattr(buffer, name)[:size] = images.reshape(size, buffer.n_envs, *shape)


def pack_observations(images: FloatMaps, observation: str) -> npt.NDArray[np.uint8]:
    """Observations (N, H, W) as bits of their masks, uint8 (N, H * W / 8)."""
    masks = images < 0.0 if observation == "distance_map" else images > 0.5
    return np.packbits(masks.reshape(len(masks), math.prod(masks.shape[1:])), axis=1)


def unpack_observations(
    packed: npt.NDArray[Any], shape: tuple[int, ...], observation: str
) -> FloatMaps:
    """The inverse of `pack_observations`, float32 (N, H, W)."""
    height, width = shape
    bits = np.unpackbits(packed.astype(np.uint8), axis=1, count=height * width)
    masks = bits.reshape(-1, height, width).astype(np.bool_)
    if observation != "distance_map":
        return masks.astype(np.float32)
    images = np.empty(masks.shape, dtype=np.float32)
    for image, mask in zip(images, masks, strict=True):
        image[:] = distance_map(mask)
    return images
