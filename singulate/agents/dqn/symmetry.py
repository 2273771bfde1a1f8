"""The eight symmetries of the square table, on images and on discrete pushes."""

import functools
import math

import numpy as np
import numpy.typing as npt

NUM_SYMMETRIES = 8


def transform_images(images: npt.NDArray[np.float32], symmetry: int) -> npt.NDArray[np.float32]:
    """Turn images by quarter turns, then mirror them.

    Args:
        images: float32 (N, H, H).
        symmetry: Counter-clockwise quarter turns, plus 4 to mirror left and right afterwards.

    Returns:
        A view, float32 (N, H, H).
    """
    turned = np.rot90(images, k=symmetry % 4, axes=(1, 2))
    return turned[:, :, ::-1] if symmetry >= 4 else turned


def action_table(num_cells: int) -> npt.NDArray[np.int64]:
    """What every discrete push becomes under every symmetry.

    Args:
        num_cells: Cells along each side of the grid.

    Returns:
        int64 (8, 4 * num_cells ** 2): the action that does on the transformed table what the
        indexed action does on the original one.
    """
    cells = np.arange(num_cells**2).reshape(1, num_cells, num_cells).astype(np.float32)
    table = np.empty((NUM_SYMMETRIES, 4 * num_cells**2), dtype=np.int64)
    for symmetry in range(NUM_SYMMETRIES):
        new_cell = np.argsort(transform_images(cells, symmetry).ravel())
        for direction in range(4):
            turned = (direction - symmetry) % 4
            new_direction = (-turned) % 4 if symmetry >= 4 else turned
            start = direction * num_cells**2
            table[symmetry, start : start + num_cells**2] = new_direction * num_cells**2 + new_cell
    return table


def symmetric_copies(images: npt.NDArray[np.float32]) -> npt.NDArray[np.float32]:
    """All symmetric copies of one image.

    Args:
        images: float32 (1, H, H).

    Returns:
        float32 (8, H, H).
    """
    return np.concatenate([transform_images(images, index) for index in range(NUM_SYMMETRIES)])


def mean_of_copies(values: npt.NDArray[np.float32]) -> npt.NDArray[np.float32]:
    """One value for each discrete push from those of all symmetric copies of its scene.

    Args:
        values: float32 (8, 4 * num_cells ** 2), in the order of `symmetric_copies`.

    Returns:
        float32 (4 * num_cells ** 2,), for the scene as it is.
    """
    table = _cached_action_table(math.isqrt(values.shape[1] // 4))
    mean: npt.NDArray[np.float32] = np.take_along_axis(values, table, axis=1).mean(axis=0)
    return mean


_cached_action_table = functools.cache(action_table)
