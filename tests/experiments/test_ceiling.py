import json
from collections.abc import Iterator

import pytest

from singulate.cli import main
from singulate.engine import LocalEngine
from singulate.envs import PushEnv, scene_seed
from singulate.experiments.ceiling import (
    CeilingConfig,
    evaluation_poses,
    measure_ceiling,
    winning_push,
)
from singulate.rewardmap.plain_pushes import cell_push
from singulate.rewardmap.prober import Prober


@pytest.fixture(scope="module")
def prober() -> Iterator[Prober]:
    tool = Prober(0.1)
    yield tool
    tool.close()


def test_scenes_are_those_of_an_evaluation() -> None:
    env = PushEnv(None, scenario="random-3")
    for index in range(3):
        _, info = env.reset(seed=scene_seed("evaluation", 5, index))
        assert evaluation_poses(CeilingConfig("random-3", seed=5), index) == info["poses"]
    env.close()


@pytest.mark.parametrize("index", [0, 1, 2])
def test_a_winning_push_wins_in_the_environment(index: int, prober: Prober) -> None:
    config = CeilingConfig("random-2", seed=3)
    push = winning_push(prober, evaluation_poses(config, index), 16)
    assert push is not None
    env = PushEnv(None, scenario="random-2")
    env.reset(seed=scene_seed("evaluation", 3, index))
    assert env.task.execute(push).is_success
    env.close()


def test_no_push_is_missed_that_plain_pushes_find(prober: Prober) -> None:
    config = CeilingConfig("random-3", grid=6, seed=1)
    for index in range(4):
        poses = evaluation_poses(config, index)
        pushes = [cell_push(prober.workspace, 6, cell) for cell in range(4 * 36)]
        is_solvable = any(prober.try_push(poses, push)["success"] > 0.0 for push in pushes)
        assert (winning_push(prober, poses, 6) is not None) == is_solvable


def test_the_share_does_not_depend_on_the_workers_and_coarse_grids_solve_less() -> None:
    shares = {}
    for num_workers in (1, 2):
        with LocalEngine(num_workers=num_workers) as engine:
            seen: list[int] = []
            config = CeilingConfig("random-3", grid=4, num_scenes=10)
            ceiling = measure_ceiling(config, engine, seen.append)
            shares[num_workers] = ceiling.num_solvable
            assert seen[-1] == ceiling.num_scenes == 10
            assert ceiling.interval[0] <= ceiling.share <= ceiling.interval[1]
    assert shares[1] == shares[2] < 10


def test_the_command(capsys: pytest.CaptureFixture[str]) -> None:
    options = ["--scenario", "fixed-2", "--grid", "16", "--scenes", "2", "--workers", "1"]
    assert main(["ceiling", *options, "--json"]) == 0
    result = json.loads(capsys.readouterr().out)
    assert (result["num_solvable"], result["share"]) == (2, 1.0)
    assert result["interval_95"][0] == pytest.approx(0.342, abs=1e-3)
    assert main(["ceiling", *options]) == 0
    assert "solves 100.0% of 2 scenes" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("options", "text"),
    [
        (["--grid", "0"], "grid: 0 is not allowed"),
        (["--scenes", "0"], "scenes: 0 is not allowed"),
        (["--seed", "-1"], "seed: -1 is not allowed"),
        (["--scenario", "moon-2"], "moon-2"),
        (["--goal-separation", "0"], "goal_separation"),
    ],
)
def test_bad_options_are_one_line(
    options: list[str], text: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["ceiling", *options]) == 2
    error = capsys.readouterr().err
    assert text in error and error.count("\n") == 1
