"""Every shortcut against the plain push, and the plain push against itself 1 mm further back.

Where a push ends is sensitive: a start 1 mm further back moves the blocks by centimetres now and
then. A shortcut is as good as the plain push as long as it differs from it by no more than that.
"""

from collections.abc import Callable, Sequence

import numpy as np

from singulate.envs.push_task import PushTask
from singulate.exceptions import SimulationError
from singulate.experiments.agreement import Agreement, displacement, started_further_back
from singulate.geometry import Direction, Poses, Push, standing_pose
from singulate.rewardmap.plain_pushes import cell_push
from singulate.rewardmap.prober import Prober
from singulate.rewardmap.reach import blocked_starts, reaching_starts
from singulate.rewardmap.shared_trajectories import split_into_lines
from singulate.rewards import make_reward
from singulate.simulation import make_scenario

PUSH_SCENARIOS = ("random-2", "random-3", "cluster-4")
MAP_RESOLUTION = 64
GOAL_SEPARATION = 0.1

Report = dict[str, dict[str, object]]
OnProgress = Callable[[], None]


def compare_pushes(
    num_pushes: int, rng: np.random.Generator, on_progress: OnProgress = lambda: None
) -> Report:
    """Random touching pushes of an environment, without and with the free approach simulated.

    Args:
        num_pushes: Pushes, divided among `PUSH_SCENARIOS`.
        rng: Draws scenes and pushes.
        on_progress: Called after each push.

    Returns:
        `Agreement.summary` of ``fast`` and of ``yardstick``, both against the plain push.
    """
    agreements = {"fast": Agreement(), "yardstick": Agreement()}
    plain, fast = PushTask(exact=True), PushTask()
    for i in range(num_pushes):
        scenario = PUSH_SCENARIOS[i % len(PUSH_SCENARIOS)]
        plain.place(make_scenario(scenario).sample(rng, plain.workspace))
        poses, push = plain.scene.poses, _touching_push(plain, rng)
        expected = _end(plain, poses, push)
        others = {
            "fast": _end(fast, poses, push),
            "yardstick": _end(plain, poses, started_further_back(push)),
        }
        for name, other in others.items():
            agreements[name].add(
                displacement(expected[0], other[0]),
                abs(expected[1] - other[1]),
                expected[2] == other[2],
            )
        on_progress()
    plain.close()
    fast.close()
    return {name: agreement.summary() for name, agreement in agreements.items()}


def compare_maps(
    num_scenes: int,
    rng: np.random.Generator,
    scenario: str = "random-3",
    num_lines: int = 10,
    on_progress: OnProgress = lambda: None,
) -> Report:
    """Rewards on lines of the 64 x 64 map by shared trajectories and by plain pushes.

    Args:
        num_scenes: Scenes.
        rng: Draws scenes and lines.
        scenario: Their recipe.
        num_lines: Lines of starts that are drawn from each scene's map.
        on_progress: Called after each scene.

    Returns:
        `Agreement.summary` of ``shared`` and of ``yardstick``, both against the plain push;
        without displacements, since a map holds rewards alone.
    """
    agreements = {"shared": Agreement(), "yardstick": Agreement()}
    prober, plain = Prober(GOAL_SEPARATION), Prober(GOAL_SEPARATION, exact=True)
    for _ in range(num_scenes):
        layout = make_scenario(scenario).sample(rng, prober.workspace)
        poses = tuple(standing_pose(block) for block in layout)
        lines = _some_lines(prober, poses, num_lines, rng)
        pushes = [push for line in lines for push in line]
        expected = [plain.try_push(poses, push) for push in pushes]
        others = {
            "shared": prober.try_lines(poses, lines),
            "yardstick": [plain.try_push(poses, started_further_back(push)) for push in pushes],
        }
        for name, terms in others.items():
            _compare_terms(agreements[name], expected, terms)
        on_progress()
    prober.close()
    plain.close()
    return {name: agreement.summary() for name, agreement in agreements.items()}


def _touching_push(task: PushTask, rng: np.random.Generator) -> Push:
    """A uniformly random push that meets a block, also when it starts a little further back."""
    half, length = task.workspace.half_length, task.workspace.push_length
    while True:
        start = (float(rng.uniform(-half, half)), float(rng.uniform(-half, half)))
        push = Push.cardinal(start, Direction(int(rng.integers(4))), length)
        is_free = not any(map(task.scene.is_blocked, (push, started_further_back(push))))
        if is_free and task.scene.touches(push):
            return push


def _end(task: PushTask, poses: Poses, push: Push) -> tuple[Poses, float, bool]:
    """Poses, reward and success after a push; as before it where the physics goes wrong."""
    task.restore(poses)
    try:
        result = task.execute(push)
    except SimulationError:
        return poses, 0.0, False
    return task.scene.poses, make_reward("paper").total(result.terms, 0), result.is_success


def _some_lines(
    prober: Prober, poses: Poses, num_lines: int, rng: np.random.Generator
) -> list[list[Push]]:
    grid = (poses, prober.workspace, MAP_RESOLUTION, prober.pusher_side)
    lines = split_into_lines(reaching_starts(*grid) & ~blocked_starts(*grid))
    drawn = rng.permutation(len(lines))[:num_lines]
    return [[cell_push(prober.workspace, MAP_RESOLUTION, int(c)) for c in lines[i]] for i in drawn]


def _compare_terms(
    agreement: Agreement,
    expected: Sequence[dict[str, float]],
    found: Sequence[dict[str, float]],
) -> None:
    reward = make_reward("paper")
    for one, other in zip(expected, found, strict=True):
        error = abs(reward.total(one, 0) - reward.total(other, 0))
        agreement.reward_errors.append(error)
        agreement.num_same_success += one["success"] == other["success"]
