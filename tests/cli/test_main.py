import subprocess
import sys
from pathlib import Path

import pytest

from singulate.cli import COMMANDS, main
from singulate.cli.runs import CONTROLS


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


PLAIN = [(name,) for name in COMMANDS if name not in ("app", "runs")]
OF_RUNS = [("runs", name) for name in ("list", "show", "export", "delete", *CONTROLS)]


@pytest.mark.parametrize("words", [*PLAIN, *OF_RUNS], ids=" ".join)
def test_every_command_has_help_and_speaks_json(
    words: tuple[str, ...], capsys: pytest.CaptureFixture[str]
) -> None:
    assert _status(*words, "--help") == 0
    assert "--json" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        ((), "COMMAND"),
        (("fly",), "fly"),
        (("train",), "--agent is missing: one of dqn, ppo"),
        (("train", "--agent", "a2c"), "'a2c'"),
        (("train", "--agent", "dqn", "--scenario", "moon-2"), "moon-2"),
        (("train", "--agent", "dqn", "--steps", "many"), "'many' is not allowed; allowed: a whole"),
        (
            ("evaluate", "random", "--goal-separation", "far"),
            "'far' is not allowed; allowed: a num",
        ),
        (("runs", "export", "run", "--out", ""), "--out: '' is not allowed; allowed: a path"),
        (("bench", "env", "--page", "nowhere.md"), "page: 'nowhere.md' is not allowed"),
        (("bench", "env", "--page", "README.md"), "Markdown with lines like"),
        (("bench", "env", "--page", "docs/performance.md"), "numbers: 'rewardmap' is not allowed"),
        (("train", "--agent", "dqn", "--steps", "0"), "steps"),
        (("train", "--agent", "dqn", "--action", "point"), "grid for dqn"),
        (("train", "--agent", "dqn", "--set", "depth=3"), "depth"),
        (("train", "--agent", "dqn", "--set", "gamma"), "KEY=VALUE"),
        (("train", "--agent", "dqn", "--set", "gamma=" + "[" * 100_000), "gamma"),
        (("train", "--resume", "nowhere"), "nowhere"),
        (("train", "--resume", "nowhere", "--agent", "dqn"), "nothing beside --resume"),
        (("train", "--config", "nowhere.json"), "nowhere.json"),
        (("train", "--config", "nowhere.json", "--steps", "5"), "nothing beside --config"),
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


def test_a_reader_that_has_left_is_no_traceback(tmp_path: Path) -> None:
    command = [sys.executable, "-m", "singulate", "runs", "list", "--runs-dir", str(tmp_path)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
        assert process.stdout is not None and process.stderr is not None
        process.stdout.close()
        assert process.stderr.read() == b""
    assert process.returncode == 2
