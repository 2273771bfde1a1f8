import numpy as np
import pytest

from singulate.agents.dqn.symmetry import (
    NUM_SYMMETRIES,
    action_table,
    mean_of_copies,
    symmetric_copies,
    transform_images,
)
from singulate.geometry import Direction


def test_a_quarter_turn_carries_start_and_direction_along() -> None:
    table = action_table(10)
    top_left_pushing_up = int(Direction.UP) * 100
    bottom_left_pushing_left = int(Direction.LEFT) * 100 + 90
    assert table[1, top_left_pushing_up] == bottom_left_pushing_left


def test_mirroring_swaps_left_and_right() -> None:
    table = action_table(10)
    top_left_pushing_right = int(Direction.RIGHT) * 100
    top_right_pushing_left = int(Direction.LEFT) * 100 + 9
    assert table[4, top_left_pushing_right] == top_right_pushing_left


@pytest.mark.parametrize("symmetry", range(NUM_SYMMETRIES))
def test_a_push_is_drawn_where_its_action_goes(symmetry: int) -> None:
    """A picture of the push, start dark and end light, turns into that of the new action."""
    cells = 10
    table = action_table(cells)
    for action in (0, 137, 245, 399):
        picture = _draw(action, cells)
        expected = _draw(int(table[symmetry, action]), cells)
        assert np.array_equal(transform_images(picture[None], symmetry)[0], expected)


@pytest.mark.parametrize("symmetry", range(NUM_SYMMETRIES))
def test_every_symmetry_permutes_the_actions(symmetry: int) -> None:
    assert sorted(action_table(10)[symmetry]) == list(range(400))


def test_values_of_symmetric_copies_are_averaged_push_by_push() -> None:
    """A network that is symmetric gives each copy the same values, moved: their mean is its own."""
    rng = np.random.default_rng(3)
    values = rng.normal(size=400).astype(np.float32)
    table = action_table(10)
    of_copies = np.empty((NUM_SYMMETRIES, 400), dtype=np.float32)
    for symmetry in range(NUM_SYMMETRIES):
        of_copies[symmetry, table[symmetry]] = values
    assert np.allclose(mean_of_copies(of_copies), values)
    of_copies[5] += 8.0
    assert np.allclose(mean_of_copies(of_copies), values + 1.0)


def test_copies_of_a_picture_are_its_eight_symmetries() -> None:
    picture = np.random.default_rng(4).normal(size=(1, 6, 6)).astype(np.float32)
    copies = symmetric_copies(picture)
    assert len({copy.tobytes() for copy in copies}) == NUM_SYMMETRIES
    assert np.array_equal(copies[1], np.rot90(picture[0]))


def _draw(action: int, cells: int) -> np.ndarray:
    direction, cell = divmod(action, cells**2)
    row, col = divmod(cell, cells)
    x, y = Direction(direction).vector
    picture = np.zeros((cells + 2, cells + 2), dtype=np.float32)
    picture[row + 1, col + 1] = 1.0
    picture[row + 1 - int(y), col + 1 + int(x)] = 2.0
    return picture
