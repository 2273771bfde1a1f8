import numpy as np
import pytest

from singulate.geometry import CameraFrame, Direction, Push, Workspace
from singulate.perception import Percept, perceive
from singulate.rewards import TERMS, Transition, make_reward, reward_terms

WORKSPACE = Workspace()


def seen(*corners: tuple[int, int]) -> Percept:
    depth = np.full((64, 64), 3.0, np.float32)
    for row, col in corners:
        depth[row : row + 6, col : col + 6] = 2.8
    return perceive(CameraFrame(np.zeros((64, 64, 3), np.uint8), depth, 3.0), WORKSPACE)


def transition(before: Percept, after: Percept, row_col: tuple[int, int]) -> Transition:
    push = Push.cardinal(WORKSPACE.row_col_to_xy(*row_col), Direction.UP, WORKSPACE.push_length)
    return Transition(before, push, after, False, 2, 0.1, WORKSPACE)


TOUCHING = seen((20, 20), (20, 26))
CLOSE = seen((20, 20), (20, 28))  # 2 px apart: 0.0625 m
APART = seen((20, 20), (20, 36))  # 10 px apart: 0.3125 m


def test_names_in_the_order_of_equation_7() -> None:
    assert TERMS == ("start", "distance", "inside", "success")
    assert tuple(reward_terms(transition(TOUCHING, APART, (32, 22)))) == TERMS


def test_a_push_that_singulates() -> None:
    terms = reward_terms(transition(TOUCHING, APART, (32, 22)))
    # 7 px below the block: 0.21875 m, r_Start = 0.215218 / 0.21875 - 0.076091.
    expected = {"start": 0.907763, "distance": 0.1, "inside": 0.0, "success": 1.0}
    assert terms == pytest.approx(expected, abs=1e-5)
    assert make_reward("paper").total(terms) == pytest.approx(272.329 + 100.0 + 1000.0, abs=1e-2)


def test_a_push_that_brings_blocks_together() -> None:
    terms = reward_terms(transition(CLOSE, TOUCHING, (63, 63)))
    assert terms["distance"] == pytest.approx(-0.0625)
    assert terms["success"] == 0.0


def test_the_start_is_judged_by_the_picture_before_the_push() -> None:
    over_the_block_before = transition(seen((20, 20)), seen((40, 40)), (22, 22))
    over_the_block_after = transition(seen((40, 40)), seen((20, 20)), (22, 22))
    assert reward_terms(over_the_block_before)["start"] == 0.0
    assert reward_terms(over_the_block_after)["start"] > 0.1


def test_inside_is_what_the_caller_says() -> None:
    blocked = transition(APART, APART, (22, 22))._replace(is_inside=True)
    assert reward_terms(blocked)["inside"] == 1.0
    assert reward_terms(transition(APART, APART, (22, 22)))["inside"] == 0.0


def test_the_goal_decides_success_and_truncation() -> None:
    strict = transition(TOUCHING, APART, (32, 22))._replace(goal_separation=0.32)
    terms = reward_terms(strict)
    assert terms["distance"] == pytest.approx(0.3125)
    assert terms["success"] == 0.0


def test_a_missing_block_is_no_success() -> None:
    three = transition(TOUCHING, APART, (32, 22))._replace(num_blocks=3)
    assert reward_terms(three)["success"] == 0.0
