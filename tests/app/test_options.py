"""The command line of the dashboard, as a library and as a program."""

import subprocess
import sys
from pathlib import Path

import pytest

from app.options import Options, parse_options
from app.server import bind
from singulate.exceptions import InvalidValueError


def test_defaults_are_safe() -> None:
    assert parse_options([]) == Options()
    assert Options().host == "127.0.0.1"
    assert Options().token is None


def test_a_generated_token_is_long_and_new_every_time() -> None:
    first, second = (parse_options(["--token", "auto"]).token for _ in range(2))
    assert first is not None
    assert len(first) >= 16
    assert first != second


@pytest.mark.parametrize("host", ["0.0.0.0", "::", "192.168.1.7", "example.com"])
def test_addresses_that_others_can_reach_need_a_token(host: str) -> None:
    with pytest.raises(InvalidValueError, match="--token auto"):
        parse_options(["--host", host])
    assert parse_options(["--host", host, "--token", "long-enough"]).host == host


def test_any_scenario_can_be_opened_with_a_mix_too() -> None:
    assert parse_options(["--scenario", "fixed-2+cluster-5"]).scenario == "fixed-2+cluster-5"


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["--port", "70000"], "--port"),
        (["--seed", "-1"], "--seed"),
        (["--token", "short"], "--token"),
        (["--token", "with space and&sign"], "--token"),
        (["--scenario", "random-99"], "scenario"),
        (["--run", "no/such/directory"], "--run"),
    ],
)
def test_bad_values_are_one_line(arguments: list[str], said: str) -> None:
    with pytest.raises(InvalidValueError, match=f"^{said}: ") as refused:
        parse_options(arguments)
    assert "\n" not in str(refused.value)


@pytest.mark.parametrize("arguments", [["--port", "high"], ["--colour", "red"], ["--run"]])
def test_what_cannot_be_parsed_is_one_line_and_status_2(
    arguments: list[str], capsys: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises(SystemExit) as left:
        parse_options(arguments)
    assert left.value.code == 2
    said = capsys.readouterr().err
    assert said.startswith("singulate: error: ") and said.count("\n") == 1
    assert arguments[0] in said


def test_a_busy_port_ends_the_program_with_one_line_and_status_2() -> None:
    with bind("127.0.0.1", 0) as listener:
        port = listener.getsockname()[1]
        command = [sys.executable, "-m", "app", "--port", str(port)]
        root = Path(__file__).parents[2]
        done = subprocess.run(command, capture_output=True, text=True, cwd=root, timeout=60)
    assert done.returncode == 2
    assert done.stdout == ""
    assert done.stderr.startswith("singulate: error: --port")
    assert done.stderr.count("\n") == 1
