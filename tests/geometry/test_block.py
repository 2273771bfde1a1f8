import math
from typing import Any

import numpy as np
import pytest

from singulate.exceptions import InvalidValueError
from singulate.geometry import Block, Workspace, layout_to_dicts, parse_layout, standing_pose

WORKSPACE = Workspace()


def test_mappings_become_blocks_with_defaults() -> None:
    blocks = [{"x": 0.5, "y": -1 / 2}, {"x": 0, "y": 0, "side": 0.15, "yaw": 0.3}]
    assert parse_layout(blocks, WORKSPACE) == (Block(0.5, -0.5, 0.2, 0.0), Block(0, 0, 0.15, 0.3))


def test_blocks_are_accepted_as_they_are() -> None:
    layout = (Block(0.0, 0.0), Block(0.2, 0.0))
    assert parse_layout(layout, WORKSPACE) == layout


@pytest.mark.parametrize("seed", range(5))
def test_dicts_and_back(seed: int) -> None:
    rng = np.random.default_rng(seed)
    xs = np.arange(-0.6, 0.7, 0.4)
    layout = tuple(Block(float(x), *map(float, rng.uniform(0.1, 0.25, 2))) for x in xs)
    assert parse_layout(layout_to_dicts(layout), WORKSPACE) == layout


def test_a_block_may_stand_at_the_very_edge() -> None:
    assert len(parse_layout([{"x": 0.9, "y": -0.9}], WORKSPACE)) == 1


def test_blocks_may_touch() -> None:
    assert len(parse_layout([{"x": 0.0, "y": 0.0}, {"x": 0.2, "y": 0.1}], WORKSPACE)) == 2


@pytest.mark.parametrize(
    ("blocks", "key"),
    [
        ("here", "blocks"),
        ({"x": 0.0, "y": 0.0}, "blocks"),
        (3, "blocks"),
        ([], "blocks"),
        ([{"x": -0.9 + 0.11 * i, "y": 0.0, "side": 0.1} for i in range(17)], "blocks"),
        ([7], "blocks[0]"),
        ([{"x": 0.0, "y": 0.0, "z": 1.0}], "blocks[0]"),
        ([{"x": 0.0, "y": 0.0}, {"x": 0.5}], "blocks[1].y"),
        ([{"x": "0.5", "y": 0.0}], "blocks[0].x"),
        ([{"x": True, "y": 0.0}], "blocks[0].x"),
        ([{"x": None, "y": 0.0}], "blocks[0].x"),
        ([{"x": math.nan, "y": 0.0}], "blocks[0].x"),
        ([{"x": 10**400, "y": 0.0}], "blocks[0].x"),
        ([{"x": 0.0, "y": math.inf}], "blocks[0].y"),
        ([{"x": 0.0, "y": 0.0, "yaw": math.nan}], "blocks[0].yaw"),
        ([{"x": 0.0, "y": 0.0, "side": 0.049}], "blocks[0].side"),
        ([{"x": 0.0, "y": 0.0, "side": 0.51}], "blocks[0].side"),
        ([{"x": 0.0, "y": 0.0, "side": -0.2}], "blocks[0].side"),
        ([{"x": 0.91, "y": 0.0}], "blocks[0]"),
        ([{"x": 0.89, "y": 0.0, "yaw": math.pi / 4}], "blocks[0]"),
        (
            [{"x": 0.0, "y": 0.0}, {"x": 0.6, "y": 0.0}, {"x": 0.7, "y": 0.1}],
            "blocks[1], blocks[2]",
        ),
        ([{"x": 0.0, "y": 0.0}, {"x": 0.0, "y": 0.0}], "blocks[0], blocks[1]"),
    ],
)
def test_what_is_wrong_is_named_in_one_line(blocks: Any, key: str) -> None:
    with pytest.raises(InvalidValueError) as caught:
        parse_layout(blocks, WORKSPACE)
    assert caught.value.key == key
    assert "\n" not in str(caught.value)
    assert "allowed: " in str(caught.value)


def test_footprint() -> None:
    corners = {(round(x, 9), round(y, 9)) for x, y in Block(0.5, 0.1, 0.2).footprint}
    assert corners == {(0.6, 0.2), (0.4, 0.2), (0.4, 0.0), (0.6, 0.0)}


def test_standing_pose() -> None:
    pose = standing_pose(Block(0.1, -0.2, side=0.16, yaw=math.pi / 2))
    assert pose.position == (0.1, -0.2, 0.08)
    assert pose.quaternion == pytest.approx((0.0, 0.0, math.sqrt(0.5), math.sqrt(0.5)))
    assert pose.side == 0.16
