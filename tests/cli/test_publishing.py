import json
import shlex
from pathlib import Path

import pytest

import singulate
from singulate.agents.registry import agent_kind
from singulate.checkpoints import verify_checkpoint
from singulate.cli import main
from singulate.cli.lists import parse_setting
from singulate.cli.publishing import train_command
from singulate.envs import EnvConfig
from singulate.paths import shipped_checkpoints_directory
from singulate.training.config import TrainingConfig


def test_a_published_checkpoint_is_small_and_says_what_was_measured(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    run_dir, published = tmp_path / "run", tmp_path / "checkpoints" / "mine"
    options = ("--steps", "20", "--set", "net_arch=[16]", "--set", "learning_starts=5")
    assert main(["train", "--agent", "dqn", *options, "--run-dir", str(run_dir)]) == 0
    capsys.readouterr()
    arguments = ["evaluate", str(run_dir), "--episodes", "6", "--workers", "1", "--json"]
    assert main([*arguments, "--publish", str(published)]) == 0
    measured = json.loads(capsys.readouterr().out)
    manifest = verify_checkpoint(published)
    assert list(manifest.files) == ["weights.safetensors"]
    assert manifest.notes["measured"]["greedy"]["success_rate"] == measured["success_rate"]
    readme = (published / "README.md").read_text()
    assert str(manifest.notes["command"]) in readme
    assert "random pushes" in readme
    assert f'load_policy("{published}")' in readme
    assert singulate.load_policy(published).kind == "dqn"
    assert main([*arguments, "--publish", str(published)]) == 2
    assert "--overwrite" in capsys.readouterr().err
    first = run_dir / "checkpoints" / "step-000000000"
    again = ["evaluate", str(first), *arguments[2:], "--publish", str(published), "--overwrite"]
    assert main(again) == 0
    assert "the checkpoint after 0 pushes" in (published / "README.md").read_text()


def test_only_a_run_can_be_published_from(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["evaluate", "random", "--episodes", "1", "--publish", str(tmp_path / "x")]) == 2
    assert "only a run's checkpoint" in capsys.readouterr().err


@pytest.mark.parametrize(
    "option",
    [
        ("--scenario", "random-3"),
        ("--reward", "start"),
        ("--max-pushes", "2"),
        ("--goal-separation", "0.05"),
    ],
)
def test_what_is_published_is_measured_on_the_own_task(
    option: tuple[str, str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["evaluate", "any", *option, "--publish", str(tmp_path / "mine")]) == 2
    error = capsys.readouterr().err
    assert error.startswith(f"singulate: error: {option[0]}: ")
    assert "nothing beside --publish" in error
    assert error.count("\n") == 1


@pytest.mark.parametrize(
    ("target", "said"),
    [("thesis", "not a checkpoint"), ("thesis/chapter1.tex", "not a checkpoint")],
)
def test_a_target_that_cannot_be_used_is_found_first(
    target: str, said: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "thesis").mkdir()
    (tmp_path / "thesis" / "chapter1.tex").touch()
    assert main(["evaluate", "missing", "--publish", str(tmp_path / target)]) == 2
    assert said in capsys.readouterr().err
    assert main(["evaluate", "missing", "--publish", "/proc/mine"]) == 2
    assert "can be written" in capsys.readouterr().err


def test_the_command_names_what_is_not_default_and_can_be_typed() -> None:
    env = EnvConfig("random-3", observation="mask", action="grid", max_pushes=2)
    settings = {"net_arch": [8, 8], "symmetric_values": True, "tau": 0.5}
    config = TrainingConfig("dqn", env, 500, seed=4, agent_config=settings)
    command = train_command(config)
    assert command == (
        "singulate train --agent dqn --scenario random-3 --steps 500 --seed 4 "
        "--observation mask --max-pushes 2 --set 'net_arch=[8,8]' --set tau=0.5 "
        "--set symmetric_values=true"
    )
    words = shlex.split(command)
    options = [words[i + 1] for i, word in enumerate(words) if word == "--set"]
    typed = dict(parse_setting("--set", option) for option in options)
    assert TrainingConfig("dqn", env, 500, seed=4, agent_config=typed) == config


def test_the_command_of_an_offline_run_names_its_data_and_environments() -> None:
    env = EnvConfig("random-3", action="grid", max_pushes=1, reward="start")
    config = TrainingConfig(
        "dqn", env, 500, num_envs=4, dataset="/data/my set", dataset_sha256="0" * 64
    )
    assert train_command(config) == (
        "singulate train --agent dqn --dataset '/data/my set' --steps 500 --seed 0 --envs 4"
    )


def test_commands_of_shipped_checkpoints_can_be_typed() -> None:
    for manifest in map(verify_checkpoint, sorted(shipped_checkpoints_directory().iterdir())):
        words = shlex.split(str(manifest.notes["command"]))
        options = [words[i + 1] for i, word in enumerate(words) if word == "--set"]
        typed = dict(parse_setting("--set", option) for option in options)
        made = agent_kind(manifest.agent).make_config(typed)
        stored = agent_kind(manifest.agent).make_config(manifest.agent_config)
        assert made == stored, manifest.notes["command"]
