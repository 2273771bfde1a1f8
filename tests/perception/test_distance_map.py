import math

import numpy as np
import numpy.typing as npt
import pytest

from singulate.geometry import Workspace
from singulate.perception import distance_map


def brute_force(mask: npt.NDArray[np.bool_]) -> npt.NDArray[np.float64]:
    objects = np.argwhere(mask)
    pixels = np.argwhere(np.ones_like(mask))
    closest = np.linalg.norm(pixels[:, None] - objects[None], axis=-1).min(axis=1)
    return np.where(mask, -1.0, closest.reshape(mask.shape))


def test_hand_worked_map_of_one_pixel() -> None:
    mask = np.zeros((3, 4), bool)
    mask[1, 1] = True
    r2, r5 = math.sqrt(2), math.sqrt(5)
    expected = np.array([[r2, 1, r2, r5], [1, -1, 1, 2], [r2, 1, r2, r5]])
    result = distance_map(mask)
    assert result.dtype == np.float32
    np.testing.assert_allclose(result, expected, rtol=1e-6)


def test_the_closest_of_two_objects_counts() -> None:
    mask = np.array([[True, False, False, False, False, False, True]])
    assert distance_map(mask).tolist() == [[-1, 1, 2, 3, 2, 1, -1]]


def test_far_corner_is_exact() -> None:
    mask = np.zeros((64, 64), bool)
    mask[0, 0] = True
    assert distance_map(mask)[63, 63] == pytest.approx(63 * math.sqrt(2), rel=1e-6)
    assert distance_map(mask)[30, 40] == 50.0


def test_full_mask_is_inside_everywhere() -> None:
    assert (distance_map(np.ones((5, 6), bool)) == -1.0).all()


def test_empty_mask_is_one_image_diagonal_away_everywhere() -> None:
    result = distance_map(np.zeros((64, 64), bool))
    assert result.dtype == np.float32
    assert result.shape == (64, 64)
    assert np.unique(result) == pytest.approx([90.50967], abs=1e-4)
    workspace = Workspace()
    assert result[0, 0] * workspace.metres_per_pixel == pytest.approx(workspace.diagonal, rel=1e-6)


def test_the_mask_is_left_alone() -> None:
    mask = np.eye(4, dtype=bool)
    distance_map(mask)
    assert (mask == np.eye(4, dtype=bool)).all()


@pytest.mark.parametrize("seed", range(8))
def test_equals_brute_force(seed: int) -> None:
    rng = np.random.default_rng(seed)
    mask = rng.random((17, 23)) < rng.choice([0.01, 0.1, 0.5])
    mask[rng.integers(17), rng.integers(23)] = True
    np.testing.assert_array_equal(distance_map(mask), brute_force(mask).astype(np.float32))


@pytest.mark.parametrize("seed", range(4))
def test_turns_with_the_picture(seed: int) -> None:
    mask = np.random.default_rng(seed).random((20, 20)) < 0.05
    np.testing.assert_array_equal(distance_map(np.rot90(mask).copy()), np.rot90(distance_map(mask)))


def test_the_same_mask_gives_the_same_bits_wherever_it_lies_in_memory() -> None:
    rng = np.random.default_rng(0)
    mask = rng.random((64, 64)) < 0.01
    expected = distance_map(mask).tobytes()
    clutter = []
    for offset in range(40):
        memory = np.zeros(64 * 64 + offset, bool)
        memory[offset:] = mask.ravel()
        clutter.append(np.empty(1 + 37 * offset, np.float32))
        assert distance_map(memory[offset:].reshape(64, 64)).tobytes() == expected
