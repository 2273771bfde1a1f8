"""What a policy is shown: checked once, whichever agent it is for."""

import numpy as np
import numpy.typing as npt
import torch

from singulate.exceptions import InvalidValueError


def checked_observation(observation: object, image_size: int) -> npt.NDArray[np.float32]:
    """One observation as float32 (H, H).

    Args:
        observation: What an environment gave, numbers of any type.
        image_size: H [px].

    Raises:
        InvalidValueError: If it is of another shape, or not all of it is finite.
    """
    allowed = f"one image ({image_size}, {image_size}) of finite numbers"
    try:
        image = np.asarray(observation, dtype=np.float32)
    except (TypeError, ValueError):
        raise InvalidValueError("observation", type(observation).__name__, allowed) from None
    if image.shape != (image_size, image_size):
        raise InvalidValueError("observation", f"shape {image.shape}", allowed)
    if not np.isfinite(image).all():
        raise InvalidValueError("observation", "not finite", allowed)
    return image


def batch_of_one(observation: object, image_size: int) -> torch.Tensor:
    """`checked_observation` as a batch, float32 (1, H, H).

    Raises:
        InvalidValueError: As there.
    """
    return torch.as_tensor(checked_observation(observation, image_size)[None])
