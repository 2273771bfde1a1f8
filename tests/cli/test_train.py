import json
import re
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from singulate.cli import main
from singulate.runs import RunDirectory, RunReader, read_status

SMALL = ("--set", "learning_starts=5", "--set", "batch_size=8", "--set", "net_arch=[16]")


def test_train_resume_and_evaluate(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    run_dir = str(tmp_path / "run")
    options = ("--agent", "dqn", "--scenario", "random-2", "--steps", "20", "--seed", "1", *SMALL)
    assert main(["train", *options, "--run-dir", run_dir, "--json"]) == 0
    first = json.loads(capsys.readouterr().out)
    assert (first["state"], first["num_steps"]) == ("finished", 20)
    resume = ("--resume", run_dir, "--steps", "30", "--workers", "0")
    assert main(["train", *resume, "--json"]) == 0
    assert RunDirectory(tmp_path / "run").read_config()["num_workers"] == 0
    second = json.loads(capsys.readouterr().out)
    assert second["checkpoint"].endswith("step-000000030")
    assert main(["train", "--resume", run_dir, "--steps", "29"]) == 2
    assert "--steps: 29 is not allowed; allowed: 30 or more" in capsys.readouterr().err
    assert RunDirectory(tmp_path / "run").read_config()["total_timesteps"] == 30
    assert main(["train", "--resume", run_dir]) == 0
    assert "Finished after 30 pushes, none of them now." in capsys.readouterr().out

    arguments = ["evaluate", run_dir, "--episodes", "12", "--workers", "1"]
    assert main([*arguments, "--json"]) == 0
    result = json.loads(capsys.readouterr().out)
    assert result["scenario"] == "random-2"
    assert result["num_episodes"] == 12
    low, high = result["success_interval_95"]
    assert low <= result["success_rate"] <= high
    assert set(result["mean_reward_by_term"]) == {"start", "distance", "inside", "success"}
    assert sum(result["failures"].values()) + result["num_successes"] == 12
    assert main(arguments) == 0
    assert "95 % interval" in capsys.readouterr().out


def test_a_run_without_a_name_is_named_by_time_agent_and_scenario(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("SINGULATE_RUNS", str(tmp_path))
    options = ("--agent", "dqn", "--scenario", "fixed-2", "--steps", "2", *SMALL)
    assert main(["train", *options]) == 0
    (run_dir,) = tmp_path.iterdir()
    assert re.fullmatch(r"\d{8}-\d{6}-dqn-fixed-2", run_dir.name)


def test_an_existing_run_is_not_touched(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    RunDirectory(tmp_path).create({"mine": True})
    assert main(["train", "--agent", "dqn", "--steps", "5", "--run-dir", str(tmp_path)]) == 2
    assert "holds a run already" in capsys.readouterr().err
    assert RunDirectory(tmp_path).read_config() == {"mine": True}


def test_ctrl_c_saves_a_checkpoint_and_exits_with_130(tmp_path: Path) -> None:
    command = [sys.executable, "-m", "singulate", "train", "--agent", "dqn", "--steps", "100000"]
    command += [*SMALL, "--run-dir", str(tmp_path / "run")]
    with subprocess.Popen(command, stdout=subprocess.DEVNULL) as process:
        try:
            deadline = time.monotonic() + 60.0
            while RunReader(tmp_path / "run").last_step() < 10:
                assert time.monotonic() < deadline and process.poll() is None
                time.sleep(0.05)
            process.send_signal(signal.SIGINT)
            assert process.wait(timeout=30) == 130
        finally:
            process.kill()  # a training that failed the test does not go on behind it
    assert read_status(tmp_path / "run").state == "stopped"
    newest = RunDirectory(tmp_path / "run").latest_checkpoint()
    assert newest is not None and newest.name != "step-000000000"


def test_every_option_reaches_the_run_and_its_configuration_repeats_it(tmp_path: Path) -> None:
    first, again = RunDirectory(tmp_path / "first"), RunDirectory(tmp_path / "again")
    env = {
        "scenario": "cluster-3", "observation": "mask", "action": "grid", "reward": "start",
        "max_pushes": 2, "goal_separation": 0.2,
    }  # fmt: skip
    own = {"seed": 3, "num_envs": 2, "num_workers": 0, "checkpoint_every": 6}
    options = {name.removeprefix("num_"): value for name, value in {**env, **own}.items()}
    command = ["train", "--agent", "dqn", "--steps", "12", *SMALL]
    for name, value in options.items():
        command += ["--" + name.replace("_", "-"), str(value)]
    assert main([*command, "--run-dir", str(first.path)]) == 0
    config = first.read_config()
    assert config["env"] == env | {"exact": False}
    assert {name: config[name] for name in own} == own
    assert (config["agent"], config["agent_config"]["net_arch"]) == ("dqn", [16])
    names = sorted(path.name for path in first.checkpoints_path.iterdir())
    assert names == [f"step-{step:09d}" for step in (0, 6, 12)]

    repeat = ["--config", str(first.config_path), "--run-dir", str(again.path)]
    assert main(["train", *repeat]) == 0
    assert again.read_config() == config
    for weights in first.checkpoints_path.glob("*/weights.safetensors"):
        assert (again.path / weights.relative_to(first.path)).read_bytes() == weights.read_bytes()
