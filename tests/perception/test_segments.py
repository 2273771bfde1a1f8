import math

import numpy as np
import numpy.typing as npt
import pytest

from singulate.geometry import Block, Workspace
from singulate.perception import label_segments


def footprint_mask(block: Block, workspace: Workspace) -> npt.NDArray[np.bool_]:
    """Pixels whose centre lies in a block's footprint."""
    offset = workspace.cell_centres() - (block.x, block.y)
    cos, sin = math.cos(block.yaw), math.sin(block.yaw)
    along = offset @ np.array([[cos, -sin], [sin, cos]])
    return np.asarray(np.abs(along).max(axis=-1) <= block.side / 2)


def flood_fill(mask: npt.NDArray[np.bool_]) -> npt.NDArray[np.int32]:
    labels = np.zeros(mask.shape, np.int32)
    count = 0
    for seed in map(tuple, np.argwhere(mask)):
        if labels[seed]:
            continue
        count += 1
        stack = [seed]
        while stack:
            row, col = stack.pop()
            inside = 0 <= row < mask.shape[0] and 0 <= col < mask.shape[1]
            if inside and mask[row, col] and not labels[row, col]:
                labels[row, col] = count
                stack += [(row + 1, col), (row - 1, col), (row, col + 1), (row, col - 1)]
    return labels


def test_two_separate_segments() -> None:
    labels = label_segments(np.array([[1, 1, 0, 1], [0, 0, 0, 1]], bool))
    assert labels.dtype == np.int32
    assert labels.tolist() == [[1, 1, 0, 2], [0, 0, 0, 2]]


def test_segments_that_meet_at_a_corner_are_apart() -> None:
    assert label_segments(np.array([[1, 0], [0, 1]], bool)).tolist() == [[1, 0], [0, 2]]


def test_segments_that_share_one_edge_are_one() -> None:
    assert label_segments(np.array([[1, 1, 0], [0, 1, 1]], bool)).tolist() == [[1, 1, 0], [0, 1, 1]]


def test_arms_that_join_later_get_the_first_number() -> None:
    u_shape = np.array([[1, 0, 1, 0, 1], [1, 1, 1, 0, 1]], bool)
    assert label_segments(u_shape).tolist() == [[1, 0, 1, 0, 2], [1, 1, 1, 0, 2]]


def test_no_objects_and_nothing_but_object() -> None:
    assert label_segments(np.zeros((3, 3), bool)).max() == 0
    assert (label_segments(np.ones((3, 3), bool)) == 1).all()


@pytest.mark.parametrize("seed", range(12))
def test_equals_flood_fill_in_reading_order(seed: int) -> None:
    rng = np.random.default_rng(seed)
    mask = rng.random((64, 64)) < rng.uniform(0.05, 0.7)
    np.testing.assert_array_equal(label_segments(mask), flood_fill(mask))


def test_a_single_block_is_one_segment_however_it_is_turned() -> None:
    rng = np.random.default_rng(3)
    workspace = Workspace()
    for _ in range(300):
        x, y = rng.uniform(-0.7, 0.7, 2)
        block = Block(x, y, rng.uniform(0.15, 0.25), rng.uniform(0.0, math.pi / 2))
        mask = footprint_mask(block, workspace)
        assert mask.sum() * workspace.metres_per_pixel**2 == pytest.approx(block.side**2, rel=0.25)
        assert label_segments(mask).max() == 1
