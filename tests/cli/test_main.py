import subprocess
import sys

import pytest

from singulate.cli import COMMANDS, main


def _status(*arguments: str) -> int:
    """Exit status, whether `main` returns it or argparse raises it."""
    try:
        return main(arguments)
    except SystemExit as end:
        return int(end.code or 0)


def test_help_lists_every_command_without_loading_torch() -> None:
    code = (
        "import sys\nfrom singulate.cli import main\n"
        "try:\n    main(['--help'])\nexcept SystemExit: pass\n"
        "sys.exit('torch' in sys.modules)"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=60)
    assert done.returncode == 0
    assert all(name in done.stdout for name in COMMANDS)


@pytest.mark.parametrize("name", [name for name in COMMANDS if name != "app"])
def test_every_command_has_help(name: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert _status(name, "--help") == 0
    assert "--json" in capsys.readouterr().out or name == "runs"


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        ((), "COMMAND"),
        (("fly",), "fly"),
        (("train",), "agent: None is not allowed; allowed: dqn, ppo"),
        (("train", "--agent", "a2c"), "'a2c'"),
        (("train", "--agent", "dqn", "--scenario", "moon-2"), "moon-2"),
        (("train", "--agent", "dqn", "--steps", "many"), "many"),
        (("train", "--agent", "dqn", "--steps", "0"), "steps"),
        (("train", "--agent", "dqn", "--action", "point"), "grid for dqn"),
        (("train", "--agent", "dqn", "--set", "depth=3"), "depth"),
        (("train", "--agent", "dqn", "--set", "gamma"), "KEY=VALUE"),
        (("train", "--resume", "nowhere"), "nowhere"),
        (("train", "--resume", "nowhere", "--agent", "dqn"), "nothing beside --resume"),
        (("train", "--config", "nowhere.json"), "nowhere.json"),
        (("evaluate", "nowhere"), "nowhere"),
        (("evaluate", "random", "--episodes", "0"), "episodes"),
        (("evaluate", "random", "--goal-separation", "nan"), "goal_separation"),
    ],
)
def test_bad_input_is_one_line_and_status_2(
    arguments: tuple[str, ...], said: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert _status(*arguments) == 2
    captured = capsys.readouterr()
    assert captured.out == ""
    assert captured.err.startswith("singulate: error: ")
    assert captured.err.count("\n") == 1
    assert said in captured.err


def test_app_passes_its_options_on() -> None:
    command = [sys.executable, "-m", "singulate", "app", "--help"]
    done = subprocess.run(command, capture_output=True, text=True, timeout=60)
    assert done.returncode == 0
    assert "python -m app" in done.stdout
