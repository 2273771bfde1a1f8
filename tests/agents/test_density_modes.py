import numpy as np
import numpy.typing as npt
import pytest

from singulate.agents.density_modes import density_modes


def _bumps(*peaks: tuple[int, int, float], width: float = 3.0) -> npt.NDArray[np.float32]:
    rows, cols = np.mgrid[0:64, 0:64]
    total = np.zeros((64, 64))
    for row, col, height in peaks:
        squared = (rows - row) ** 2 + (cols - col) ** 2
        total += height * np.exp(-squared / (2 * width**2))
    return (total / total.sum()).astype(np.float32)


@pytest.mark.parametrize("count", [1, 2, 3, 4])
def test_separate_bumps_are_counted_where_they_are(count: int) -> None:
    places = [(15, 15, 1.0), (15, 50, 0.9), (50, 15, 0.8), (50, 50, 0.7)][:count]
    modes = density_modes(_bumps(*places))
    assert [(mode.row, mode.col) for mode in modes] == [place[:2] for place in places]


def test_bumps_that_merge_are_one_mode() -> None:
    assert len(density_modes(_bumps((30, 30, 1.0), (30, 34, 1.0)))) == 1


def test_low_bumps_count_only_if_asked() -> None:
    density = _bumps((15, 15, 1.0), (50, 50, 0.05))
    assert len(density_modes(density)) == 1
    assert len(density_modes(density, min_prominence=0.01)) == 2


def test_prominence_is_measured_from_the_saddle() -> None:
    density = np.zeros((1, 7), dtype=np.float32)
    density[0] = [0, 8, 5, 6, 1, 3, 0]
    modes = density_modes(density, smoothing_px=0.0)
    assert [(mode.col, mode.height, mode.prominence) for mode in modes] == [
        (1, 8.0, 8.0), (5, 3.0, 2.0), (3, 6.0, 1.0),
    ]  # fmt: skip
    assert len(density_modes(density, smoothing_px=0.0, min_prominence=0.2)) == 2


def test_a_ring_without_ripples_and_a_plateau_count_once() -> None:
    rows, cols = np.mgrid[0:64, 0:64]
    radius = np.hypot(rows - 31.5, cols - 31.5)
    ring = np.exp(-((radius - 15) ** 2) / 8).astype(np.float32)
    assert len(density_modes(ring)) == 1
    assert len(density_modes(np.ones((64, 64), dtype=np.float32), smoothing_px=0.0)) == 1


def test_nothing_has_no_modes() -> None:
    assert density_modes(np.zeros((64, 64), dtype=np.float32)) == []


def test_a_bump_at_the_border_counts() -> None:
    modes = density_modes(_bumps((0, 63, 1.0), (63, 0, 1.0)))
    assert {(mode.row, mode.col) for mode in modes} == {(0, 63), (63, 0)}
