"""How close an object is, as a network sees it."""

import torch

HALF_CLOSE_PX = 6.4
"""Distance at which an object is half close: 0.2 m, where r_Start peaks (Eq. 4)."""


def closeness(images: torch.Tensor) -> torch.Tensor:
    """Closeness to an object, 1 at it and inside, 0 far away.

    Args:
        images: Distances of any shape [px], -1 inside.
    """
    return HALF_CLOSE_PX / (images.clamp(min=0.0) + HALF_CLOSE_PX)
