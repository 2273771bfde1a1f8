import pytest
import torch

from singulate.agents.density_ppo.cells import PushCells
from singulate.envs import PointActions
from singulate.geometry import Direction, Workspace


def test_actions_survive_the_way_there_and_back() -> None:
    cells = PushCells(16)
    actions = torch.rand(5000, 3, generator=torch.Generator().manual_seed(0)) * 2 - 1
    choice, offset = cells.from_action(actions)
    assert choice.min() >= 0 and choice.max() < 4 * 256
    assert torch.allclose(cells.to_action(choice, offset)[:, :2], actions[:, :2], atol=1e-5)


@pytest.mark.parametrize("edge", [-1.0, 1.0])
def test_every_choice_survives_with_offsets_at_its_border(edge: float) -> None:
    for num_cells in (4, 8, 16, 32):
        cells = PushCells(num_cells)
        choice = torch.arange(4 * num_cells**2)
        action = cells.to_action(choice, torch.full((len(choice), 2), edge))
        assert torch.equal(cells.from_action(action)[0], choice)


def test_cells_and_directions_mean_what_the_environment_means() -> None:
    workspace, cells = Workspace(), PushCells(16)
    encoding = PointActions(workspace)
    actions = torch.rand(200, 3, generator=torch.Generator().manual_seed(1)) * 2 - 1
    choices, offsets = cells.from_action(actions)
    for action, choice, offset in zip(actions, choices, offsets, strict=True):
        push = encoding.decode(action.numpy())
        row, col = workspace.xy_to_row_col(*push.start, 16)
        assert int(choice) == push.nearest_direction * 256 + row * 16 + col
        centre = workspace.row_col_to_xy(row, col, 16)
        half = workspace.half_length / 16
        for axis in (0, 1):
            place = (push.start[axis] - centre[axis]) / half
            assert place == pytest.approx(float(offset[axis]), abs=1e-4)


def test_the_edge_of_the_table_belongs_to_the_outer_cells() -> None:
    choice, _ = PushCells(16).from_action(torch.tensor([[1.0, 1.0, 1.0], [-1.0, -1.0, -1.0]]))
    assert choice.tolist() == [Direction.LEFT * 256 + 15, Direction.UP * 256 + 15 * 16]
