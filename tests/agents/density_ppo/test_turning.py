import pytest
import torch

from singulate.agents.density_ppo.turning import (
    sizes_to_table,
    turn_back,
    turn_images,
    vectors_to_table,
)
from singulate.geometry import Direction, Workspace


def test_turning_back_undoes_turning() -> None:
    images = torch.rand(3, 2, 8, 8)
    turned_back = turn_back(turn_images(images))
    assert torch.equal(turned_back, images[:, None].expand(-1, 4, -1, -1, -1))


@pytest.mark.parametrize("direction", list(Direction))
def test_each_direction_points_up_after_its_turn(direction: Direction) -> None:
    """A mark ahead of the middle, seen from the push, lies above the middle afterwards."""
    workspace = Workspace()
    image = torch.zeros(64, 64)
    x, y = direction.vector
    row, col = workspace.xy_to_row_col(0.5 * x + 0.01, 0.5 * y + 0.01)
    image[row, col] = 1.0
    turned = turn_images(image[None, None])[0, direction, 0]
    row, col = divmod(int(turned.argmax()), 64)
    assert workspace.row_col_to_xy(row, col)[1] == pytest.approx(0.5, abs=0.05)
    assert workspace.row_col_to_xy(row, col)[0] == pytest.approx(0.0, abs=0.05)


@pytest.mark.parametrize("direction", list(Direction))
def test_up_becomes_the_direction_and_right_its_right(direction: Direction) -> None:
    x, y = direction.vector
    there = torch.tensor(int(direction))
    assert vectors_to_table(torch.tensor([0.0, 1.0]), there).tolist() == [x, y]
    assert vectors_to_table(torch.tensor([1.0, 0.0]), there).tolist() == [y, -x]


def test_sizes_swap_for_sideways_directions() -> None:
    sizes = torch.tensor([[1.0, 2.0]] * 4)
    assert sizes_to_table(sizes, torch.arange(4)).tolist() == [[1, 2], [2, 1], [1, 2], [2, 1]]
