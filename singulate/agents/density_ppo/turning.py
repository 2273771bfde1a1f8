"""The four push directions as one: images turned until the push points up, and answers turned back.

What a push does depends on where the blocks are relative to its direction alone (the camera looks
down at a square table), so one network serves all four directions.
"""

import torch

NUM_DIRECTIONS = 4


def turn_images(images: torch.Tensor) -> torch.Tensor:
    """Turn images so that each direction in turn points up.

    Args:
        images: (batch, C, H, H), row 0 at +y.

    Returns:
        (batch, 4, C, H, H): for up, right, down, left.
    """
    turned = [torch.rot90(images, direction, (2, 3)) for direction in range(NUM_DIRECTIONS)]
    return torch.stack(turned, dim=1)


def turn_back(maps: torch.Tensor) -> torch.Tensor:
    """Turn maps of numbers back: the inverse of `turn_images`.

    Args:
        maps: (batch, 4, C, H, H), one for each direction, as seen with it pointing up.

    Returns:
        (batch, 4, C, H, H), as seen on the table.
    """
    turned = [torch.rot90(maps[:, d], -d, (2, 3)) for d in range(NUM_DIRECTIONS)]
    return torch.stack(turned, dim=1)


def vectors_to_table(vectors: torch.Tensor, direction: torch.Tensor) -> torch.Tensor:
    """Turn vectors (right, up), as seen with a direction pointing up, into (x, y) on the table.

    Args:
        vectors: (..., 2).
        direction: int64 (...), 0 to 3 for up, right, down, left: so many clockwise quarter turns.
    """
    right, up = vectors.unbind(-1)
    x = _choose(direction, right, up, -right, -up)
    y = _choose(direction, up, -right, -up, right)
    return torch.stack([x, y], dim=-1)


def sizes_to_table(sizes: torch.Tensor, direction: torch.Tensor) -> torch.Tensor:
    """As `vectors_to_table`, for lengths along both axes, which have no sign; (..., 2)."""
    return torch.where((direction % 2 == 1).unsqueeze(-1), sizes.flip(-1), sizes)


def _choose(direction: torch.Tensor, *values: torch.Tensor) -> torch.Tensor:
    stacked = torch.stack(values, dim=-1)
    return stacked.gather(-1, direction.unsqueeze(-1)).squeeze(-1)
