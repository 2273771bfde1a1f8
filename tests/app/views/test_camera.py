"""The camera always sees the whole table, and as large as possible."""

import math

import numpy as np
import pytest

from app.views.camera import FIELD_OF_VIEW, FILL, CameraPose, tilted_view, top_view
from app.views.table import MARGIN
from singulate.geometry import Workspace


def picture_reach(pose: CameraPose, aspect: float) -> tuple[float, float]:
    """How far the table's corners reach to the side and up or down, 1 being the edge."""
    position, target = np.array(pose.position), np.array(pose.look_at)
    forward = (target - position) / np.linalg.norm(target - position)
    right = np.cross(forward, [0.0, 0.0, 1.0])
    right /= np.linalg.norm(right)
    up = np.cross(right, forward)
    reach = Workspace().half_length + MARGIN
    sides, heights = [], []
    for x in (-reach, reach):
        for y in (-reach, reach):
            offset = np.array([x, y, 0.0]) - position
            scale = (offset @ forward) * math.tan(FIELD_OF_VIEW / 2)
            sides.append(abs(offset @ right) / scale / aspect)
            heights.append(abs(offset @ up) / scale)
    return max(sides), max(heights)


@pytest.mark.parametrize("aspect", [0.4, 0.9, 1.0, 16 / 9, 3.0])
@pytest.mark.parametrize("view", [tilted_view, top_view])
def test_the_table_fills_the_picture_and_no_more(view: object, aspect: float) -> None:
    assert callable(view)
    reach = picture_reach(view(Workspace(), aspect), aspect)
    assert max(reach) == pytest.approx(FILL, abs=0.005)


def test_the_top_view_looks_straight_down_with_y_up() -> None:
    pose = top_view(Workspace(), 1.0)
    assert pose.position[:2] == pytest.approx((0.0, 0.0), abs=0.02)
    assert pose.position[1] < pose.look_at[1]
