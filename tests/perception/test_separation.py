import math
from itertools import combinations

import numpy as np
import numpy.typing as npt
import pytest

from singulate.geometry import Workspace
from singulate.perception import label_segments, segment_separations


def brute_force(labels: npt.NDArray[np.int32], metres_per_pixel: float) -> list[float]:
    pixels = [np.argwhere(labels == k) for k in range(1, labels.max() + 1)]
    return [
        (np.linalg.norm(a[:, None] - b[None], axis=-1).min() - 1.0) * metres_per_pixel
        for a, b in combinations(pixels, 2)
    ]


def squares(*corners: tuple[int, int], side: int = 6) -> npt.NDArray[np.int32]:
    mask = np.zeros((64, 64), bool)
    for row, col in corners:
        mask[row : row + side, col : col + side] = True
    return label_segments(mask)


@pytest.mark.parametrize("gap", [1, 2, 3, 4, 20])
@pytest.mark.parametrize("is_transposed", [False, True])
def test_k_background_pixels_between_facing_edges_are_k_pixels(
    gap: int, is_transposed: bool
) -> None:
    labels = squares((10, 5), (10, 11 + gap))
    labels = labels.T.copy() if is_transposed else labels
    assert segment_separations(labels, 0.03125) == pytest.approx([gap * 0.03125], abs=1e-15)


def test_edges_that_face_each_other_only_partly_give_the_same_gap() -> None:
    assert segment_separations(squares((10, 5), (15, 14)), 1.0).tolist() == [3.0]


def test_diagonal_neighbours_are_measured_from_corner_to_corner() -> None:
    # Corner pixels (15, 10) and (18, 14): 3 rows and 4 columns apart, 5 px from centre to centre.
    assert segment_separations(squares((10, 5), (18, 14)), 0.5).tolist() == [2.0]


def test_corners_that_touch() -> None:
    expected = pytest.approx([math.sqrt(2) - 1])
    assert segment_separations(np.array([[1, 0], [0, 2]]), 1.0) == expected


def test_segments_that_share_an_edge_have_separation_0() -> None:
    assert segment_separations(np.array([[1, 1, 2, 2]]), 1.0).tolist() == [0.0]


def test_pairs_come_in_order() -> None:
    # Columns 0, 2, 5 and 9: gaps of 1, 2 and 3 px between neighbours.
    labels = np.array([[1, 0, 2, 0, 0, 3, 0, 0, 0, 4]])
    assert segment_separations(labels, 1.0).tolist() == [1.0, 4.0, 8.0, 2.0, 6.0, 3.0]


def test_numbers_of_segments_need_not_be_consecutive() -> None:
    assert segment_separations(np.array([[7, 0, 3, 0, 0, 9]]), 1.0).tolist() == [1.0, 2.0, 4.0]
    assert segment_separations(np.array([[0, 5, 5]]), 1.0).shape == (0,)


@pytest.mark.parametrize("corners", [(), ((10, 10),)])
def test_no_pair_no_separation(corners: tuple[tuple[int, int], ...]) -> None:
    result = segment_separations(squares(*corners), 1.0)
    assert result.shape == (0,)
    assert result.dtype == np.float64


def test_segments_at_opposite_borders_do_not_wrap_around() -> None:
    labels = np.zeros((8, 8), np.int32)
    labels[:, 0] = 1
    labels[:, 7] = 2
    assert segment_separations(labels, 1.0).tolist() == [6.0]


def test_a_segment_inside_a_ring() -> None:
    labels = np.zeros((9, 9), np.int32)
    labels[[0, 8], :] = labels[:, [0, 8]] = 1
    labels[3:6, 3:6] = 2
    assert segment_separations(labels, 1.0).tolist() == [2.0]


def test_the_goal_of_0_1_m_needs_4_pixels_of_background() -> None:
    size = Workspace().metres_per_pixel
    assert segment_separations(squares((10, 5), (10, 14)), size)[0] < 0.1
    assert segment_separations(squares((10, 5), (10, 15)), size)[0] >= 0.1


@pytest.mark.parametrize("seed", range(10))
def test_equals_brute_force(seed: int) -> None:
    rng = np.random.default_rng(seed)
    mask = np.zeros((40, 48), bool)
    for _ in range(rng.integers(2, 11)):
        row, col = rng.integers(0, 40), rng.integers(0, 48)
        mask[row : row + rng.integers(1, 9), col : col + rng.integers(1, 9)] = True
    labels = label_segments(mask)
    result = segment_separations(labels, 0.03)
    np.testing.assert_allclose(result, brute_force(labels, 0.03), atol=1e-12)


@pytest.mark.parametrize("seed", range(3))
def test_equals_brute_force_on_speckle(seed: int) -> None:
    labels = label_segments(np.random.default_rng(seed).random((16, 16)) < 0.3)
    assert labels.max() > 20
    np.testing.assert_allclose(segment_separations(labels, 1.0), brute_force(labels, 1.0))
