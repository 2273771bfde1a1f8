import pytest
import torch

from singulate.agents.multimodal_ppo.cells import PushCells
from singulate.agents.multimodal_ppo.centre import centre_of_density
from singulate.agents.multimodal_ppo.distribution import PushDistribution
from singulate.geometry import Direction

CELLS = PushCells(32)


def _distribution(*masses: dict[tuple[int, int, int], float]) -> PushDistribution:
    """Distributions with all their mass in few (direction, row, col)."""
    logits = torch.full((len(masses), 4096), -30.0)
    for index, mass in enumerate(masses):
        for (direction, row, col), share in mass.items():
            logits[index, direction * 1024 + row * 32 + col] = torch.log(torch.tensor(share))
    shape = (len(masses), 2, 4096)
    location, scale = torch.zeros(shape), torch.full(shape, 0.3)
    return PushDistribution(CELLS).proba_distribution(logits, location, scale)


def _middle(row: float, col: float) -> tuple[float, float]:
    return (2 * col + 1) / 32 - 1, 1 - (2 * row + 1) / 32


def test_a_single_cell_is_its_own_centre() -> None:
    action = centre_of_density(_distribution({(Direction.DOWN, 7, 20): 1.0}))[0]
    assert action[:2].tolist() == pytest.approx(_middle(7, 20), abs=1e-3)
    assert float(action[2]) == pytest.approx(0.25)


def test_a_region_beats_a_lonely_peak_and_is_hit_in_its_middle() -> None:
    region = {(Direction.LEFT, row, col): 0.1 for row in (10, 11) for col in (4, 5, 6)}
    peak = {(Direction.UP, 25, 25): 0.3}
    distribution = _distribution(region | peak)
    highest, _ = CELLS.from_action(distribution.mode())
    assert int(highest) // 1024 == Direction.UP
    action = centre_of_density(distribution)[0]
    assert action[:2].tolist() == pytest.approx(_middle(10.5, 5), abs=5e-3)
    assert float(action[2]) == pytest.approx(0.75)


def test_directions_do_not_mix() -> None:
    """Two half as heavy neighbours of different directions are no region."""
    neighbours = {(Direction.UP, 10, 10): 0.3, (Direction.DOWN, 10, 11): 0.3}
    action = centre_of_density(_distribution(neighbours | {(Direction.RIGHT, 20, 20): 0.4}))[0]
    assert action[:2].tolist() == pytest.approx(_middle(20, 20), abs=1e-3)


def test_a_batch_is_as_one_by_one_also_at_the_edge_of_the_table() -> None:
    masses = [
        {(Direction.UP, 31, 0): 0.6, (Direction.UP, 31, 1): 0.4},
        {(Direction.LEFT, 0, 31): 1.0},
    ]
    both = centre_of_density(_distribution(*masses))
    alone = torch.cat([centre_of_density(_distribution(mass)) for mass in masses])
    assert torch.allclose(both, alone, atol=1e-5)
    assert both.abs().max() <= 1.0
