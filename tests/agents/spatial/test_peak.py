import numpy as np
import pytest

from singulate.agents.spatial.peak import find_peak


def test_the_top_is_found_between_the_pixels() -> None:
    row, column = np.mgrid[:20, :24]
    values = (1.0 - 0.01 * (row - 7.3) ** 2 - 0.02 * (column - 15.4) ** 2).astype(np.float32)
    peak = find_peak(values)
    assert (peak.row, peak.column) == pytest.approx((7.3, 15.4), abs=1e-3)
    assert peak.value == pytest.approx(1.0, abs=0.03)


def test_the_middle_of_good_starts_beats_their_edge_and_a_lone_one() -> None:
    values = np.zeros((20, 20), dtype=np.float32)
    values[8:13, 8:13] = 1.0
    values[3, 3] = 1.2
    peak = find_peak(values)
    assert (peak.row, peak.column) == pytest.approx((10.0, 10.0), abs=0.5)


def test_a_top_on_the_border_stays_there() -> None:
    values = np.linspace(1.0, 0.0, 64, dtype=np.float32).reshape(8, 8)
    assert find_peak(values)[:2] == (0.0, 0.0)
