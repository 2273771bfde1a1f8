import json
import shutil
from pathlib import Path

import numpy as np
import pytest
from gymnasium.utils.env_checker import check_env

from singulate.checkpoints.reading import read_manifest
from singulate.cli import main
from singulate.datasets import RecordedScenes
from singulate.datasets.recorded_env import RecordedPushEnv, recorded_env_config
from singulate.envs import PushEnv
from singulate.geometry import Direction
from singulate.rewards import make_reward
from singulate.runs import RunReader

SMALL = ("--agent", "dqn", "--set", "learning_starts=5", "--set", "batch_size=8")
NET = ("--set", "net_arch=[8]")


def open_env(dataset: Path, action: str = "grid") -> RecordedPushEnv:
    scenes = RecordedScenes(dataset)
    return RecordedPushEnv(scenes, recorded_env_config(scenes, "distance_map", action))


@pytest.mark.parametrize("action", ["grid", "point"])
def test_it_is_a_proper_environment(dataset: Path, action: str) -> None:
    check_env(open_env(dataset, action), skip_render_check=True)


def test_it_answers_as_the_simulated_one_does(dataset: Path) -> None:
    env, real = open_env(dataset), PushEnv(action="grid")
    exact = 0
    rng = np.random.default_rng(0)
    for seed in range(40):
        observation, _ = env.reset(seed=seed)
        assert env._scene is not None
        expected, _ = real.reset(seed=env._scene.seed)
        np.testing.assert_array_equal(observation, expected)
        action = int(rng.integers(400))
        _, reward, terminated, truncated, info = env.step(action)
        _, real_reward, *_, real_info = real.step(action)
        assert (terminated, truncated) == (True, False)
        assert info["push"].start == pytest.approx(real_info["push"].start)
        assert info["poses_before"] == real_info["poses_before"]
        weighted = make_reward("paper").total(info["reward_terms"])
        assert weighted == pytest.approx(reward)
        exact += abs(reward - real_reward) < 0.5
        assert info["push"].nearest_direction == action // 100
    assert exact >= 36  # all but pushes whose outcome a millimetre decides
    real.close()


def test_a_push_is_answered_for_the_nearest_start(dataset: Path) -> None:
    env = open_env(dataset, "point")
    env.reset(seed=1)
    scene = env._scene
    assert scene is not None
    _, reward, *_, info = env.step(np.array([0.04, -0.57, 0.3], np.float32))
    assert reward == scene.reward_map[Direction.DOWN, 7, 5]
    assert info["push"].start == pytest.approx((0.1, -0.5))


def test_an_agent_learns_offline_and_goes_on_exactly(
    dataset: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    whole, halves = str(tmp_path / "whole"), str(tmp_path / "halves")
    options = ["train", *SMALL, *NET, "--dataset", str(dataset), "--json"]
    assert main([*options, "--steps", "40", "--run-dir", whole]) == 0
    assert main([*options, "--steps", "20", "--run-dir", halves]) == 0
    assert main(["train", "--resume", halves, "--steps", "40", "--json"]) == 0
    checkpoints = [Path(run) / "checkpoints" / "step-000000040" for run in (whole, halves)]
    first, second = (read_manifest(path).files for path in checkpoints)
    assert first["weights.safetensors"] == second["weights.safetensors"]
    assert RunReader(Path(whole)).count_pushes() == 40
    capsys.readouterr()
    assert main(["evaluate", whole, "--episodes", "2", "--workers", "1", "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["max_pushes"] == 1


def test_a_run_goes_on_with_its_own_data_set_only(
    dataset: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    copy, run_dir = tmp_path / "copy", str(tmp_path / "run")
    shutil.copytree(dataset, copy)
    options = [*SMALL, *NET, "--dataset", str(copy), "--steps", "10", "--run-dir", run_dir]
    assert main(["train", *options]) == 0
    shutil.rmtree(copy)
    assert main(["train", "--resume", run_dir, "--steps", "20"]) == 2
    assert "holds no data set" in capsys.readouterr().err
    sizes = ["--scenes", "1", "--resolution", "4", "--workers", "1"]
    assert main(["dataset", *sizes, "--out", str(copy)]) == 0
    assert main(["train", "--resume", run_dir, "--steps", "20"]) == 2
    assert "the data set that the run began with" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("options", "text"),
    [
        (["--scenario", "random-2"], "nothing beside --dataset"),
        (["--max-pushes", "2"], "nothing beside --dataset"),
        (["--agent", "ppo", "--action", "start_end"], "action: 'start_end' is not allowed"),
        (["--dataset", "/no/such"], "holds no data set"),
    ],
)
def test_what_a_data_set_cannot_answer_is_refused(
    options: list[str], text: str, dataset: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["train", "--agent", "dqn", "--dataset", str(dataset), *options]) == 2
    assert text in capsys.readouterr().err
